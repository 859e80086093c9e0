// Flat and smooth triangles. The ray test is watertight (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection") in doubles:
// a ray that crosses an edge or a vertex shared by several triangles meets at least one of them.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Triangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};
    bool operator==(const Triangle&) const = default;
};

struct SmoothTriangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};
    Vec3 normal_a{0.0}, normal_b{0.0}, normal_c{0.0};  ///< unit
    bool operator==(const SmoothTriangle&) const = default;
};

/// What the test of one ray against many triangles shares: the axis permutation and the shear that take the ray to the +z axis.
struct TriangleRay {
    explicit TriangleRay(const Ray& ray);
    Vec3 origin;
    int kx, ky, kz;
    double sx, sy, sz;
};

/// Vertices in counter- or clockwise order, both sides count. Sets t, u (weight of b) and v (weight of c).
bool intersect(const Vec3& a, const Vec3& b, const Vec3& c, const TriangleRay& ray, const Interval& range, ShapeHit& hit);

bool intersect(const Triangle& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const Triangle& shape, const Vec3& point, const ShapeHit& hit);
Bounds bounds(const Triangle& shape);

bool intersect(const SmoothTriangle& shape, const Ray& ray, const Interval& range, ShapeHit& hit);
Vec3 normal(const SmoothTriangle& shape, const Vec3& point, const ShapeHit& hit);
Bounds bounds(const SmoothTriangle& shape);

}  // namespace rt
