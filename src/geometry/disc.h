// Flat disc with an optional round hole.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Disc {
    Vec3 center{0.0};
    Vec3 normal{0.0, 1.0, 0.0};  ///< unit
    double radius = 1.0;
    double hole_radius = 0.0;
    bool operator==(const Disc&) const = default;
};

/// Both radii belong to the surface.
inline bool intersect(const Disc& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    const Vec3 f = ray.origin - shape.center;
    const double t = -dot(f, shape.normal) / dot(ray.direction, shape.normal);
    if (!range.contains(t)) return false;
    const Vec3 p = f + t * ray.direction;
    const double r2 = dot(p, p);
    if (!(r2 <= shape.radius * shape.radius && r2 >= shape.hole_radius * shape.hole_radius)) return false;
    hit.t = t;
    return true;
}

inline Vec3 normal(const Disc& shape, const Vec3&, const ShapeHit&) { return shape.normal; }

/// The half space behind the disc.
inline bool contains(const Disc& shape, const Vec3& p) { return dot(p - shape.center, shape.normal) < 0.0; }

Bounds bounds(const Disc& shape);

}  // namespace rt
