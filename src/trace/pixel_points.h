// Where the samples of a pixel lie: a sequence without end whose beginnings are all evenly spread.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace rt {

/// Point `n` = 0, 1, ... of pixel (x, y), in pixels of the picture; the first is the centre. The sequence R2 (M. Roberts, The unreasonable
/// effectiveness of quasirandom sequences, 2018): u_n = 1/2 + n / g, v_n = 1/2 + n / g^2 (mod 1), with g^3 = g + 1, seen by each pixel from
/// another of the square's eight sides, so that neighbours do not share their errors. In whole numbers, the same everywhere.
inline Vec2 pixel_point(int x, int y, std::uint32_t n) {
    constexpr std::uint32_t half = 0x80000000u;
    std::uint32_t u = half + n * 3242174889u, v = half + n * 2447445414u;  // 2^32 / g, 2^32 / g^2
    std::uint32_t hash = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u;
    hash = (hash ^ hash >> 15) * 0x2C1B3C6Du;
    hash ^= hash >> 13;
    if (hash & 1) u = 0u - u;
    if (hash & 2) v = 0u - v;
    if (hash & 4) std::swap(u, v);
    constexpr double unit = 1.0 / 4294967296.0;
    return {x + u * unit, y + v * unit};
}

}  // namespace rt
