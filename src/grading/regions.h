// Where two pictures differ: connected groups of pixels.
#pragma once

#include <cstdint>
#include <optional>

#include "film/image_file.h"

namespace rt {

/// The largest group of pixels, each beside or diagonal to another of it, that differ by the fuzz or more in a colour channel.
struct DifferingRegion {
    std::uint64_t pixels = 0;
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< its box from the top left, ends excluded
    /// The pixel of the group that is farthest from its edge (steps along rows and columns; then the one that differs most, then the
    /// first in reading order): what is seen there is not the edge's accident.
    int x = 0, y = 0;
};

/// Empty if no pixel differs so much. Both pictures have the same size; fuzz is in percent of full scale.
std::optional<DifferingRegion> largest_region(const StoredImage& reference, const StoredImage& test, double fuzz_percent);

}  // namespace rt
