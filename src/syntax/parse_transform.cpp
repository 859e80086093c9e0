// translate, rotate, scale, matrix and transform.
#include <fmt/format.h>

#include <stdexcept>

#include "syntax/blocks.h"
#include "syntax/parameters.h"

namespace rt {

namespace {

Transform parse_scale(Reader& reader) {
    Vec3 by = reader.parse_vector();
    for (int i = 0; i < 3; ++i) {
        if (by[i] != 0.0) continue;
        reader.warn(reader.peek().span, fmt::format("Illegal Value: Scale {} by 0.0. Changed to 1.0.", "XYZ"[i]));
        by[i] = 1.0;
    }
    return Transform::scale(by);
}

Transform parse_matrix(Reader& reader) {
    reader.expect('<');
    double m[12];
    for (int i = 0; i < 12; ++i) {
        m[i] = reader.parse_float();
        if (i != 11) reader.accept_comma();
    }
    reader.expect('>');
    const Span close = reader.last_place();
    for (int i = 0; i < 3; ++i) {
        if (m[i] != 0.0 || m[3 + i] != 0.0 || m[6 + i] != 0.0) continue;
        reader.warn(close, "Illegal matrix column: Scale by 0.0. Changed to 1.0.");
        m[4 * i] = 1.0;
    }
    try {
        return Transform::matrix(m);
    } catch (const std::domain_error&) {
        reader.fail(close, "Singular matrix in MInvers.");
    }
}

/// The group's steps in order; `inverse`, wherever it stands and however often, inverts all of it.
Transform parse_group(Reader& reader) {
    if (!reader.peek().is('{')) {
        const std::string found = reader.describe(reader.peek());
        reader.fail(reader.peek().span, fmt::format("Missing {{ after '{}', {} found instead", found.substr(0, found.find(" '")), found));
    }
    reader.begin_block("{");
    Transform group;
    bool inverse = false;
    for (;;) {
        if (const std::optional<Transform> step = accept_transform(reader)) {
            group = group.then(*step);
        } else if (const Transform* declared = reader.accept_declared<Transform>()) {
            group = group.then(*declared);
        } else if (reader.accept(Word::inverse)) {
            inverse = true;
        } else {
            break;
        }
    }
    reader.end_block();
    return inverse ? group.inverse() : group;
}

bool is_transform(Word w) {
    return w == Word::translate || w == Word::rotate || w == Word::scale || w == Word::matrix || w == Word::transform;
}

/// What follows the word.
Transform parse_transform(Reader& reader, Word w) {
    if (w == Word::translate) return Transform::translate(reader.parse_vector());
    if (w == Word::rotate) return Transform::rotate(reader.parse_vector(), reader.options().rotation);
    if (w == Word::scale) return parse_scale(reader);
    if (w == Word::matrix) return parse_matrix(reader);
    const Transform* declared = reader.accept_declared<Transform>();
    return declared ? *declared : parse_group(reader);
}

}  // namespace

std::optional<Transform> accept_transform(Reader& reader) {
    if (!is_transform(reader.peek().word)) return std::nullopt;
    const Token word = reader.take();
    std::optional<Transform> t = parse_transform(reader, word.word);
    require_finite(reader, word.span, *t);
    return t;
}

}  // namespace rt
