// Where the samples of a pixel lie: a sequence without end whose beginnings are all evenly spread.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace rt {

constexpr std::uint32_t reversed_bits(std::uint32_t v) {
    v = (v >> 1 & 0x55555555u) | (v & 0x55555555u) << 1;
    v = (v >> 2 & 0x33333333u) | (v & 0x33333333u) << 2;
    v = (v >> 4 & 0x0F0F0F0Fu) | (v & 0x0F0F0F0Fu) << 4;
    v = (v >> 8 & 0x00FF00FFu) | (v & 0x00FF00FFu) << 8;
    return v >> 16 | v << 16;
}

/// Every bit flips or stays, as the bits below it say; with the bits in the other order that is Owen's scrambling of a fraction. B. Burley,
/// Practical Hash-based Owen Scrambling, JCGT 9(4), 2020.
constexpr std::uint32_t scrambled_upwards(std::uint32_t v, std::uint32_t seed) {
    v += seed;
    v ^= v * 0x6C50B47Cu;
    v ^= v * 0xB82F1E52u;
    v ^= v * 0xC7AFE638u;
    return v ^ v * 0x8D22F6E6u;
}

/// The second coordinate of Sobol's sequence, with its bits in the other order; the first is `n`.
constexpr std::uint32_t sobol_second(std::uint32_t n) {
    std::uint32_t bits = 0;
    for (std::uint32_t direction = 0x80000000u; n != 0; n >>= 1, direction ^= direction >> 1) bits ^= (n & 1) ? direction : 0;
    return reversed_bits(bits);
}

/// Point `n` = 0, 1, ... of pixel (x, y), in pixels of the picture; the first is the centre. Sobol's (0,2)-sequence, scrambled by the pixel
/// and then moved, place by place, so that its first point is the centre: 2^k points from a multiple of 2^k on fall one into each of 2^k
/// equal parts, whichever way the pixel is cut in halves, quarters and so on. The mean of n = 2^k samples across an edge is off by n^-0.75.
/// In whole numbers, the same everywhere.
inline Vec2 pixel_point(int x, int y, std::uint32_t n) {
    constexpr std::uint32_t half = 0x80000000u;
    std::uint32_t hash = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u;
    hash = (hash ^ hash >> 15) * 0x2C1B3C6Du;
    hash = (hash ^ hash >> 13) * 0x297A2D39u;
    hash ^= hash >> 16;
    const std::uint32_t other = hash * 0x9E3779B1u + 0x7F4A7C15u;
    const auto from_centre = [&](std::uint32_t bits, std::uint32_t seed) {
        return reversed_bits(scrambled_upwards(bits, seed) ^ scrambled_upwards(0, seed)) ^ half;
    };
    constexpr double unit = 1.0 / 4294967296.0;
    return {x + from_centre(n, hash) * unit, y + from_centre(sobol_second(n), other) * unit};
}

}  // namespace rt
