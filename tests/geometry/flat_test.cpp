// Plane, disc, triangle and polygon against plane equations and areas in quadruple precision.
#include <gtest/gtest.h>

#include "geometry/shape.h"
#include "tests/geometry/quad.h"

namespace rt::test::flat_test {
namespace {

constexpr int rounds = 30000;

/// Where the line meets the plane through `p` with normal `n`.
Quad plane_t(const Ray& ray, const Quad3& p, const Quad3& n) { return dot(p - Quad3(ray.origin), n) / dot(ray.direction, n); }

/// How far the hit can be displaced: the bound is across the surface; along the ray, and in the plane, it grows with 1 / cosine.
Quad displacement(const Ray& ray, double t, double extent, const Quad3& n) {
    const Quad cosine = abs(dot(ray.direction, n)) / (length(ray.direction) * length(n));
    return Quad(hit_error(ray, t, extent)) * (1 + 1 / cosine);
}

/// `margin` is how far inside the outline the exact hit lies, negative outside.
template <typename S>
void check(const S& shape, const Ray& ray, double extent, const Quad3& p, const Quad3& n, Quad margin) {
    const Quad exact = plane_t(ray, p, n);
    const Quad allowed = displacement(ray, static_cast<double>(exact), extent, n);
    const Quad allowed_t = allowed / length(ray.direction);
    ShapeHit hit;
    if (intersect(shape, ray, {}, hit)) {
        ASSERT_LE(static_cast<double>(abs(hit.t - exact) / allowed_t), 1.0);
        ASSERT_GE(static_cast<double>(margin), -static_cast<double>(allowed));
        ASSERT_FALSE(intersect(shape, ray, {hit.t, infinity}, hit)) << "the interval is open";
        ASSERT_FALSE(intersect(shape, ray, {-infinity, hit.t}, hit)) << "the interval is open";
    } else {
        ASSERT_FALSE(exact > allowed_t && margin > allowed);
    }
}

TEST(Plane, AgreesWithQuadruplePrecision) {
    Random random(1);
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Vec3 n = random.direction();
        const Plane plane{n, random.between(-size, size)};
        const Ray ray = aimed_at(plane.distance * n + size * cross(n, random.direction()), size, random);
        // The point with n . p = distance: n is unit only to rounding.
        const Quad3 p = (Quad(plane.distance) / dot(Quad3(n), Quad3(n))) * Quad3(n);
        check(plane, ray, 2.0 * size, p, n, 1e30);
        if (HasFatalFailure()) FAIL() << "round " << i;
    }
    ShapeHit hit;
    EXPECT_FALSE(intersect(Plane{}, {{0, 1, 0}, {1, 0, 0}}, {}, hit));
    EXPECT_FALSE(intersect(Plane{}, {{0, 0, 0}, {1, 0, 0}}, {}, hit));
}

TEST(Disc, AgreesWithQuadruplePrecision) {
    Random random(2);
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Vec3 n = random.direction();
        const Disc disc{random.in_cube(random.coin() ? 0.0 : 10.0 * size), n, size, random.coin() ? 0.0 : 0.6 * size};
        const double r = random.index(3) == 0 ? size : random.index(2) == 0 ? disc.hole_radius : random.between(0, 1.2 * size);
        const Ray ray = aimed_at(disc.center + r * unit(cross(n, random.direction())), size, random);
        const Quad at_radius = length(at(ray, plane_t(ray, disc.center, n)) - Quad3(disc.center));
        Quad margin = Quad(disc.radius) - at_radius;
        if (disc.hole_radius > 0.0) margin = min(margin, at_radius - Quad(disc.hole_radius));
        check(disc, ray, max_abs(disc.center) + size, disc.center, n, margin);
        if (HasFatalFailure()) FAIL() << "round " << i;
    }
}

TEST(Disc, BothRadiiBelongToIt) {
    const Disc ring{{0, 0, 0}, {0, 1, 0}, 2.0, 1.0};
    ShapeHit hit;
    for (const double x : {1.0, 2.0}) EXPECT_TRUE(intersect(ring, {{x, 3, 0}, {0, -1, 0}}, {}, hit));
    for (const double x : {std::nextafter(1.0, 0.0), std::nextafter(2.0, 3.0)})
        EXPECT_FALSE(intersect(ring, {{x, 3, 0}, {0, -1, 0}}, {}, hit));
}

/// Least distance of `p` from the sides of the triangle, negative outside; n = cross(b - a, c - a).
Quad triangle_margin(const Quad3& p, const Triangle& s, const Quad3& n) {
    const Quad3 corners[] = {s.a, s.b, s.c};
    Quad least = 1e30;
    for (int k = 0; k < 3; ++k) {
        const Quad3 side = corners[(k + 1) % 3] - corners[k];
        least = min(least, dot(cross(side, p - corners[k]), n) / (length(n) * length(side)));
    }
    return least;
}

TEST(Triangle, AgreesWithQuadruplePrecision) {
    Random random(3);
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Vec3 center = random.in_cube(random.coin() ? 0.0 : 10.0 * size);
        Triangle s{center + random.in_cube(size), center + random.in_cube(size), center + random.in_cube(size)};
        if (i % 5 == 0) s.c = 0.5 * (s.a + s.b) + 1e-5 * random.in_cube(size);  // a needle
        double u = random.between(-0.1, 1.0), v = random.between(-0.1, 1.0);
        if (i % 3 == 0) u = 0.0;
        if (i % 7 == 0) v = 1.0;
        if (u + v > 1.1) continue;
        const Ray ray = aimed_at(s.a + u * (s.b - s.a) + v * (s.c - s.a), size, random);
        const Quad3 n = cross(Quad3(s.b) - s.a, Quad3(s.c) - s.a);
        const Quad3 p = at(ray, plane_t(ray, s.a, n));
        check(s, ray, max_abs(center) + size, s.a, n, triangle_margin(p, s, n));
        if (HasFatalFailure()) FAIL() << "round " << i;
    }
}

TEST(Triangle, WeightsInterpolateTheHitPoint) {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const SmoothTriangle s{random.in_cube(1),  random.in_cube(1),  random.in_cube(1),
                               random.direction(), random.direction(), random.direction()};
        const double u = random.between(0.1, 0.4), v = random.between(0.1, 0.4);
        const Vec3 target = (1 - u - v) * s.a + u * s.b + v * s.c;
        const Vec3 n = cross(s.b - s.a, s.c - s.a);
        if (length(n) < 1e-2) continue;
        const Ray ray{target + unit(n), -unit(n)};
        ShapeHit hit;
        ASSERT_TRUE(intersect(s, ray, {}, hit));
        EXPECT_NEAR(hit.t, 1.0, 1e-13);
        EXPECT_NEAR(hit.u, u, 1e-12);
        EXPECT_NEAR(hit.v, v, 1e-12);
        const Vec3 expected = (1 - u - v) * s.normal_a + u * s.normal_b + v * s.normal_c;
        EXPECT_NEAR(length(normal(s, target, hit) - expected), 0.0, 1e-11);
    }
}

TEST(Triangle, WithoutAreaIsNeverHit) {
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = random.in_cube(1), step(0x1p-3 * std::round(random.between(1, 8)));
        ShapeHit hit;
        const Triangle repeated{a, a + step, a};
        const Vec3 on_line(std::round(8 * random.between(-4, 4)) / 8);
        const Triangle collinear{on_line, on_line + step, on_line + 3.0 * step};
        ASSERT_FALSE(intersect(repeated, aimed_at(a + random.between(0, 1) * step, 1.0, random), {}, hit));
        ASSERT_FALSE(intersect(collinear, aimed_at(on_line + random.between(0, 3) * step, 1.0, random), {}, hit));
    }
}

/// A star outline with a square hole, in the plane z = 0 and then placed anywhere. Corners in counterclockwise order, the hole clockwise.
struct Star {
    std::vector<Vec2> outline, hole{{-0.2, -0.2}, {-0.2, 0.2}, {0.2, 0.2}, {0.2, -0.2}};
    Star() {
        for (int k = 0; k < 10; ++k) {
            const double r = k % 2 == 0 ? 1.0 : 0.45, angle = k * pi / 5;
            outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
    }
};

/// Winding angle of a closed contour around p: the even-odd answer for simple contours, by another road.
bool winds_around(const std::vector<Vec2>& contour, const Vec2& p) {
    double angle = 0.0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Vec2 a = contour[i] - p, b = contour[(i + 1) % contour.size()] - p;
        angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    }
    return std::fabs(angle) > pi;
}

TEST(Polygon, EvenOddOverSeveralContours) {
    Random random(6);
    const Star star;
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Vec3 center = random.in_cube(10.0 * size);
        const Vec3 n = random.direction(), e1 = unit(cross(n, random.direction())), e2 = cross(n, e1);
        const auto place = [&](const Vec2& q) { return center + size * (q.x * e1 + q.y * e2); };
        Polygon polygon;
        for (const auto* contour : {&star.outline, &star.hole}) {
            for (const Vec2& q : *contour) polygon.points.push_back(place(q));
            polygon.points.push_back(place(contour->front()));
        }
        const Vec2 q(random.between(-1.1, 1.1), random.between(-1.1, 1.1));
        const bool expected = winds_around(star.outline, q) && !winds_around(star.hole, q);
        const Vec3 target = place(q);
        const Vec3 direction = unit(n + 0.5 * random.direction());
        const Ray ray{target - 3.0 * size * direction, direction};
        ShapeHit hit;
        ASSERT_EQ(intersect(polygon, ray, {}, hit), expected) << "round " << i;
        if (!expected) continue;
        ASSERT_LE(std::fabs(hit.t - 3.0 * size), 1e-13 * size * 30) << "round " << i;
        ASSERT_NEAR(std::fabs(dot(unit(normal(polygon, target, hit)), n)), 1.0, 1e-12);
    }
}

TEST(Polygon, AVertexOnTheWalkCountsOnce) {
    // Diamond: walks in every direction from the middle, and from outside, pass exactly through vertices.
    const Polygon diamond{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}}};
    ShapeHit hit;
    EXPECT_TRUE(intersect(diamond, {{0, 0, -1}, {0, 0, 1}}, {}, hit));
    for (const Vec3& outside : {Vec3(-2, 0, -1), Vec3(2, 0, -1), Vec3(0, 2, -1), Vec3(0, -2, -1), Vec3(-2, 1, -1), Vec3(-2, -1, -1)})
        EXPECT_FALSE(intersect(diamond, {outside, {0, 0, 1}}, {}, hit));
}

TEST(Polygon, TwoThatShareAnEdgeLeaveNoGapAndDoNotOverlap) {
    const Polygon left{{{-1, -1, 0}, {0.1, -1, 0}, {0.3, 1, 0}, {-1, 1, 0}, {-1, -1, 0}}};
    const Polygon right{{{0.1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0.3, 1, 0}, {0.1, -1, 0}}};
    Random random(7);
    for (int i = 0; i < 20000; ++i) {
        const double s = random.between(0, 1);
        const Vec3 p = Vec3(0.1, -1, 0) + s * Vec3(0.2, 2, 0);
        ShapeHit hit;
        const Ray ray{p + Vec3(0, 0, 1), {0, 0, -1}};
        ASSERT_EQ(intersect(left, ray, {}, hit) + intersect(right, ray, {}, hit), 1) << "at " << s;
    }
}

TEST(Polygon, ContoursOfOppositeSenseDoNotCancelThePlane) {
    const Polygon two{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 1, 0}, {3, 0, 0}, {2, 0, 0}}};
    ShapeHit hit;
    EXPECT_TRUE(intersect(two, {{0.5, 0.5, -1}, {0, 0, 1}}, {}, hit));
    EXPECT_TRUE(intersect(two, {{2.5, 0.5, -1}, {0, 0, 1}}, {}, hit));
    EXPECT_FALSE(intersect(two, {{1.5, 0.5, -1}, {0, 0, 1}}, {}, hit));
}

TEST(Polygon, HalvesOfAnOutlineThatCrossesItselfDoNotCancelThePlane) {
    const Polygon bow{{{-1, -1, 2}, {1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {-1, -1, 2}}};
    ShapeHit hit;
    for (const double y : {-0.5, 0.5}) {
        ASSERT_TRUE(intersect(bow, {{0.1, y, 0}, {0, 0, 1}}, {}, hit));
        EXPECT_EQ(hit.t, 2.0);
    }
    EXPECT_FALSE(intersect(bow, {{0.5, 0.1, 0}, {0, 0, 1}}, {}, hit));
    EXPECT_FALSE(intersect(bow, {{-0.5, 0.1, 0}, {0, 0, 1}}, {}, hit));
    EXPECT_EQ(std::fabs(unit(normal(bow, {0, 0.5, 2}, hit)).z), 1.0);
}

}  // namespace
}  // namespace rt::test::flat_test
