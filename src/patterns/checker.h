// Surface patterns: pure functions of a point in pattern space.
#pragma once

#include <cmath>

#include "core/vec.h"

namespace rt {

/// POV-Ray's checker: 0 or 1, the parity of the unit cube that holds `p`. The offset 1e-10 decides for points on a face.
inline int checker(const Vec3& p) {
    const double cell = std::floor(p.x + 1e-10) + std::floor(p.y + 1e-10) + std::floor(p.z + 1e-10);
    return std::fabs(std::fmod(cell, 2.0)) == 1.0 ? 1 : 0;
}

}  // namespace rt
