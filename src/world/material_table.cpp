#include "world/material_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "world/texture_hash.h"

namespace rt {

namespace {

template <typename T>
bool same(const T* a, const T* b) {
    return a == b || (a && b && *a == *b);
}

bool can_transmit(const std::vector<LayerNode>& layers) {
    bool any = false;
    for_each_layer(layers, [&](const LayerNode& layer) { any |= can_transmit(layer.pigment); });
    return any;
}

bool can_reflect(const std::vector<LayerNode>& layers) {
    bool any = false;
    for_each_layer(layers, [&](const LayerNode& layer) { any |= layer.finish.reflects; });
    return any;
}

bool uses_uv(const std::vector<LayerNode>& layers) {
    return std::any_of(layers.begin(), layers.end(), [](const LayerNode& layer) {
        if (!layer.textures) return uses_uv(layer.pigment) || (layer.normal && uses_uv(*layer.normal));
        const auto& entries = layer.textures->entries;
        return uses_uv(layer.textures->pattern) ||
               std::any_of(entries.begin(), entries.end(), [](const std::vector<LayerNode>& entry) { return uses_uv(entry); });
    });
}

}  // namespace

/// Whether the surface reflects, by the finish or by the model's surroundings, and what it needs for that.
void MaterialTable::choose_mirror(SurfaceFinish& surface, const Span& span) {
    const Reflection& stated = surface.finish.reflection;
    surface.reflects = stated.min != Rgb(0.0) || stated.max != Rgb(0.0);
    SurfaceModel& model = surface.model;
    if (model.env == Surroundings::finish) return;
    if (surface.reflects && !warned_reflection_) {
        warned_reflection_ = true;
        warn_(scene_.sources.describe(
            span, "Warning",
            "The choice of 'env' replaces the 'reflection' of the finish, here and maybe in further finishes; env=finish keeps it."));
    }
    surface.reflects = model.s > 0.0;
    if (model.env != Surroundings::albedo || !surface.reflects || model.alpha < AlbedoTable::least_alpha) return;
    const auto same = [&](const KnownAlbedo& known) {
        const MicrofacetTerms &a = known.terms, &b = model.terms;
        return a.D == b.D && a.G == b.G && a.F == b.F && known.alpha == model.alpha &&
               std::equal(std::begin(known.interface), std::end(known.interface), std::begin(model.interface));
    };
    auto known = std::find_if(albedos_.begin(), albedos_.end(), same);
    if (known == albedos_.end()) {
        KnownAlbedo made{model.terms, {}, model.alpha, std::make_shared<AlbedoTable>(model.terms, model.interface, model.alpha)};
        std::copy(std::begin(model.interface), std::end(model.interface), made.interface);
        known = albedos_.insert(albedos_.end(), std::move(made));
    }
    model.albedo = known->table;
}

SurfaceFinish MaterialTable::make_finish(const Finish& finish, double ior, const Span& span) {
    SurfaceFinish surface;
    surface.finish = finish;
    const double roughness = finish.roughness.value_or(0.05);
    surface.specular_exponent = roughness == 0.0 ? 0.0 : 1.0 / roughness;
    const ModelChoice choice = options_.choose ? options_.choose(finish) : ModelChoice{};
    surface.model = fill(choice, finish, ior, options_.alpha);
    choose_mirror(surface, span);
    if (surface.model.lecture) surface.finish.diffuse = lecture_diffuse(grey(finish.ambient), surface.model.s);
    if (options_.general_shading) warn_of_range(surface, choice.s.has_value(), span);
    return surface;
}

void MaterialTable::warn_of_range(const SurfaceFinish& surface, bool share_stated, const Span& span) {
    const bool microfacet = surface.model.specular == SurfaceModel::Specular::microfacet;
    if (microfacet && surface.model.alpha > 1.0 && surface.model.s > 0.0 && !warned_alpha_) {
        warned_alpha_ = true;
        warn_(scene_.sources.describe(
            span, "Warning",
            fmt::format("The microfacet alpha is {:.3g}, wider than 1, here and maybe in further finishes.", surface.model.alpha)));
    }
    const double specular = surface.finish.specular;
    if (microfacet && surface.model.shares && !share_stated && (specular < 0.0 || specular > 1.0) && !warned_specular_) {
        warned_specular_ = true;
        warn_(scene_.sources.describe(
            span, "Warning",
            "'specular' is used as the share of light that the microfacet term takes; clamped to 0..1 here and in all further finishes."));
    }
}

LayerNode MaterialTable::make_layer(const Texture& texture, double ior, bool uv, const Span& span) {
    LayerNode node;
    if (const auto* plain = std::get_if<PlainTexture>(&texture.content)) {
        uv |= plain->uv_mapping;
        node.pigment = compile_pigment(plain->pigment, defaults_, uv);
        nodes_ += node.pigment.size();
        node.finish = make_finish(plain->finish, ior, span);
        if (plain->normal) node.normal = std::make_shared<const NormalNode>(compile_normal(**plain->normal, defaults_, uv));
        return node;
    }
    const PatternTexture& stated = *std::get<Shared<PatternTexture>>(texture.content);
    const auto made = std::make_shared<TextureNode>();
    made->pattern = compile_pattern(stated.pattern, defaults_, uv);
    made->pattern.values = stated.map->values;
    uv &= !made->pattern.uv_mapping;
    for (const TextureLayers& entry : stated.map->textures) made->entries.push_back(make_layers(*entry, ior, uv, span));
    node.textures = made;
    return node;
}

std::vector<LayerNode> MaterialTable::make_layers(const std::vector<Texture>& layers, double ior, bool uv, const Span& span) {
    std::vector<LayerNode> nodes;
    nodes.reserve(layers.size());
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) nodes.push_back(make_layer(*layer, ior, uv, span));
    return nodes;
}

Material MaterialTable::make(const Origin& origin, const Span& span) {
    Material material;
    if (origin.texture && !origin.shape_textures) material.layers = make_layers(**origin.texture, origin.ior, origin.uv_mapping, span);
    if (origin.interior_texture) material.interior_layers = make_layers(**origin.interior_texture, origin.ior, origin.uv_mapping, span);
    // Beyond what the file shares, each index of refraction makes materials of its own.
    if (nodes_ > max_nodes_ + materials_.size() + 1)
        throw LimitError(scene_.sources.describe(
            span, "Error",
            fmt::format("The scene's materials have more than {} pigments beyond the first of each. --limit textures=N allows more.",
                        max_nodes_)));
    material.can_transmit = can_transmit(material.layers) || can_transmit(material.interior_layers);
    material.can_reflect = can_reflect(material.layers) || can_reflect(material.interior_layers);
    material.uses_uv = uses_uv(material.layers) || uses_uv(material.interior_layers);
    if (origin.shape_textures) add_shape_textures(origin, span, material);
    return material;
}

void MaterialTable::add_shape_textures(const Origin& origin, const Span& span, Material& material) {
    const auto add_one = [&](const TextureLayers* layers) {
        const std::uint32_t index = add({layers, nullptr, origin.ior, origin.uv_mapping, nullptr, 0}, span);
        material.shape_textures.push_back(index);
        const Material& texture = materials_[index];
        material.can_transmit |= texture.can_transmit;
        material.can_reflect |= texture.can_reflect;
        material.uses_uv |= texture.uses_uv;
    };
    material.shape_textures.reserve(origin.shape_textures->size() + 1);
    for (const TextureLayers& layers : *origin.shape_textures) add_one(&layers);
    add_one(origin.texture);
}

std::size_t MaterialTable::hash(const TextureLayers& layers) {
    const auto known = hashes_.find(layers.identity());
    if (known != hashes_.end()) return known->second;
    const std::size_t hash = content_hash(*layers);
    const auto* only = layers->size() == 1 ? std::get_if<PlainTexture>(&layers->front().content) : nullptr;
    if (!only || !std::holds_alternative<PigmentColor>(only->pigment.content)) hashes_.emplace(layers.identity(), hash);
    return hash;
}

std::uint32_t MaterialTable::add(const Object& object) {
    const std::optional<double> stated = stated_ior(object);
    return add({object.texture ? &*object.texture : nullptr, object.interior_texture ? &*object.interior_texture : nullptr,
                stated && *stated > 0.0 ? *stated : 1.5, object.uv_mapping, object.shape_textures ? &**object.shape_textures : nullptr, 0},
               object.span);
}

std::uint32_t MaterialTable::add(Origin origin, const Span& span) {
    Hash hash;
    hash << origin.ior;
    hash.mix(origin.uv_mapping);
    for (const TextureLayers* layers : {origin.texture, origin.interior_texture})
        if (layers) hash.mix(this->hash(*layers));
    if (origin.shape_textures)
        for (const TextureLayers& layers : *origin.shape_textures) hash.mix(this->hash(layers));
    const auto [begin, end] = by_content_.equal_range(hash.value());
    for (auto it = begin; it != end; ++it) {
        const Origin& known = it->second;
        if (known.ior == origin.ior && known.uv_mapping == origin.uv_mapping && same(known.texture, origin.texture) &&
            same(known.interior_texture, origin.interior_texture) && same(known.shape_textures, origin.shape_textures))
            return known.material;
    }
    Material material = make(origin, span);
    origin.material = static_cast<std::uint32_t>(materials_.size());
    materials_.push_back(std::move(material));
    by_content_.emplace(hash.value(), origin);
    return origin.material;
}

const Finish* legacy_finish(const Object& object) {
    if (!object.texture || (*object.texture)->empty()) return nullptr;
    const auto* top = std::get_if<PlainTexture>(&(*object.texture)->back().content);
    return top ? &top->finish : nullptr;
}

std::optional<double> stated_ior(const Object& object) {
    if (const Finish* finish = legacy_finish(object); finish && finish->ior) return finish->ior;
    return object.interior ? (*object.interior)->ior : std::nullopt;
}

CompiledInterior compile_interior(const Object& object) {
    CompiledInterior compiled;
    if (object.interior) {
        const Interior& stated = **object.interior;
        compiled = {stated.ior.value_or(1.0), stated.caustics, stated.fade_distance, stated.fade_power, stated.fade_color, 1.0, false};
    }
    if (const Finish* finish = legacy_finish(object)) {
        compiled.ior = finish->ior.value_or(compiled.ior);
        compiled.caustics = finish->caustics.value_or(compiled.caustics);
        compiled.refraction = finish->refraction.value_or(1.0);
    }
    compiled.hollow = object.hollow;
    if (compiled.ior == 0.0) compiled.ior = 1.0;  // as POV-Ray reads it
    return compiled;
}

}  // namespace rt
