// texture { }, material { } and #default.
#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// `texture { }` of each cell; one that is not stated is the default texture.
TextureMap parse_cells(Reader& reader, PatternKind kind) {
    const Span place = reader.last_place();
    TextureMap map;
    for (int i = 0; i < list_size(kind); ++i) {
        std::optional<TextureLayers> cell;
        if (reader.accept(Word::texture)) {
            parse_texture(reader, cell);
            reader.accept_comma();
        }
        layers_or_default(reader, cell);
        reader.count_scene_nodes(place, (*cell)->size() - 1);
        map.values.push_back(i);
        map.textures.push_back(*cell);
    }
    return map;
}

/// A pattern of textures with its modifiers, if one comes next.
bool parse_pattern_texture(Reader& reader, std::optional<TextureLayers>& layers) {
    const Span place = reader.peek().span;
    PatternTexture texture;
    if (!accept_pattern(reader, texture.pattern, PatternUse::texture)) return false;
    const PatternKind kind = texture.pattern.pattern.kind;
    bool has_map = !takes_map(kind);
    if (has_map) texture.map = parse_cells(reader, kind);
    end_list(reader, kind);
    for (;;) {
        const Token next = reader.peek();
        if (reader.accept(Word::texture_map)) {
            if (!takes_map(kind)) reader.fail(next.span, "Cannot use texture_map with this pattern type.");
            texture.map = parse_texture_map(reader, map_values(kind));
            has_map = true;
        } else if (!accept_pattern_modifier(reader, texture.pattern, PatternUse::texture)) {
            break;
        }
    }
    if (!has_map)
        reader.fail(reader.peek().span,
                    kind == PatternKind::average ? "Average must have map." : "Patterned texture must have texture_map.");
    layers = std::vector<Texture>{Texture{Shared<PatternTexture>(std::move(texture))}};
    limit_size(reader, place, tree_size(**layers));
    return true;
}

void set_uv_mapping(Reader& reader, TextureLayers& layers) {
    for (Texture& layer : edit_all(reader, layers)) {
        if (auto* plain = std::get_if<PlainTexture>(&layer.content))
            plain->uv_mapping = true;
        else
            std::get<Shared<PatternTexture>>(layer.content).edit().pattern.uv_mapping = true;
    }
}

/// `tiles { texture { } tile2 texture { } }`, if it comes next: a checker whose first cells are those of tile2. Each of both may be several
/// layers.
bool parse_tiles(Reader& reader, std::optional<TextureLayers>& layers) {
    if (!reader.accept(Word::tiles)) return false;
    const Span place = reader.last_place();
    reader.begin_block("tiles");
    std::optional<TextureLayers> first, second;
    while (reader.accept(Word::texture)) parse_texture(reader, first);
    if (!reader.accept(Word::tile2)) reader.fail_expected("tile2");
    while (reader.accept(Word::texture)) parse_texture(reader, second);
    reader.end_block();
    PatternTexture texture;
    texture.pattern.pattern = make_pattern(PatternKind::checker);
    texture.map = TextureMap{{0.0, 1.0}, {layers_or_default(reader, second), layers_or_default(reader, first)}};
    while (accept_pattern_modifier(reader, texture.pattern, PatternUse::texture)) {
    }
    layers = std::vector<Texture>{Texture{Shared<PatternTexture>(std::move(texture))}};
    limit_size(reader, place, tree_size(**layers));
    return true;
}

/// material_map or a pattern that is not modelled: reported and skipped; true if one comes next.
bool skip_unmodelled_texture(Reader& reader) {
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return false;
    if (next.word != Word::material_map && !is_unmodelled_pattern(next.word)) return false;
    reader.unmodelled(next.span, text(next.word));
    reader.take();
    skip_to_block_end(reader);
    return true;
}

void parse_transforms(Reader& reader, std::optional<TextureLayers>& layers) {
    if (const std::optional<Transform> t = accept_transforms(reader)) transform_layers(reader, layers_or_default(reader, layers), *t);
}

/// A pigment, normal or finish by the name that it was declared with, in the place of what the layer has.
bool accept_declared_part(Reader& reader, std::optional<TextureLayers>& layers) {
    const auto top = [&]() -> PlainTexture& { return edit_top(reader, layers_or_default(reader, layers)); };
    if (const Pigment* const pigment = reader.accept_declared<Pigment>())
        top().pigment = *pigment;
    else if (const Normal* const normal = reader.accept_declared<Normal>())
        top().normal = Shared<Normal>(*normal);
    else if (const Finish* const finish = reader.accept_declared<Finish>())
        top().finish = *finish;
    else
        return false;
    return true;
}

/// A layer that is no pattern of textures: edits the top of `layers`.
void parse_plain_parts(Reader& reader, std::optional<TextureLayers>& layers) {
    while (accept_declared_part(reader, layers)) continue;
    do parse_transforms(reader, layers);
    while (accept_layer_part(reader, layers));
    if (at_color(reader) && reader.peek().kind == Token::Kind::word)
        reader.fail(reader.peek().span, "Keyword 'color' can only be used in a pigment or density statement.");
}

[[gnu::noinline]] bool accept_material_part(Reader& reader, MaterialValue& material) {
    if (reader.accept(Word::texture)) {
        parse_texture(reader, material.texture);
    } else if (reader.accept(Word::interior_texture)) {
        parse_texture(reader, material.interior_texture);
    } else if (reader.accept(Word::interior)) {
        material.interior = parse_interior(reader, material.interior.value_or(Shared<Interior>()));
    } else if (const std::optional<Transform> t = accept_transforms(reader)) {
        if (material.texture) transform_layers(reader, *material.texture, *t);
        if (material.interior_texture) transform_layers(reader, *material.interior_texture, *t);
    } else {
        return false;
    }
    return true;
}

}  // namespace

void parse_texture_body(Reader& reader, std::optional<TextureLayers>& own) {
    const bool uv = reader.accept(Word::uv_mapping);
    if (const TextureLayers* declared = reader.accept_declared<TextureLayers>()) own = *declared;
    if (own && is_patterned(*own)) {
        parse_transforms(reader, own);
    } else if (own || (!parse_tiles(reader, own) && !skip_unmodelled_texture(reader) && !parse_pattern_texture(reader, own))) {
        parse_plain_parts(reader, own);
    }
    if (uv) set_uv_mapping(reader, layers_or_default(reader, own));
}

void parse_texture(Reader& reader, std::optional<TextureLayers>& layers) {
    reader.begin_block("texture");
    std::optional<TextureLayers> own;
    parse_texture_body(reader, own);
    const Span place = reader.peek().span;
    if (reader.at_block_end()) stack(reader, place, layers, layers_or_default(reader, own));
    reader.end_block();
}

MaterialValue parse_material(Reader& reader, MaterialValue base) {
    reader.begin_block("material");
    MaterialValue material = std::move(base);
    if (const MaterialValue* declared = reader.accept_declared<MaterialValue>()) {
        const MaterialValue copy = *declared;
        const Span place = reader.peek().span;
        if (copy.texture) stack(reader, place, material.texture, *copy.texture);
        if (copy.interior_texture) stack(reader, place, material.interior_texture, *copy.interior_texture);
        if (copy.interior) material.interior = copy.interior;
    }
    while (accept_material_part(reader, material)) continue;
    reader.end_block();
    return material;
}

void parse_default(Reader& reader) {
    reader.begin_block("default");
    for (;;) {
        std::optional<TextureLayers> layers;
        const Token next = reader.peek();
        if (reader.accept(Word::texture)) {
            parse_texture(reader, layers);
            if (is_patterned(*layers)) reader.fail(reader.last_place(), "Default texture cannot be material map or tiles.");
            if ((*layers)->size() > 1) reader.fail(reader.last_place(), "Default texture cannot be layered.");
        } else if (next.is(Word::camera) || next.is(Word::radiosity)) {
            reader.take();
            skip_unmodelled_block(reader, next);
            continue;
        } else if (!accept_layer_part(reader, layers)) {
            break;
        }
        reader.default_texture() = *layers;
    }
    reader.end_block();
}

}  // namespace rt
