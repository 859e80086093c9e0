// Superellipsoid: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1.
#pragma once

#include "geometry/hit_sink.h"

namespace rt {

struct Superellipsoid {
    double east_west = 1.0;    ///< e > 0
    double north_south = 1.0;  ///< n > 0
    static constexpr const char* word = "superellipsoid";
    bool operator==(const Superellipsoid&) const = default;
};

/// Convex ones (e and n up to 2) are met exactly where they are. Of others, which have cusps, a ray that enters and leaves within a 1/4000
/// of the shape's size may pass unnoticed. The distance from the surface is a small multiple of 2^-53.
void find_hits(const Superellipsoid& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Superellipsoid& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const Superellipsoid& shape, const Vec3& point);
Bounds bounds(const Superellipsoid& shape);

}  // namespace rt
