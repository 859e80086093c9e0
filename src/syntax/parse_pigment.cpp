// pigment { }
#include <fmt/format.h>

#include "patterns/map.h"
#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// What a pigment whose pattern is not modelled shows under `lenient`.
constexpr PigmentColor stand_in{Rgb(0.5), 0.0, 0.0};

/// The pigment's pattern for editing; a colour becomes one, and what moved it moves the pattern.
PatternPigment& edit_pattern(Pigment& pigment) {
    if (auto* pattern = std::get_if<Shared<PatternPigment>>(&pigment.content)) return pattern->edit();
    PatternPigment made;
    if (pigment.transform) append(made.pattern.pattern, *pigment.transform);
    pigment.transform.reset();
    return pigment.content.emplace<Shared<PatternPigment>>(std::move(made)).edit();
}

/// Colours or pigments of the cells; what is missing has the kind's own.
void parse_cells(Reader& reader, PatternPigment& patterned) {
    const PatternKind kind = patterned.pattern.pattern.kind;
    const auto count = static_cast<std::size_t>(list_size(kind));
    ColorMap colors;
    for (const Rgb& color : default_cell_colors(kind)) {
        colors.values.push_back(static_cast<double>(colors.values.size()));
        colors.colors.push_back({color, 0.0, 0.0});
    }
    if (!reader.peek().is(Word::pigment)) {
        for (std::size_t i = 0; i < count; ++i) {
            if (!at_color(reader) && !reader.at_expression()) break;
            colors.colors[i] = parse_color(reader);
            reader.accept_comma();
        }
        patterned.map = Shared<ColorMap>(std::move(colors));
        return;
    }
    PigmentMap pigments{colors.values, std::vector<Pigment>(count, default_pigment(reader))};
    for (Pigment& cell : pigments.pigments) {
        if (!reader.accept(Word::pigment)) break;
        cell = parse_pigment(reader, std::move(cell));
        reader.accept_comma();
    }
    patterned.map = Shared<PigmentMap>(std::move(pigments));
}

/// Of pigment, normal or texture; true if what comes next is a pattern that is not modelled.
bool skip_unmodelled(Reader& reader, Pigment& pigment) {
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word || !is_unmodelled_pattern(next.word)) return false;
    reader.unmodelled(next.span, text(next.word));
    reader.take();
    skip_to_block_end(reader);
    pigment.content = stand_in;
    return true;
}

/// The colour or pattern that a pigment begins with; false if there is none.
bool parse_content(Reader& reader, Pigment& pigment) {
    if (at_color(reader)) {
        pigment.content = parse_color(reader);
        return true;
    }
    const Span place = reader.peek().span;
    if (skip_unmodelled(reader, pigment)) return true;
    Pigment patterned = pigment;
    PatternPigment& edited = edit_pattern(patterned);
    if (reader.accept(Word::image_map)) {
        edited.map = parse_image_map(reader);
    } else if (accept_pattern(reader, edited.pattern, PatternUse::pigment)) {
        // A map that the pigment has from one that was declared stays.
        if (std::holds_alternative<Shared<ImageMap>>(edited.map)) edited.map = {};
        const PatternKind kind = edited.pattern.pattern.kind;
        if (!takes_map(kind)) parse_cells(reader, edited);
        end_list(reader, kind);
    } else {
        return false;
    }
    limit_size(reader, place, tree_size(patterned));
    pigment = std::move(patterned);
    return true;
}

bool accept_map(Reader& reader, Pigment& pigment) {
    const Token next = reader.peek();
    const bool colors = next.is(Word::color_map) || next.is(Word::colour_map);
    if (!colors && !next.is(Word::pigment_map)) return false;
    reader.take();
    auto* pattern = std::get_if<Shared<PatternPigment>>(&pigment.content);
    const PatternKind kind = pattern ? (*pattern)->pattern.pattern.kind : PatternKind::bozo;
    const bool image = pattern && std::holds_alternative<Shared<ImageMap>>((*pattern)->map);
    if (!pattern || image || !takes_map(kind) || (colors && kind == PatternKind::average))
        reader.fail(next.span, fmt::format("Cannot use {} with this pattern type.", colors ? "color_map" : "pigment_map"));
    if (colors)
        pattern->edit().map = parse_color_map(reader);
    else
        pattern->edit().map = parse_pigment_map(reader, map_values(kind));
    limit_size(reader, next.span, tree_size(pigment));
    return true;
}

void refuse_others(Reader& reader) {
    const Token next = reader.peek();
    for (const Word w : {Word::bump_size, Word::slope_map, Word::normal_map, Word::bump_map})
        if (next.is(w)) reader.fail(next.span, fmt::format("Keyword '{}' can only be used in a normal statement.", text(w)));
    if (next.is(Word::texture_map) || next.is(Word::material_map))
        reader.fail(next.span, fmt::format("Keyword '{}' can only be used in a texture statement.", text(next.word)));
}

/// Of a colour, only what moves it is kept, for a pattern that may take its place.
bool accept_modifier_of_color(Reader& reader, Pigment& pigment) {
    const Token next = reader.peek();
    if (const std::optional<Transform> t = accept_transform(reader)) {
        append(pigment.transform, *t);
        require_finite(reader, next.span, *pigment.transform);
        return true;
    }
    StatedPattern unused;
    return accept_pattern_modifier(reader, unused, PatternUse::pigment);
}

bool accept_modifier(Reader& reader, Pigment& pigment) {
    if (reader.accept(Word::quick_color) || reader.accept(Word::quick_colour)) {
        pigment.quick_color = parse_color(reader);
        return true;
    }
    if (accept_map(reader, pigment)) return true;
    refuse_others(reader);
    if (reader.accept(Word::no_bump_scale)) return true;
    auto* pattern = std::get_if<Shared<PatternPigment>>(&pigment.content);
    if (!pattern) return accept_modifier_of_color(reader, pigment);
    return accept_pattern_modifier(reader, pattern->edit().pattern, PatternUse::pigment);
}

}  // namespace

Pigment parse_pigment_body(Reader& reader, Pigment base) {
    const bool uv = reader.accept(Word::uv_mapping);
    const Pigment* declared = reader.accept_declared<Pigment>();
    Pigment pigment = declared ? *declared : std::move(base);
    const bool has_content = parse_content(reader, pigment);
    if (auto* patterned = std::get_if<Shared<PatternPigment>>(&pigment.content); uv && patterned)
        patterned->edit().pattern.uv_mapping = true;
    if (!has_content && !declared && pigment == Pigment{}) reader.warn(reader.peek().span, "Pigment type unspecified or not 1st item.");
    while (accept_modifier(reader, pigment)) continue;
    const auto* pattern = std::get_if<Shared<PatternPigment>>(&pigment.content);
    if (pattern && (*pattern)->pattern.pattern.kind == PatternKind::average && std::holds_alternative<std::monostate>((*pattern)->map))
        reader.fail(reader.peek().span, "Average must have map.");
    return pigment;
}

Pigment parse_pigment(Reader& reader, Pigment base) {
    reader.begin_block("pigment");
    Pigment pigment = parse_pigment_body(reader, std::move(base));
    reader.end_block();
    return pigment;
}

}  // namespace rt
