// Plane: the points p with p . normal = distance; inside is the side opposite to the normal. The one unbounded shape.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Plane {
    Vec3 normal{0.0, 1.0, 0.0};  ///< unit
    double distance = 0.0;       ///< along the unit normal
    bool operator==(const Plane&) const = default;
};

bool intersect(const Plane& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Plane& shape, const Vec3& point, const ShapeHit& hit);
Bounds bounds(const Plane& shape);

}  // namespace rt
