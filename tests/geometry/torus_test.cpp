// The torus against Sturm's theorem: the number of roots of its quartic in an interval, counted in quadruple precision.
#include <gtest/gtest.h>

#include <vector>

#include "geometry/torus.h"
#include "tests/geometry/sturm.h"

namespace rt::test::torus_test {
namespace {

/// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) along a line.
Polynomial quartic(const Torus& torus, const Quad3& o, const Quad3& d, Quad grown) {
    const Quad R = torus.major_radius, r = Quad(torus.minor_radius) + grown;
    const Quad a = dot(d, d), b = 2 * dot(o, d), c = dot(o, o) + R * R - r * r;
    const Quad e = d.x * d.x + d.z * d.z, f = 2 * (o.x * d.x + o.z * d.z), g = o.x * o.x + o.z * o.z, k = 4 * R * R;
    return {a * a, 2 * a * b, b * b + 2 * a * c - k * e, 2 * b * c - k * f, c * c - k * g};
}

/// Roots that a tube thinner by `error` and one thicker by it both have in (lo, hi]: they are no grazing contacts. Counted from the point
/// of the ray nearest to the centre, without which even these digits would not do for far origins.
int sure_roots(const Torus& torus, const Ray& ray, Quad lo, Quad hi, Quad error) {
    const Quad nearest = -dot(ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    const Quad3 o = at(ray, nearest), d = ray.direction;
    return std::min(count_roots(quartic(torus, o, d, -error), lo - nearest, hi - nearest),
                    count_roots(quartic(torus, o, d, error), lo - nearest, hi - nearest));
}

/// Distance of a point from the tube's surface.
Quad surface_distance(const Torus& torus, const Quad3& p) {
    const Quad rho = sqrt(p.x * p.x + p.z * p.z), out = rho - Quad(torus.major_radius), in = rho + Quad(torus.major_radius);
    const Quad r = torus.minor_radius;
    return min(abs(sqrt(out * out + p.y * p.y) - r), abs(sqrt(in * in + p.y * p.y) - r));  // `in`: the inner sheet of a spindle
}

void check(const Torus& torus, const Ray& ray, const Interval& range, ShapeHit& hit, bool& found) {
    const double extent = torus.major_radius + torus.minor_radius;
    found = intersect(torus, ray, range, hit);
    const double speed = length(ray.direction);
    const double reach = (length(ray.origin) + extent) / speed;
    const Quad end = min(range.max, 2 * reach);
    const Quad error = hit_error(ray, reach, extent);
    if (!found) {
        ASSERT_LE(sure_roots(torus, ray, range.min, end, error), 0);
        return;
    }
    ASSERT_TRUE(range.contains(hit.t));
    ASSERT_LE(static_cast<double>(surface_distance(torus, at(ray, hit.t)) / error), 1.0);
    const Quad before = Quad(hit.t) - error * 4 / speed;
    ASSERT_LE(sure_roots(torus, ray, range.min, before, error), 0) << "a nearer root was missed";
}

Vec3 on_surface(const Torus& torus, double around, double tube) {
    const double rho = torus.major_radius + torus.minor_radius * std::cos(tube);
    return {rho * std::cos(around), torus.minor_radius * std::sin(tube), rho * std::sin(around)};
}

TEST(Torus, AgreesWithSturmCounts) {
    Random random(1);
    for (int i = 0; i < 6000; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Torus torus{size, size * (i % 4 == 0 ? random.between(1.0, 2.0) : random.magnitude(1e-3, 1.0))};  // some are spindles
        const Vec3 target = on_surface(torus, random.between(0, 2 * pi), random.between(0, 2 * pi));
        Ray ray = aimed_at(target, size, random);
        if (i % 5 == 0) ray.direction.y = 0.0;
        if (i % 11 == 0) ray.direction = {0, random.coin() ? 1.0 : -1.0, 0};
        if (length(ray.direction) == 0.0) continue;
        // Walk through all hits.
        Interval range;
        int hits = 0;
        for (bool found = true; found && hits < 6; ++hits) {
            ShapeHit hit;
            check(torus, ray, range, hit, found);
            if (HasFatalFailure()) FAIL() << "round " << i << " hit " << hits;
            range.min = hit.t + 1e-6 * size / length(ray.direction);
        }
        ASSERT_LE(hits, 5);
    }
}

TEST(Torus, FourHitsAlongADiameter) {
    const Torus torus{1.0, 0.25};
    const Ray ray{{-5, 0, 0}, {2, 0, 0}};
    double after = 0.0;
    for (const double t : {3.75 / 2, 4.25 / 2, 5.75 / 2, 6.25 / 2}) {
        ShapeHit hit;
        ASSERT_TRUE(intersect(torus, ray, {after, infinity}, hit));
        EXPECT_NEAR(hit.t, t, 4e-16 * 8);
        after = hit.t + 1e-9;
    }
    ShapeHit hit;
    EXPECT_FALSE(intersect(torus, ray, {after, infinity}, hit));
    EXPECT_FALSE(intersect(torus, ray, {3.75 / 2 + 1e-9, 4.25 / 2 - 1e-9}, hit));
}

TEST(Torus, DoubleRootsDoNotUnsettleTheOthers) {
    // Along a tangent of the inner equator: it touches at x = 0 and crosses the tube on both sides.
    const Torus torus{1.0, 0.25};
    const Ray ray{{-5, 0, 0.75}, {1, 0, 0}};
    const double half_outer = std::sqrt(1.25 * 1.25 - 0.75 * 0.75);
    ShapeHit hit;
    ASSERT_TRUE(intersect(torus, ray, {}, hit));
    EXPECT_NEAR(hit.t, 5 - half_outer, 1e-14);
    ASSERT_TRUE(intersect(torus, ray, {5 + 1e-3, infinity}, hit));
    EXPECT_NEAR(hit.t, 5 + half_outer, 1e-14);
    // Across the top, y = r: the quartic has two double roots; the ray touches and does not enter.
    EXPECT_FALSE(intersect(torus, {{-5, 0.25 + 1e-15, 0}, {1, 0, 0}}, {}, hit));
    ASSERT_TRUE(intersect(torus, {{-5, 0.25 - 1e-12, 0}, {1, 0, 0}}, {}, hit));
    EXPECT_NEAR(hit.t, 4.0 - std::sqrt(0.25 * 0.25 - sqr(0.25 - 1e-12)), 1e-8);
}

// What POV-Ray shows of torus { -1, 0.3 }: the tube where it is seen through the drum rho < 0.7, |y| < 0.3, lit as from the far side.
TEST(Torus, NegativeMajorRadiusIsSeenThroughADrum) {
    const Torus torus{-1.0, 0.3};
    ShapeHit hit;
    ASSERT_TRUE(intersect(torus, {{0.6, 0, -3}, {0, 0, 1}}, {}, hit));
    EXPECT_NEAR(hit.t, 3.0 - std::sqrt(1.69 - 0.36), 1e-14);
    EXPECT_FALSE(intersect(torus, {{0.75, 0, -3}, {0, 0, 1}}, {}, hit));  // beside the drum
    EXPECT_FALSE(intersect(torus, {{1.0, 3, 0}, {0, -1, 0}}, {}, hit));   // outside of it
    EXPECT_FALSE(intersect(torus, {{0, 3, 0}, {0, -1, 0}}, {}, hit));     // through the hole
    EXPECT_FALSE(intersect(torus, {{-2, 3.1, 0}, {1, -1, 0}}, {}, hit));  // over the drum to the far wall
    const Vec3 n = unit(normal(torus, {1.3, 0, 0}, hit));
    EXPECT_NEAR(length(n - Vec3(1, 0, 0)), 0.0, 1e-15);
    EXPECT_NEAR(length(unit(normal(torus, {0.7, 0, 0}, hit)) - Vec3(1, 0, 0)), 0.0, 1e-15);
}

}  // namespace
}  // namespace rt::test::torus_test
