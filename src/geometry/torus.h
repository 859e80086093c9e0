// Torus around the y axis. If only the major radius is negative, it exists only where it is seen through the drum around a torus as
// wide as the sum of the radii.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Torus {
    double major_radius = 1.0;
    double minor_radius = 0.5;
    bool operator==(const Torus&) const = default;
};

bool intersect(const Torus& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Torus& shape, const Vec3& point, const ShapeHit& hit);
/// Within the tube; where the tube meets itself around the axis, there too.
bool contains(const Torus& shape, const Vec3& point);
Bounds bounds(const Torus& shape);

}  // namespace rt
