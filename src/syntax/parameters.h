// What the blocks share to read their parameters: whole numbers, counts, transforms that stay finite.
#pragma once

#include "syntax/reader.h"

namespace rt {

/// Cut to a whole number as POV-Ray does, kept within the range of int.
int parse_int(Reader& reader);
/// A stated number of items, at least 0. Not to be trusted for reserving memory: see `reserve_limit`.
std::size_t parse_count(Reader& reader);
/// At most as many items as the file could still hold if each took `bytes_each` characters.
std::size_t reserve_limit(Reader& reader, std::size_t stated, std::size_t bytes_each);

/// Fails at `place` if what was computed from finite parameters has overflowed.
void require_finite(Reader& reader, const Span& place, const Vec3& v);
void require_finite(Reader& reader, const Span& place, const Transform& t);

/// Takes every transform that comes next; empty if there is none.
std::optional<Transform> accept_transforms(Reader& reader);
/// `later` after what `transform` holds.
void append(std::optional<Transform>& transform, const Transform& later);

}  // namespace rt
