// What a ray's meeting with a shape leaves behind for the normal to be computed later, only if it is needed; and how far it can be off.
#pragma once

#include <algorithm>
#include <cmath>
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

/// Largest absolute component.
inline double max_abs(const Vec3& v) { return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z))); }

/// Bound on the distance between ray.at(t) of a hit and the true surface, in the units of the ray's space. `extent` is the largest
/// absolute coordinate of the shape. Every test works in a frame near the shape and rounds each coordinate a few times, so the error is
/// a small multiple of 2^-53 of the largest number that took part: origin, path or shape. The tests assert it for every shape; rays that
/// graze a surface err more along themselves, but not away from the surface.
inline double hit_error(const Ray& ray, double t, double extent) {
    constexpr double roundings = 16.0;
    constexpr double half_ulp = 0x1p-53;
    return roundings * half_ulp * (max_abs(ray.origin) + std::fabs(t) * max_abs(ray.direction) + extent);
}

/// `b` moved outward by a few units in the last place of its largest coordinate: covers the rounding of computed corners.
inline Bounds rounded_outward(const Bounds& b) {
    const Vec3 margin(0x1p-50 * std::fmax(max_abs(b.min), max_abs(b.max)));
    return {b.min - margin, b.max + margin};
}

}  // namespace rt
