// What a ray's meeting with a shape leaves behind for the normal to be computed later, only if it is needed.
#pragma once

#include <cstdint>

#include "core/ray.h"

namespace rt {

/// `t` counts in lengths of the ray's direction. `part` names the face of a box, side or cap of a cone, ... (each shape's header says);
/// `u`, `v` are barycentric weights of the second and third vertex for triangles.
struct ShapeHit {
    double t = infinity;
    std::uint32_t part = 0;
    double u = 0.0;
    double v = 0.0;
};

}  // namespace rt
