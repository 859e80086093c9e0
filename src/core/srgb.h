// The curve of sRGB (IEC 61966-2-1), between shares of full scale.
#pragma once

#include <cmath>

namespace rt {

inline double decode_srgb(double x) { return x < 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

inline double encode_srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055; }

}  // namespace rt
