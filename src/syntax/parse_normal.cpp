// normal { }
#include <fmt/format.h>

#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// The amount that may stand behind the pattern.
void parse_amount(Reader& reader, Normal& normal) {
    reader.accept_comma();
    if (reader.at_expression()) normal.bump.amount = static_cast<float>(reader.parse_float());
}

/// `normal { }` of each cell; without them the cells' numbers are heights.
void parse_cells(Reader& reader, Normal& normal) {
    NormalMap map;
    const auto count = static_cast<std::size_t>(list_size(normal.pattern.pattern.kind));
    for (std::size_t i = 0; i < count; ++i) {
        map.values.push_back(static_cast<double>(i));
        map.normals.emplace_back();
        map.normals.back().bump.amount = 0.0F;
        if (!reader.accept(Word::normal)) continue;
        map.normals.back() = *parse_normal(reader, std::nullopt);
        reader.accept_comma();
    }
    normal.map = Shared<NormalMap>(std::move(map));
}

bool parse_content(Reader& reader, Normal& normal) {
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return false;
    if (at_color(reader)) reader.fail(next.span, "Keyword 'color' can only be used in a pigment or density statement.");
    if (next.is(Word::image_map)) reader.fail(next.span, "Keyword 'image_map' can only be used in a pigment statement.");
    if (is_unmodelled_pattern(next.word)) {
        reader.unmodelled(next.span, text(next.word));
        reader.take();
        skip_to_block_end(reader);
        normal.bump.amount = 0.0F;
        return true;
    }
    if (reader.accept(Word::bump_map)) {
        become(normal.pattern, PatternKind::bump_map);
        normal.pattern.pattern.numbers = parse_value_image(reader, &normal.bump.amount);
        normal.map.reset();
    } else if (!accept_pattern(reader, normal.pattern, PatternUse::normal)) {
        return false;
    }
    const PatternKind kind = normal.pattern.pattern.kind;
    if (!takes_map(kind)) normal.map.reset();
    if (!takes_map(kind) && reader.peek().is(Word::normal)) {
        parse_cells(reader, normal);
        end_list(reader, kind);
    } else {
        end_list(reader, kind);
        parse_amount(reader, normal);
    }
    return true;
}

bool accept_map(Reader& reader, Normal& normal) {
    const Token next = reader.peek();
    if (reader.accept(Word::normal_map)) {
        if (!takes_map(normal.pattern.pattern.kind)) reader.fail(next.span, "Cannot use normal_map with this pattern type.");
        normal.map = parse_normal_map(reader, map_values(normal.pattern.pattern.kind));
    } else if (reader.accept(Word::slope_map)) {
        normal.bump.slopes = *parse_slope_map(reader);
    } else {
        return false;
    }
    return true;
}

bool accept_modifier(Reader& reader, Normal& normal) {
    const Token next = reader.peek();
    if (reader.accept(Word::bump_size)) {
        normal.bump.amount = static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::accuracy)) {
        const auto accuracy = static_cast<float>(reader.parse_float());
        if (accuracy > 0.0F) normal.bump.accuracy = accuracy;
    } else if (reader.accept(Word::no_bump_scale)) {
        normal.bump.scale = !reader.parse_bool_or(true);
    } else if (!accept_map(reader, normal)) {
        for (const Word w : {Word::color_map, Word::colour_map, Word::pigment_map, Word::quick_color, Word::quick_colour})
            if (next.is(w)) reader.fail(next.span, fmt::format("Keyword '{}' can only be used in a pigment statement.", text(w)));
        return accept_pattern_modifier(reader, normal.pattern, PatternUse::normal);
    }
    return true;
}

}  // namespace

Normal parse_normal_body(Reader& reader, const Normal* base) {
    const bool uv = reader.accept(Word::uv_mapping);
    if (const Normal* const declared = reader.accept_declared<Normal>()) base = declared;
    Normal normal = base ? *base : Normal{};
    normal.pattern.uv_mapping |= uv;
    const Span place = reader.peek().span;
    if (!parse_content(reader, normal)) {
        if (!base) reader.fail(place, "No normal type given.");
        parse_amount(reader, normal);
    }
    while (accept_modifier(reader, normal)) continue;
    if (normal.pattern.pattern.kind == PatternKind::average && !normal.map) reader.fail(reader.peek().span, "Average must have map.");
    return normal;
}

Shared<Normal> parse_normal(Reader& reader, std::optional<Shared<Normal>> base) {
    reader.begin_block("normal");
    Normal normal = parse_normal_body(reader, base ? &**base : nullptr);
    reader.end_block();
    return normal;
}

}  // namespace rt
