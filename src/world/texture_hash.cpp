#include "world/texture_hash.h"

namespace rt {

namespace {

void hash_color(Hash& hash, const PigmentColor& c) { hash << c.rgb << c.filter << c.transmit; }

void hash_optional(Hash& hash, const std::optional<double>& x) { hash.mix(x.has_value()) << x.value_or(0.0); }

void hash_pigment(Hash& hash, const Pigment& pigment);

void hash_turbulence(Hash& hash, const Turbulence& t) { hash << t.amount << t.octaves << t.omega << t.lambda; }

void hash_warp(Hash& hash, const Transform& t) { hash << t.linear[0] << t.linear[1] << t.linear[2] << t.offset; }
void hash_warp(Hash& hash, const Turbulence& t) { hash_turbulence(hash, t); }
void hash_warp(Hash& hash, const RepeatWarp& w) { hash << w.axis << w.width << w.offset << w.flip; }
void hash_warp(Hash& hash, const BlackHoleWarp& w) {
    hash << w.center << w.radius << w.strength << w.falloff << w.inverse << w.repeat << w.turbulence;
}
void hash_warp(Hash& hash, const MappingWarp& w) {
    hash << static_cast<double>(w.kind) << w.orientation << w.distance_exponent << w.major_radius << w.distance;
}
void hash_warp(Hash&, const CubicWarp&) {}

void hash_picture(Hash& hash, const ImageMapping& m, int width, int height) {
    hash << m.type << m.interpolate << m.once << m.offset.x << m.offset.y << m.repeat.x << m.repeat.y << width << height;
}

void hash_numbers(Hash&, std::monostate) {}
void hash_numbers(Hash& hash, const AgateNumbers& n) { hash << n.turbulence; }
void hash_numbers(Hash& hash, const BrickNumbers& n) { hash << n.size << n.mortar; }
void hash_numbers(Hash& hash, const CrackleNumbers& n) { hash << n.metric << n.offset << n.form << n.solid; }
void hash_numbers(Hash& hash, const GradientNumbers& n) { hash << n.direction; }
void hash_numbers(Hash& hash, const FractalNumbers& n) {
    hash << n.magnet << n.julia << n.c.x << n.c.y << n.iterations << n.exponent << n.exterior << n.exterior_factor << n.interior
         << n.interior_factor;
}
void hash_numbers(Hash& hash, const QuiltedNumbers& n) { hash << n.control0 << n.control1; }
void hash_numbers(Hash& hash, const FacetsNumbers& n) { hash << n.size << n.coords << n.metric; }
void hash_numbers(Hash& hash, const SlopeNumbers& n) {
    hash << n.slope << n.slope_range.x << n.slope_range.y << n.altitude << n.altitude_range.x << n.altitude_range.y;
}
void hash_numbers(Hash& hash, const SpiralNumbers& n) { hash << n.arms; }
void hash_numbers(Hash& hash, const WavesNumbers& n) { hash << static_cast<double>(n.sources->size()); }
// Of pictures and densities the size has to do: to read their values would cost more than a comparison now and then.
void hash_numbers(Hash& hash, const DensityNumbers& n) { hash << n.grid->width << n.grid->height << n.grid->depth << n.interpolate; }
void hash_numbers(Hash& hash, const ImageNumbers& n) { hash_picture(hash, n.mapping, n.grid->width, n.grid->height); }

void hash_source(Hash& hash, const PatternSource& source) {
    if (const auto* pigment = std::get_if<Shared<Pigment>>(&source)) hash_pigment(hash, **pigment);
    if (const auto* function = std::get_if<std::shared_ptr<const Function>>(&source))
        hash.mix(std::hash<std::shared_ptr<const Function>>()(*function));
}

void hash_pattern(Hash& hash, const StatedPattern& stated) {
    const Pattern& p = stated.pattern;
    hash << static_cast<double>(p.kind) << static_cast<double>(p.noise) << static_cast<double>(p.wave) << p.frequency << p.phase
         << p.wave_exponent << static_cast<double>(p.warps.size()) << stated.uv_mapping;
    std::visit([&](const auto& numbers) { hash_numbers(hash, numbers); }, p.numbers);
    for (const Warp& warp : p.warps) std::visit([&](const auto& w) { hash_warp(hash, w); }, warp);
    if (p.turbulence) hash_turbulence(hash, *p.turbulence);
    hash_source(hash, stated.source);
}

void hash_values(Hash& hash, const std::vector<double>& values) {
    for (const double value : values) hash << value;
}

void hash_pigment(Hash& hash, const Pigment& pigment) {
    if (pigment.transform) hash_warp(hash, *pigment.transform);
    if (pigment.quick_color) hash_color(hash, *pigment.quick_color);
    if (const auto* color = std::get_if<PigmentColor>(&pigment.content)) return hash_color(hash, *color);
    const PatternPigment& patterned = *std::get<Shared<PatternPigment>>(pigment.content);
    hash_pattern(hash, patterned.pattern);
    if (const auto* colors = std::get_if<Shared<ColorMap>>(&patterned.map)) {
        hash_values(hash, (*colors)->values);
        for (const PigmentColor& color : (*colors)->colors) hash_color(hash, color);
    } else if (const auto* pigments = std::get_if<Shared<PigmentMap>>(&patterned.map)) {
        hash_values(hash, (*pigments)->values);
        for (const Pigment& entry : (*pigments)->pigments) hash_pigment(hash, entry);
    } else if (const auto* image = std::get_if<Shared<ImageMap>>(&patterned.map)) {
        const ImageMap& map = **image;
        hash_picture(hash, map.mapping, map.image->width, map.image->height);
        hash << map.filter << map.transmit;
    }
}

void hash_normal(Hash& hash, const Normal& normal) {
    hash_pattern(hash, normal.pattern);
    hash << normal.bump.amount << normal.bump.accuracy << normal.bump.scale;
    for (const SlopeEntry& entry : normal.bump.slopes) hash << entry.value << entry.height << entry.slope;
    if (!normal.map) return;
    hash_values(hash, (*normal.map)->values);
    for (const Normal& entry : (*normal.map)->normals) hash_normal(hash, entry);
}

void hash_finish(Hash& hash, const Finish& f) {
    hash << f.ambient << f.emission << f.diffuse << f.diffuse_back << f.brilliance << f.phong << f.phong_size << f.specular << f.metallic
         << f.reflection.min << f.reflection.max << f.reflection.falloff << f.reflection.exponent << f.reflection.metallic << f.crand;
    hash.mix(f.reflection.fresnel).mix(f.conserve_energy);
    for (const std::optional<double>& x : {f.roughness, f.ior, f.refraction, f.caustics}) hash_optional(hash, x);
    if (f.irid) hash << f.irid->amount << f.irid->thickness << f.irid->turbulence;
    for (const SceneOption& option : f.options) hash.mix(option.span.file).mix(option.span.begin);
}

void hash_layers(Hash& hash, const std::vector<Texture>& layers) {
    hash.mix(layers.size());
    for (const Texture& texture : layers) {
        if (const auto* plain = std::get_if<PlainTexture>(&texture.content)) {
            hash_pigment(hash, plain->pigment);
            hash_finish(hash, plain->finish);
            hash.mix(plain->uv_mapping);
            if (plain->normal) hash_normal(hash, **plain->normal);
        } else {
            const PatternTexture& patterned = *std::get<Shared<PatternTexture>>(texture.content);
            hash_pattern(hash, patterned.pattern);
            hash_values(hash, patterned.map->values);
            for (const TextureLayers& entry : patterned.map->textures) hash_layers(hash, *entry);
        }
    }
}

}  // namespace

std::size_t content_hash(const std::vector<Texture>& layers) {
    Hash hash;
    hash_layers(hash, layers);
    return hash.value();
}

}  // namespace rt
