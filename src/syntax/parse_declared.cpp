// The blocks that `#declare NAME =` may name.
#include "syntax/blocks.h"
#include "syntax/parse_pattern.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// One texture or several: they are the layers of one value.
[[gnu::noinline]] TextureLayers parse_layers(Reader& reader) {
    std::optional<TextureLayers> layers;
    do parse_texture(reader, layers);
    while (reader.accept_at_once(Word::texture));
    return *layers;
}

/// Blocks whose value is not modelled. The name then stands for nothing, which only what is skipped as well can use.
bool is_unmodelled_value(Word w) {
    switch (w) {
        case Word::density:
        case Word::density_map:
            return true;
        default:
            return is_unmodelled_item(w);
    }
}

[[gnu::noinline]] std::optional<Value> parse_material_block(Reader& reader) {
    if (reader.accept(Word::pigment)) return parse_pigment(reader, default_pigment(reader));
    if (reader.accept(Word::finish)) return parse_finish(reader, std::get<PlainTexture>(reader.default_texture()->back().content).finish);
    if (reader.accept(Word::texture)) return parse_layers(reader);
    if (reader.accept(Word::interior)) return parse_interior(reader, Interior{});
    if (reader.accept(Word::material)) return parse_material(reader, {});
    if (reader.accept(Word::normal)) return *parse_normal(reader, std::get<PlainTexture>(reader.default_texture()->back().content).normal);
    return std::nullopt;
}

[[gnu::noinline]] std::optional<Value> parse_map_block(Reader& reader) {
    if (reader.accept(Word::color_map) || reader.accept(Word::colour_map)) return parse_color_map(reader);
    if (reader.accept(Word::pigment_map)) return parse_pigment_map(reader, MapValues::places);
    if (reader.accept(Word::normal_map)) return parse_normal_map(reader, MapValues::places);
    if (reader.accept(Word::texture_map)) return parse_texture_map(reader, MapValues::places);
    if (reader.accept(Word::slope_map)) return parse_slope_map(reader);
    return std::nullopt;
}

[[gnu::noinline]] std::optional<Value> parse_surroundings(Reader& reader) {
    if (reader.accept(Word::sky_sphere)) return parse_sky_sphere(reader);
    if (reader.accept(Word::fog)) return parse_fog(reader);
    if (reader.accept(Word::rainbow)) return parse_rainbow(reader);
    return std::nullopt;
}

}  // namespace

std::optional<Value> parse_declared_block(Reader& reader) {
    const Token next = reader.peek();
    if (next.kind == Token::Kind::identifier) {
        return reader.accept_any_declared();
    }
    if (next.kind != Token::Kind::word) return std::nullopt;
    if (std::optional<Value> value = parse_material_block(reader)) return value;
    if (std::optional<Value> value = parse_map_block(reader)) return value;
    if (std::optional<Value> value = parse_surroundings(reader)) return value;
    if (reader.accept(Word::camera)) return parse_camera(reader);
    if (next.is(Word::transform)) return accept_transform(reader);
    if (std::optional<Placeable> object = accept_object(reader))
        return std::visit([](auto&& held) { return Value(std::move(held)); }, std::move(*object));
    if (!is_unmodelled_value(next.word)) return std::nullopt;
    reader.take();
    skip_unmodelled_block(reader, next);
    return UnmodelledValue{next.word};
}

}  // namespace rt
