// Quadric: A x^2 + B y^2 + C z^2 + D x y + E x z + F y z + G x + H y + I z + J = 0, inside where it is negative.
#pragma once

#include "geometry/hit_sink.h"

namespace rt {

struct Quadric {
    Vec3 squares{1.0};   ///< A, B, C
    Vec3 products{0.0};  ///< D, E, F: of x y, x z, y z
    Vec3 linear{0.0};    ///< G, H, I
    double constant = -1.0;
    static constexpr const char* word = "quadric";
    bool operator==(const Quadric&) const = default;
};

/// A hit is wrong by a small multiple of 2^-53 of the terms' sizes divided by the gradient's length; near an ellipsoid or a surface as wide
/// as it is far from the origin that is `hit_error`, near the tip of a cone it is more.
void find_hits(const Quadric& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Quadric& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const Quadric& shape, const Vec3& point);
/// Finite for ellipsoids.
Bounds bounds(const Quadric& shape);

}  // namespace rt
