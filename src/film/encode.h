// Linear light to the numbers of a file: the one place with clamp, gamma and rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "film/film.h"

namespace rt {

/// A transfer function between stored and linear light.
struct Curve {
    enum class Kind { power, srgb };
    Kind kind = Kind::power;
    double power = 1.0;  ///< linear = stored^power; within 1 % of 1 it is exactly 1
    bool operator==(const Curve&) const = default;
};

struct Encoding {
    bool raw = false;  ///< legacy scenes: values are quantised as they are, whatever the curves say
    Curve working;     ///< the scene's assumed_gamma
    Curve file{Curve::Kind::srgb, 1.0};  ///< File_Gamma; ignored by formats that hold linear light
    int bits = 8;      ///< 8 or 16 per channel
    bool alpha = false;
    bool dither = false;
};

/// Working-space value to linear light (unclamped; negative values become 0 under a power other than 1).
double to_linear(double value, const Encoding& encoding);
/// Working-space value to the file's 0..1 range before clamping.
double encode(double value, const Encoding& encoding);
/// floor(clamp(encode(v)) (2^bits - 1) + 1/2), NaN becomes 0.
std::uint16_t quantise(double value, const Encoding& encoding);
/// All pixels, interleaved RGB or (un-premultiplied) RGBA, row by row from the top.
std::vector<std::uint16_t> quantise(const Film& film, const Encoding& encoding);

}  // namespace rt
