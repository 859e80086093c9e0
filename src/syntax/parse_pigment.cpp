// pigment { }
#include <array>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// What a pigment whose pattern is not modelled shows under `lenient`.
constexpr PigmentColor stand_in{Rgb(0.5), 0.0, 0.0};

/// Two colours or two pigment blocks; what is missing has its default.
CheckerPigment parse_checker(Reader& reader) {
    const Pigment blue{PigmentColor{Rgb(0, 0, 1), 0, 0}, {}, {}};
    const Pigment green{PigmentColor{Rgb(0, 1, 0), 0, 0}, {}, {}};
    std::array cells{blue, green};
    if (reader.peek().is(Word::pigment)) {
        cells = {default_pigment(reader), default_pigment(reader)};
        for (Pigment& cell : cells) {
            if (!reader.accept(Word::pigment)) break;
            cell = parse_pigment(reader, std::move(cell));
            reader.accept_comma();
        }
        return {{std::move(cells[0]), std::move(cells[1])}};
    }
    for (Pigment& cell : cells) {
        if (!at_color(reader) && (!reader.at_expression() || reader.peek().is('<'))) break;
        cell.content = parse_color(reader);
        reader.accept_comma();
    }
    return {{std::move(cells[0]), std::move(cells[1])}};
}

/// The colour or pattern that a pigment begins with; false if there is none.
bool parse_content(Reader& reader, Pigment& pigment) {
    if (at_color(reader)) {
        pigment.content = parse_color(reader);
        return true;
    }
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return false;
    if (reader.accept(Word::checker)) {
        pigment.content = parse_checker(reader);
        limit_size(reader, next.span, tree_size(pigment));
        return true;
    }
    if (!is_unmodelled_pattern(next.word)) return false;
    reader.unmodelled(next.span, text(next.word));
    reader.take();
    skip_to_block_end(reader);
    pigment.content = stand_in;
    return true;
}

void parse_modifiers(Reader& reader, Pigment& pigment) {
    for (;;) {
        const Token next = reader.peek();
        if (const std::optional<Transform> t = accept_transform(reader)) {
            append(pigment.transform, *t);
            require_finite(reader, next.span, *pigment.transform);
        } else if (reader.accept(Word::quick_color) || reader.accept(Word::quick_colour)) {
            pigment.quick_color = parse_color(reader);
        } else if (next.kind == Token::Kind::word && is_pattern_modifier(next.word)) {
            if (!std::holds_alternative<PigmentColor>(pigment.content)) reader.unmodelled(next.span, text(next.word));
            reader.take();
            skip_to_block_end(reader);
        } else {
            return;
        }
    }
}

}  // namespace

Pigment parse_pigment(Reader& reader, Pigment base) {
    reader.begin_block("pigment");
    const Pigment* declared = reader.accept_declared<Pigment>();
    Pigment pigment = declared ? *declared : std::move(base);
    const bool has_content = parse_content(reader, pigment);
    if (!has_content && !declared) reader.warn(reader.peek().span, "Pigment type unspecified or not 1st item.");
    parse_modifiers(reader, pigment);
    reader.end_block();
    return pigment;
}

}  // namespace rt
