#include "syntax/texture_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
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

void transform_layers(Reader& reader, TextureLayers& layers, const Transform& t) {
    for (Texture& layer : edit_all(reader, layers)) {
        if (auto* plain = std::get_if<PlainTexture>(&layer.content))
            append(plain->pigment.transform, t);
        else
            append(std::get<CheckerTexture>(layer.content).transform, t);
    }
}

bool is_patterned(const TextureLayers& layers) {
    return !layers->empty() && std::holds_alternative<CheckerTexture>(layers->back().content);
}

bool has_any_pattern(const TextureLayers& layers) {
    return std::any_of(layers->begin(), layers->end(), [](const Texture& layer) {
        const auto* plain = std::get_if<PlainTexture>(&layer.content);
        return !plain || !std::holds_alternative<PigmentColor>(plain->pigment.content);
    });
}

Pigment default_pigment(Reader& reader) { return std::get<PlainTexture>(reader.default_texture()->back().content).pigment; }

TreeSize tree_size(const Pigment& pigment) {
    TreeSize whole{1, 0};
    if (const auto* checker = std::get_if<CheckerPigment>(&pigment.content))
        for (const Pigment& cell : checker->cells) add_cell(whole, tree_size(cell));
    return whole;
}

TreeSize tree_size(const std::vector<Texture>& layers) {
    TreeSize whole;
    for (const Texture& layer : layers) {
        TreeSize size;
        if (const auto* plain = std::get_if<PlainTexture>(&layer.content))
            size = tree_size(plain->pigment);
        else
            for (const std::vector<Texture>& cell : std::get<CheckerTexture>(layer.content).cells) add_cell(size, tree_size(cell));
        whole = {whole.nodes + size.nodes, std::max(whole.depth, size.depth)};
    }
    return whole;
}

void limit_size(Reader& reader, const Span& place, const TreeSize& size) {
    const ParseOptions& options = reader.options();
    const auto fail = [&](const std::string& text) { throw LimitError(reader.scene().sources.describe(place, "Parse Error", text)); };
    if (size.nodes > options.max_texture_nodes)
        fail(fmt::format("A texture has more than {} pigments in its layers and cells.", options.max_texture_nodes));
    if (size.depth > options.max_texture_depth)
        fail(fmt::format("The patterns of a texture are nested more than {} deep.", options.max_texture_depth));
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
        edit_top(reader, layers_or_default(reader, layers));
        reader.take();
        skip_unmodelled_block(reader, next);
    } else {
        return false;
    }
    return true;
}

}  // namespace rt
