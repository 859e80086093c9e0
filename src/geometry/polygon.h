// Planar polygon, even-odd rule over all of its closed contours.
#pragma once

#include <vector>

#include "geometry/hit.h"

namespace rt {

struct Polygon {
    std::vector<Vec3> points;  ///< contours one after the other, each closed by repeating its first point
    bool operator==(const Polygon&) const = default;
};

bool intersect(const Polygon& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Polygon& shape, const Vec3& point, const ShapeHit& hit);
inline bool contains(const Polygon&, const Vec3&) { return false; }
Bounds bounds(const Polygon& shape);

}  // namespace rt
