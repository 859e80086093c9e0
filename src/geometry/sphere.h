// Sphere.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Sphere {
    Vec3 center{0.0};
    double radius = 1.0;
    bool operator==(const Sphere&) const = default;
};

bool intersect(const Sphere& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Sphere& shape, const Vec3& point, const ShapeHit& hit);
Bounds bounds(const Sphere& shape);

}  // namespace rt
