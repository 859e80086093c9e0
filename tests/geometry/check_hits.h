// All hits of rays with a shape, and their parity.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "geometry/hits.h"
#include "tests/geometry/quad.h"

namespace rt::test {

inline std::vector<double> all_hits(const auto& shape, const Ray& ray) {
    std::vector<double> ts;
    visit_hits(shape, ray, {-infinity, infinity}, [&](const ShapeHit& hit) {
        ts.push_back(hit.t);
        return false;
    });
    return ts;
}

/// Random rays at the solid: between two hits in a row the inside is the other of what it was before.
template <typename S>
void check_inside(const S& shape, double size, unsigned seed) {
    Random random(seed);
    const Bounds b = bounds(shape);
    const Vec3 center = b.is_finite() ? 0.5 * (b.min + b.max) : Vec3(0.0);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = aimed_at(center + random.in_cube(size), size, random);
        std::vector<double> ts = all_hits(shape, ray);
        if (ts.empty()) continue;
        ++met;
        const double reach = 10.0 * size / length(ray.direction);
        ts.insert(ts.begin(), ts.front() - reach);
        ts.push_back(ts.back() + reach);
        for (std::size_t k = 2; k < ts.size(); ++k) {
            ASSERT_LT(ts[k - 1], ts[k]);
            const double before = 0.5 * (ts[k - 2] + ts[k - 1]), behind = 0.5 * (ts[k - 1] + ts[k]);
            ASSERT_NE(contains(shape, ray.at(before)), contains(shape, ray.at(behind))) << "ray " << i << " hit " << k - 1;
        }
    }
    ASSERT_GT(met, 100);
}

}  // namespace rt::test
