// Floats as the ints of POV-Ray's machines.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace rt {

/// Toward zero; what does not fit 32 bits, and NaN, becomes the smallest int.
inline double to_int(double x) {
    constexpr double lowest = std::numeric_limits<std::int32_t>::min();
    const double whole = std::trunc(x);
    return whole >= lowest && whole <= -(lowest + 1.0) ? whole + 0.0 : lowest;
}

}  // namespace rt
