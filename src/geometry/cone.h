// Cone frustum; with equal radii a cylinder, with radii of opposite sign two cones tip to tip. Part 0 is the side, 1 the base cap, 2 the
// top cap.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Cone {
    Vec3 base{0.0};
    double base_radius = 1.0;
    Vec3 cap{0.0, 1.0, 0.0};  ///< differs from base
    double cap_radius = 1.0;
    bool open = false;  ///< without the two discs
    bool operator==(const Cone&) const = default;
};

bool intersect(const Cone& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Cone& shape, const Vec3& point, const ShapeHit& hit);
/// An open cone is closed by its caps here.
bool contains(const Cone& shape, const Vec3& point);
Bounds bounds(const Cone& shape);

}  // namespace rt
