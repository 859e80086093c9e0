#include "syntax/texture_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

void add_cell(TreeSize& pattern, const TreeSize& cell) {
    pattern.nodes += cell.nodes;
    pattern.depth = std::max(pattern.depth, cell.depth + 1);
}

/// The size of what is stacked upon. Layers that were put on one by one are counted once each.
TreeSize size_below(Reader& reader, const TextureLayers& layers) {
    const Reader::CountedLayers& last = reader.counted_layers();
    return last.identity == layers.identity() ? TreeSize{last.nodes, last.depth} : tree_size(*layers);
}

}  // namespace

TextureLayers& layers_or_default(Reader& reader, std::optional<TextureLayers>& layers) {
    if (!layers) layers = reader.default_texture();
    return *layers;
}

PlainTexture& edit_top(Reader& reader, TextureLayers& layers) {
    if (is_patterned(layers)) reader.fail(reader.peek().span, "Cannot layer over a patterned texture.");
    return std::get<PlainTexture>(edit_all(reader, layers).back().content);
}

void stack(Reader& reader, const Span& place, std::optional<TextureLayers>& layers, const TextureLayers& upper) {
    if (!layers) {
        layers = upper;
        return;
    }
    if (is_patterned(*layers)) reader.fail(place, "Cannot layer over a patterned texture.");
    if (is_patterned(upper)) reader.fail(place, "Cannot layer a patterned texture over another.");
    const TreeSize lower_size = size_below(reader, *layers);
    const TreeSize upper_size = tree_size(*upper);
    const TreeSize size{lower_size.nodes + upper_size.nodes, std::max(lower_size.depth, upper_size.depth)};
    limit_size(reader, place, size);
    std::vector<Texture>& all = edit_all(reader, *layers);
    reader.count_scene_nodes(place, upper->size());
    all.insert(all.end(), upper->begin(), upper->end());
    reader.counted_layers() = {&all, size.nodes, size.depth};
}

std::vector<Texture>& edit_all(Reader& reader, TextureLayers& layers) {
    reader.counted_layers() = {};
    const std::vector<Texture>* const before = layers.identity();
    std::vector<Texture>& all = layers.edit();
    if (&all != before) reader.count_scene_nodes(reader.last_place(), all.size() - 1);
    return all;
}

namespace {

/// Pigments and normals that are seen at (u, v, 0) stay; whole textures do where it is their `object` that moves.
void transform_all(std::vector<Texture>& layers, const Transform& t, bool object) {
    const auto move = [&](StatedPattern& stated) {
        if (!stated.uv_mapping) append(stated.pattern, t);
    };
    for (Texture& layer : layers) {
        auto* plain = std::get_if<PlainTexture>(&layer.content);
        if (!plain) {
            StatedPattern& stated = std::get<Shared<PatternTexture>>(layer.content).edit().pattern;
            if (!(object && stated.uv_mapping)) append(stated.pattern, t);
            continue;
        }
        if (object && plain->uv_mapping) continue;
        if (auto* pattern = std::get_if<Shared<PatternPigment>>(&plain->pigment.content))
            move(pattern->edit().pattern);
        else
            append(plain->pigment.transform, t);
        if (plain->normal) move(plain->normal->edit().pattern);
    }
}

}  // namespace

void transform_layers(Reader& reader, TextureLayers& layers, const Transform& t) { transform_all(edit_all(reader, layers), t, false); }

void move_layers(Reader& reader, TextureLayers& layers, const Transform& t) { transform_all(edit_all(reader, layers), t, true); }

void move_layers(Reader& reader, Shared<std::vector<TextureLayers>>& textures, const Transform& t) {
    if (std::none_of(textures->begin(), textures->end(), has_any_pattern)) return;
    for (TextureLayers& layers : textures.edit())
        if (has_any_pattern(layers)) move_layers(reader, layers, t);
}

void settle_motion(Reader& reader, std::optional<TextureLayers>& layers, std::optional<Transform>& motion, bool always) {
    if (layers && motion && (always || has_any_pattern(*layers))) move_layers(reader, *layers, *motion);
    motion.reset();
}

bool is_patterned(const TextureLayers& layers) {
    return !layers->empty() && std::holds_alternative<Shared<PatternTexture>>(layers->back().content);
}

bool has_any_pattern(const TextureLayers& layers) {
    return std::any_of(layers->begin(), layers->end(), [](const Texture& layer) {
        const auto* plain = std::get_if<PlainTexture>(&layer.content);
        return !plain || plain->normal || !std::holds_alternative<PigmentColor>(plain->pigment.content);
    });
}

Pigment default_pigment(Reader& reader) { return std::get<PlainTexture>(reader.default_texture()->back().content).pigment; }

TreeSize tree_size(const PigmentMap& map) {
    TreeSize whole{1, 0};
    for (const Pigment& entry : map.pigments) add_cell(whole, tree_size(entry));
    return whole;
}

TreeSize tree_size(const NormalMap& map) {
    TreeSize whole{1, 0};
    for (const Normal& entry : map.normals) add_cell(whole, tree_size(entry));
    return whole;
}

TreeSize tree_size(const TextureMap& map) {
    TreeSize whole;
    for (const TextureLayers& entry : map.textures) add_cell(whole, tree_size(*entry));
    return whole;
}

namespace {

/// A pattern over colours weighs as much as three pigments, however many colours its map has: maps are shared.
constexpr TreeSize pattern_of_colors{3, 1};

/// With the pigment that it may be computed from.
TreeSize with_source(TreeSize size, const StatedPattern& stated) {
    if (const auto* source = std::get_if<Shared<Pigment>>(&stated.source)) add_cell(size, tree_size(**source));
    if (const auto* bodies = std::get_if<Shared<Bodies>>(&stated.source)) add_cell(size, {(*bodies)->objects.size(), 0});
    const auto* function = std::get_if<std::shared_ptr<const Function>>(&stated.source);
    if (function && *function) add_cell(size, {(*function)->source_nodes, (*function)->source_depth});
    return size;
}

}  // namespace

TreeSize tree_size(const Pigment& pigment) {
    const auto* stated = std::get_if<Shared<PatternPigment>>(&pigment.content);
    if (!stated) return {1, 0};
    const auto* map = std::get_if<Shared<PigmentMap>>(&(*stated)->map);
    return with_source(map ? tree_size(**map) : pattern_of_colors, (*stated)->pattern);
}

TreeSize tree_size(const Normal& normal) { return with_source(normal.map ? tree_size(**normal.map) : TreeSize{1, 0}, normal.pattern); }

TreeSize tree_size(const std::vector<Texture>& layers) {
    TreeSize whole;
    const auto add = [&](const TreeSize& size) { whole = {whole.nodes + size.nodes, std::max(whole.depth, size.depth)}; };
    for (const Texture& layer : layers) {
        if (const auto* plain = std::get_if<PlainTexture>(&layer.content)) {
            add(tree_size(plain->pigment));
            if (plain->normal && (*plain->normal)->map) add(tree_size(**plain->normal));
        } else {
            const PatternTexture& patterned = *std::get<Shared<PatternTexture>>(layer.content);
            add(with_source(tree_size(*patterned.map), patterned.pattern));
        }
    }
    return whole;
}

void limit_size(Reader& reader, const Span& place, const TreeSize& size) {
    const ParseOptions& options = reader.options();
    if (size.nodes > options.max_texture_nodes)
        reader.fail_limit(place, fmt::format("A texture has more than {} pigments in its layers and cells.", options.max_texture_nodes),
                          "texture");
    if (size.depth > options.max_texture_depth)
        reader.fail_limit(place, fmt::format("The patterns of a texture are nested more than {} deep.", options.max_texture_depth),
                          "texture-depth");
}

bool accept_layer_part(Reader& reader, std::optional<TextureLayers>& layers) {
    const Token next = reader.peek();
    if (next.is(Word::pigment)) {
        Pigment& pigment = edit_top(reader, layers_or_default(reader, layers)).pigment;
        reader.take();
        pigment = parse_pigment(reader, std::move(pigment));
    } else if (next.is(Word::finish)) {
        Finish& finish = edit_top(reader, layers_or_default(reader, layers)).finish;
        reader.take();
        finish = parse_finish(reader, std::move(finish));
    } else if (next.is(Word::normal)) {
        std::optional<Shared<Normal>>& normal = edit_top(reader, layers_or_default(reader, layers)).normal;
        reader.take();
        normal = parse_normal(reader, normal);
    } else {
        return false;
    }
    return true;
}

}  // namespace rt
