// Where a value lies in a map (color_map, pigment_map, texture_map, normal_map).
#pragma once

#include <cstddef>
#include <span>

#include "core/vec.h"
#include "patterns/pattern.h"

namespace rt {

/// Two neighbouring entries and the share of the upper one, 0..1. `lower == upper` outside the entries.
struct MapPlace {
    std::size_t lower = 0;
    std::size_t upper = 0;
    double weight = 0.0;
};

/// `positions`: of the entries, ascending, at least one. At and below the first: the first; at and above the last: the last; between equal
/// positions the lower side has the value itself.
MapPlace find_in_map(std::span<const double> positions, double value);

/// One entry of the map that a pattern has where the scene states none.
struct DefaultMapEntry {
    double value;
    Rgb color;
};

/// The built-in colour map of a kind, black to white for most; opaque colours.
std::span<const DefaultMapEntry> default_color_map(PatternKind kind);
/// The built-in colours of a kind that lists some, `list_size` of them.
std::span<const Rgb> default_cell_colors(PatternKind kind);

}  // namespace rt
