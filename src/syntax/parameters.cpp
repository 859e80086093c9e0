#include "syntax/parameters.h"

#include <algorithm>

#include "syntax/blocks.h"

namespace rt {

namespace {

bool is_finite_matrix(const Mat3& m) { return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]); }

}  // namespace

int parse_int(Reader& reader) { return static_cast<int>(std::clamp(reader.parse_float(), -2147483647.0, 2147483647.0)); }

std::size_t parse_count(Reader& reader) { return static_cast<std::size_t>(std::clamp(reader.parse_float(), 0.0, 4294967295.0)); }

std::size_t reserve_limit(Reader& reader, std::size_t stated, std::size_t bytes_each) {
    const Span place = reader.peek().span;
    if (place.file == Span::none) return 0;
    const std::size_t left = reader.scene().sources.file(place.file).text.size() - place.begin;
    return std::min(stated, left / bytes_each + 1);
}

void require_finite(Reader& reader, const Span& place, const Vec3& v) {
    if (!is_finite(v)) reader.fail(place, "What this is moved to is not finite.");
}

void require_finite(Reader& reader, const Span& place, const Transform& t) {
    if (!is_finite_matrix(t.linear) || !is_finite(t.offset) || !is_finite_matrix(t.inverse_linear) || !is_finite(t.inverse_offset))
        reader.fail(place, "This transform or its inverse has numbers that are not finite.");
}

std::optional<Transform> accept_transforms(Reader& reader) {
    std::optional<Transform> all;
    while (const std::optional<Transform> next = accept_transform(reader)) {
        append(all, *next);
        require_finite(reader, reader.peek().span, *all);
    }
    return all;
}

void append(std::optional<Transform>& transform, const Transform& later) { transform = transform ? transform->then(later) : later; }

}  // namespace rt
