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

bool intersect(const Disc& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Disc& shape, const Vec3& point, const ShapeHit& hit);
Bounds bounds(const Disc& shape);

}  // namespace rt
