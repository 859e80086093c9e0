// Plane: the points p with p . normal = distance; inside is the side opposite to the normal. The one unbounded shape.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Plane {
    Vec3 normal{0.0, 1.0, 0.0};  ///< unit
    double distance = 0.0;       ///< along the unit normal
    bool operator==(const Plane&) const = default;
};

/// A parallel ray divides by zero: infinity and NaN lie in no interval.
[[gnu::always_inline]] inline bool intersect(const Plane& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    const double t = (shape.distance - dot(ray.origin, shape.normal)) / dot(ray.direction, shape.normal);
    if (!range.contains(t)) return false;
    hit.t = t;
    return true;
}

inline Vec3 normal(const Plane& shape, const Vec3&, const ShapeHit&) { return shape.normal; }

/// With POV-Ray's tolerance: the plane itself counts as inside.
inline bool contains(const Plane& shape, const Vec3& p) { return dot(p, shape.normal) - shape.distance < 1e-10; }

inline Bounds bounds(const Plane&) { return Bounds::everything(); }

}  // namespace rt
