// Sphere sweep: all of the spheres whose centre and radius move along a curve together.
#pragma once

#include <array>
#include <vector>

#include "core/shared.h"
#include "geometry/hit_sink.h"

namespace rt {

/// A cubic piece of the curve by its Bernstein coefficients over u in [0, 1]. A radius below 0 counts as its absolute value.
struct SweepPiece {
    std::array<Vec3, 4> center{};
    std::array<double, 4> radius{};
    bool operator==(const SweepPiece&) const = default;
};

/// Where a sphere of the sweep's stands.
struct SweptSphere {
    Vec3 center{0.0};
    double radius = 0.0;
};

SweepPiece sweep_line(const SweptSphere& a, const SweptSphere& b);
/// From b to c, bent by the neighbours (Catmull and Rom's).
SweepPiece sweep_cubic(const SweptSphere& a, const SweptSphere& b, const SweptSphere& c, const SweptSphere& d);
/// The uniform cubic B-spline's piece that b and c are nearest to.
SweepPiece sweep_b_spline(const SweptSphere& a, const SweptSphere& b, const SweptSphere& c, const SweptSphere& d);

struct SphereSweep {
    Shared<std::vector<SweepPiece>> pieces;
    static constexpr const char* word = "sphere_sweep";
    bool operator==(const SphereSweep&) const = default;
};

/// Part i is the surface of piece i, met on its sphere at the parameter u. Only the outside of the whole is met: where pieces overlap there
/// is no surface inside.
void find_hits(const SphereSweep& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const SphereSweep& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const SphereSweep& shape, const Vec3& point);
Bounds bounds(const SphereSweep& shape);

}  // namespace rt
