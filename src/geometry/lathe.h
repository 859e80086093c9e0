// Lathe: a curve in the half plane of radius and y, turned around the y axis.
#pragma once

#include "core/shared.h"
#include "geometry/outline.h"

namespace rt {

struct Lathe {
    Shared<Outline> curve;  ///< in (radius, y); need not be closed
    bool turned = false;    ///< its pieces are in the other order than stated
    static constexpr const char* word = "lathe";
    bool operator==(const Lathe&) const = default;
};

/// Part i is the surface of piece i, met at its parameter u. Hits are refined until the ray's point and the curve's agree, so they are as
/// exact as the curve's points; only where a ray within 1e-5 of horizontal touches a rim that is horizontal as well may two be lost.
void find_hits(const Lathe& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Lathe& shape, const Vec3& point, const ShapeHit& hit);
/// The share of the stated curve before a hit, all pieces counting alike.
double along_curve(const Lathe& shape, const ShapeHit& hit);
/// By how often the curve is crossed on the way out at the point's height.
bool contains(const Lathe& shape, const Vec3& point);
Bounds bounds(const Lathe& shape);

}  // namespace rt
