// Whether a point is inside a shape, in the shape's own space. Bodies are closed by their caps even where these are left open.
#pragma once

#include "geometry/shape.h"

namespace rt {

inline bool inside(const Sphere& s, const Vec3& p) { return dot(p - s.center, p - s.center) < sqr(s.radius); }

inline bool inside(const Plane& s, const Vec3& p) { return dot(p, s.normal) - s.distance < 1e-10; }

inline bool inside(const Box& s, const Vec3& p) {
    return p.x > s.min.x && p.x < s.max.x && p.y > s.min.y && p.y < s.max.y && p.z > s.min.z && p.z < s.max.z;
}

inline bool inside(const Cone& s, const Vec3& p) {
    const Vec3 axis = s.cap - s.base;
    const Vec3 from_base = p - s.base;
    const double along = dot(from_base, axis) / dot(axis, axis);
    if (!(along > 0.0 && along < 1.0)) return false;
    return length(from_base - along * axis) < std::fabs(s.base_radius + along * (s.cap_radius - s.base_radius));
}

inline bool inside(const Torus& s, const Vec3& p) {
    const double from_circle = std::sqrt(sqr(p.x) + sqr(p.z)) - std::fabs(s.major_radius);
    return sqr(from_circle) + sqr(p.y) < sqr(s.minor_radius);
}

/// The half space behind the disc.
inline bool inside(const Disc& s, const Vec3& p) { return dot(p - s.center, s.normal) < 0.0; }

/// A polygon is a sheet.
inline bool inside(const Polygon&, const Vec3&) { return false; }

}  // namespace rt
