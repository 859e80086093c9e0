// Axis-aligned box. Part 0..5 is the face -x +x -y +y -z +z.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Box {
    Vec3 min{-1.0};  ///< componentwise <= max
    Vec3 max{1.0};
    bool operator==(const Box&) const = default;
};

bool intersect(const Box& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Box& shape, const Vec3& point, const ShapeHit& hit);
Bounds bounds(const Box& shape);

}  // namespace rt
