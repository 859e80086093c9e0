// color_map { }, pigment_map { }, normal_map { }, texture_map { }, slope_map { }.
#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

/// `[value item] ...`; `parse_item(value)` reads what follows the value and its comma. Where values are weights one that is not stated
/// is 1.
template <typename Item>
void parse_entries(Reader& reader, MapValues values, const Item& parse_item) {
    while (reader.accept('[')) {
        const bool stated = values == MapValues::places || reader.at_expression() || at_color(reader);
        const double value = stated ? reader.parse_float() : 1.0;
        reader.accept_comma();
        parse_item(value);
        reader.expect(']');
    }
}

/// The map's block: a declared one of the same kind, then entries.
template <typename Map, typename Item>
Shared<Map> parse_map(Reader& reader, std::string_view word, std::string_view empty, MapValues values, const Item& parse_item) {
    reader.begin_block(word);
    Shared<Map> map;
    const bool declared = [&] {
        const Shared<Map>* known = reader.accept_declared<Shared<Map>>();
        if (known) map = *known;
        return known != nullptr;
    }();
    if (!declared) {
        Map made;
        parse_entries(reader, values, [&](double value) { parse_item(made, value); });
        if (made == Map()) reader.fail(reader.peek().span, empty);
        map = std::move(made);
    }
    reader.end_block();
    return map;
}

constexpr std::string_view no_entry = "Must have at least one entry in map.";

void add(ColorMap& map, double value, const PigmentColor& color) {
    map.values.push_back(value);
    map.colors.push_back(color);
}

/// Old entries have two values and two colours, each of which says `color`.
void parse_color_entry(Reader& reader, ColorMap& map, double value) {
    if (!at_color(reader) && reader.at_expression() && !reader.peek().is('<')) {
        const double second = reader.parse_float();
        reader.accept_comma();
        for (const double each : {value, second}) {
            if (!reader.peek().is(Word::color) && !reader.peek().is(Word::colour)) reader.fail_expected("color");
            add(map, each, parse_color(reader));
            reader.accept_comma();
        }
        return;
    }
    if (!at_color(reader)) reader.fail_expected("color");
    add(map, value, parse_color(reader));
}

}  // namespace

Shared<ColorMap> parse_color_map(Reader& reader) {
    return parse_map<ColorMap>(reader, "color_map", "Must have at least one color in color map.", MapValues::places,
                               [&](ColorMap& map, double value) { parse_color_entry(reader, map, value); });
}

Shared<PigmentMap> parse_pigment_map(Reader& reader, MapValues values) {
    const Span place = reader.last_place();
    Shared<PigmentMap> map = parse_map<PigmentMap>(reader, "pigment_map", no_entry, values, [&](PigmentMap& made, double value) {
        made.values.push_back(value);
        made.pigments.push_back(parse_pigment_body(reader, default_pigment(reader)));
    });
    limit_size(reader, place, tree_size(*map));
    return map;
}

Shared<NormalMap> parse_normal_map(Reader& reader, MapValues values) {
    const Span place = reader.last_place();
    Shared<NormalMap> map = parse_map<NormalMap>(reader, "normal_map", no_entry, values, [&](NormalMap& made, double value) {
        made.values.push_back(value);
        made.normals.push_back(parse_normal_body(reader, nullptr));
    });
    limit_size(reader, place, tree_size(*map));
    return map;
}

Shared<TextureMap> parse_texture_map(Reader& reader, MapValues values) {
    const Span place = reader.last_place();
    Shared<TextureMap> map = parse_map<TextureMap>(reader, "texture_map", no_entry, values, [&](TextureMap& made, double value) {
        std::optional<TextureLayers> layers;
        parse_texture_body(reader, layers);
        made.values.push_back(value);
        made.textures.push_back(layers_or_default(reader, layers));
    });
    limit_size(reader, place, tree_size(*map));
    return map;
}

Shared<SlopeMap> parse_slope_map(Reader& reader) {
    return parse_map<SlopeMap>(reader, "slope_map", no_entry, MapValues::places, [&](SlopeMap& map, double value) {
        const Vec2 height_and_slope = reader.parse_vector2();
        map.push_back({value, height_and_slope.x, height_and_slope.y});
    });
}

}  // namespace rt
