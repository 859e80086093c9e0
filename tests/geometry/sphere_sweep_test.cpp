// Sphere sweeps beside many spheres along the same curve.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shape.h"
#include "tests/geometry/check_hits.h"

namespace rt::test::sphere_sweep_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<SweptSphere> points = {
    {{-1.2, -0.6, 0.0}, 0.3}, {{-0.4, 0.7, 0.3}, 0.2}, {{0.6, -0.2, -0.3}, 0.45}, {{1.2, 0.6, 0.2}, 0.2}, {{0.1, 1.0, 0.0}, 0.1}};

SphereSweep sweep(SweepPiece (*piece)(const SweptSphere&, const SweptSphere&, const SweptSphere&, const SweptSphere&)) {
    return {std::vector<SweepPiece>{piece(points[0], points[1], points[2], points[3]), piece(points[1], points[2], points[3], points[4])}};
}
SphereSweep lines() {
    std::vector<SweepPiece> pieces;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) pieces.push_back(sweep_line(points[i], points[i + 1]));
    return {pieces};
}

double bernstein(const std::array<double, 4>& b, double u) {
    const double v = 1.0 - u;
    return v * v * v * b[0] + 3.0 * v * v * u * b[1] + 3.0 * v * u * u * b[2] + u * u * u * b[3];
}
Sphere sphere_at(const SweepPiece& piece, double u) {
    Sphere s{Vec3(0.0), std::fabs(bernstein(piece.radius, u))};
    for (int k = 0; k < 3; ++k)
        s.center[k] = bernstein({piece.center[0][k], piece.center[1][k], piece.center[2][k], piece.center[3][k]}, u);
    return s;
}

/// The first hit with a thousand spheres, which lie inside of the sweep.
double first_of_spheres(const SphereSweep& shape, const Ray& ray) {
    double nearest = infinity;
    for (const SweepPiece& piece : *shape.pieces) {
        for (int i = 0; i <= 500; ++i) {
            ShapeHit hit;
            if (intersect(sphere_at(piece, i / 500.0), ray, {0.0, infinity}, hit)) nearest = std::fmin(nearest, hit.t);
        }
    }
    return nearest;
}

void check(const SphereSweep& shape, unsigned seed) {
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 target = sphere_at((*shape.pieces)[random.index(shape.pieces->size())], random.between(0.0, 1.0)).center;
        const Vec3 direction = random.direction();
        const Ray ray{target + random.in_cube(0.3) - 5.0 * direction, random.magnitude(0.1, 10.0) * direction};
        ShapeHit hit;
        const bool met = intersect(shape, ray, {0.0, infinity}, hit);
        const double expected = first_of_spheres(shape, ray);
        ASSERT_EQ(met, expected < infinity) << "ray " << i;
        if (!met) continue;
        ++hits;
        const double ahead = (expected - hit.t) * length(ray.direction);
        ASSERT_TRUE(ahead > -1e-12 && ahead < 2e-3) << "ray " << i << ": the sweep is ahead by " << ahead;
        const Vec3 p = ray.at(hit.t), n = unit(normal(shape, p, hit));
        const double error = hit_error(ray, hit.t, 2.0);
        ASSERT_TRUE(contains(shape, p - 8.0 * error * n)) << "ray " << i;
        ASSERT_FALSE(contains(shape, p + 8.0 * error * n)) << "ray " << i;
    }
    EXPECT_GT(hits, 200);
}

TEST(SphereSweeps, AreTheirSpheres) {
    check(lines(), 1);
    check(sweep(sweep_cubic), 2);
    check(sweep(sweep_b_spline), 3);
}

TEST(SphereSweeps, ParityIsTheInside) {
    check_inside(lines(), 1.5, 4);
    check_inside(sweep(sweep_cubic), 1.5, 5);
    check_inside(sweep(sweep_b_spline), 1.0, 6);
}

TEST(SphereSweeps, CurvesGoWhereTheirPointsSay) {
    const SweepPiece line = sweep_line(points[0], points[1]), cubic = sweep_cubic(points[0], points[1], points[2], points[3]);
    EXPECT_NEAR(length(sphere_at(line, 0.5).center - 0.5 * (points[0].center + points[1].center)), 0.0, 1e-15);
    EXPECT_EQ(cubic.center[0], points[1].center);
    EXPECT_EQ(cubic.center[3], points[2].center);
    EXPECT_EQ(cubic.radius[3], 0.45);
    // Catmull and Rom: half of the way between the neighbours is the slope.
    EXPECT_NEAR(length(3.0 * (cubic.center[1] - cubic.center[0]) - 0.5 * (points[2].center - points[0].center)), 0.0, 1e-15);
    const SweepPiece b = sweep_b_spline({{0, 0, 0}, 0.0}, {{6, 0, 0}, 6.0}, {{6, 6, 0}, 0.0}, {{0, 6, 0}, 0.0});
    EXPECT_NEAR(length(b.center[0] - Vec3(5, 1, 0)), 0.0, 1e-14);
    EXPECT_NEAR(length(b.center[1] - Vec3(6, 2, 0)), 0.0, 1e-14);
    EXPECT_NEAR(b.radius[0], 4.0, 1e-14);
    EXPECT_NEAR(b.radius[3], 1.0, 1e-14);
}

TEST(SphereSweeps, ARayAcrossAStraightSweepMeetsItsMiddle) {
    // Here the extremes of both ends lie on each other, and the polynomial whose roots they are only touches 0.
    const SweptSphere a{{-1, 0, 0}, 0.5}, b{{1, 0, 0}, 0.5};
    const SphereSweep straight{std::vector<SweepPiece>{sweep_line(a, b)}};
    EXPECT_THAT(all_hits(straight, {{0.25, 0.0, -2.0}, {0.0, 0.0, 1.0}}), ElementsAre(DoubleNear(1.5, 1e-15), DoubleNear(2.5, 1e-15)));
    EXPECT_THAT(all_hits(straight, {{-5.0, 0.3, 0.0}, {1.0, 0.0, 0.0}}), ElementsAre(DoubleNear(3.6, 1e-15), DoubleNear(6.4, 1e-15)));
    const SphereSweep barrel{
        std::vector<SweepPiece>{sweep_cubic({{-3, 0, 0}, 0.1}, {{-1, 0, 0}, 0.5}, {{1, 0, 0}, 0.5}, {{3, 0, 0}, 0.1})}};
    EXPECT_THAT(all_hits(barrel, {{0.0, 0.0, -2.0}, {0.0, 0.0, 1.0}}), ElementsAre(DoubleNear(1.45, 1e-15), DoubleNear(2.55, 1e-15)));
    EXPECT_THAT(all_hits(barrel, {{0.0, 0.7, -2.0}, {0.0, 0.0, 1.0}}), IsEmpty());
}

TEST(SphereSweeps, WhatLiesInsideIsNoSurface) {
    const SphereSweep bent{std::vector<SweepPiece>{sweep_line({{-1, 0, 0}, 0.5}, {{0, 0, 0}, 0.5}),
                                                   sweep_line({{0, 0, 0}, 0.5}, {{1, 0, 0}, 0.2}),
                                                   sweep_line({{1, 0, 0}, 0.2}, {{1, 3, 0}, 0.2})}};
    EXPECT_EQ(all_hits(bent, {{-5, 0, 0}, {1, 0, 0}}).size(), 2u);
    EXPECT_EQ(all_hits(bent, {{-5, 1, 0}, {1, 0, 0}}).size(), 2u);
    const SphereSweep nested{std::vector<SweepPiece>{sweep_line({{0, 0, 0}, 1.0}, {{0.2, 0, 0}, 0.1})}};
    EXPECT_THAT(all_hits(nested, {{-5, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(4.0, 1e-15), DoubleNear(6.0, 1e-15)));
}

TEST(SphereSweeps, SurviveAnyRay) {
    const SphereSweep shape = sweep(sweep_cubic);
    for (const double bad : {1e-300, 1e300, infinity, std::nan("")}) {
        EXPECT_LT(all_hits(shape, {Vec3(bad, 0.0, 1.0), Vec3(0.0, -1.0, bad)}).size(), 10u);
        EXPECT_FALSE(contains(shape, Vec3(std::nan(""), bad, 0.5)));
    }
}

}  // namespace
}  // namespace rt::test::sphere_sweep_test
