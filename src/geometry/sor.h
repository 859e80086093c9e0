// Surface of revolution: the square of the radius is a cubic function of y in each of several slices.
#pragma once

#include <array>
#include <vector>

#include "core/shared.h"
#include "geometry/hit_sink.h"

namespace rt {

/// r^2 over y from low to high, by its four Bernstein coefficients.
struct SorSlice {
    double low = 0.0, high = 1.0;
    std::array<double, 4> radius2{};
    bool operator==(const SorSlice&) const = default;
};

struct Sor {
    Shared<std::vector<SorSlice>> slices;  ///< upwards, each beginning where the one below ends
    bool open = false;                     ///< without the two discs
    static constexpr const char* word = "sor";
    bool operator==(const Sor&) const = default;
};

/// Part 0 is the lower disc, 1 the upper one, 2 + i the side of slice i.
void find_hits(const Sor& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Sor& shape, const Vec3& point, const ShapeHit& hit);
/// The share of the curve below a hit, all slices counting alike.
double along_curve(const Sor& shape, const Vec3& point, const ShapeHit& hit);
/// An open one is closed by its discs here.
bool contains(const Sor& shape, const Vec3& point);
Bounds bounds(const Sor& shape);

}  // namespace rt
