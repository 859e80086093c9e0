#include "syntax/texture_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/unmodelled.h"

namespace rt {

TextureLayers& layers_or_default(Reader& reader, std::optional<TextureLayers>& layers) {
    if (!layers) layers = reader.default_texture();
    return *layers;
}

PlainTexture& edit_top(Reader& reader, TextureLayers& layers) {
    if (is_patterned(layers)) reader.fail(reader.peek().span, "Cannot layer over a patterned texture.");
    return std::get<PlainTexture>(layers.edit().back().content);
}

void stack(Reader& reader, const Span& place, std::optional<TextureLayers>& layers, const TextureLayers& upper) {
    if (!layers) {
        layers = upper;
        return;
    }
    if (is_patterned(*layers)) reader.fail(place, "Cannot layer over a patterned texture.");
    if (is_patterned(upper)) reader.fail(place, "Cannot layer a patterned texture over another.");
    limit_nodes(reader, place, count_nodes(**layers) + count_nodes(*upper));
    std::vector<Texture>& all = layers->edit();
    all.insert(all.end(), upper->begin(), upper->end());
}

void transform_layers(TextureLayers& layers, const Transform& t) {
    for (Texture& layer : layers.edit()) {
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

std::size_t count_nodes(const Pigment& pigment) {
    std::size_t nodes = 1;
    if (const auto* checker = std::get_if<CheckerPigment>(&pigment.content))
        for (const Pigment& cell : checker->cells) nodes += count_nodes(cell);
    return nodes;
}

std::size_t count_nodes(const std::vector<Texture>& layers) {
    std::size_t nodes = 0;
    for (const Texture& layer : layers) {
        if (const auto* plain = std::get_if<PlainTexture>(&layer.content))
            nodes += count_nodes(plain->pigment);
        else
            for (const std::vector<Texture>& cell : std::get<CheckerTexture>(layer.content).cells) nodes += count_nodes(cell);
    }
    return nodes;
}

void limit_nodes(Reader& reader, const Span& place, std::size_t nodes) {
    const std::size_t most = reader.options().max_texture_nodes;
    if (nodes <= most) return;
    throw LimitError(reader.scene().sources.describe(place, "Parse Error",
                                                     fmt::format("A texture has more than {} pigments in its layers and cells.", most)));
}

bool accept_layer_part(Reader& reader, std::optional<TextureLayers>& layers) {
    const Token next = reader.peek();
    if (next.is(Word::pigment)) {
        Pigment& pigment = edit_top(reader, layers_or_default(reader, layers)).pigment;
        reader.take();
        pigment = parse_pigment(reader, pigment);
    } else if (next.is(Word::finish)) {
        Finish& finish = edit_top(reader, layers_or_default(reader, layers)).finish;
        reader.take();
        finish = parse_finish(reader, finish);
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
