// Pictures as displays get them, and how far one is from another.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/extremes/picture.h"

namespace rt::extremes {

/// 8 bits, sRGB, interleaved; pixels that are not a number are counted and black.
struct Bytes {
    int width = 0, height = 0;
    std::vector<std::uint8_t> values;
    int non_finite = 0;
};

Bytes encode(const Picture& picture);

/// The largest distance of a channel of that pixel. Throws std::out_of_range for pictures of two sizes.
int steps_apart(const Bytes& a, const Bytes& b, std::size_t pixel);

/// Pixels of which some channel is more than one step away, and the largest distance.
struct Wrong {
    int pixels = 0, steps = 0;
};
Wrong wrong(const Bytes& picture, const Bytes& truth);

}  // namespace rt::extremes
