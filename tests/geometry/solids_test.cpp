// Sphere, box and closed cone against textbook intersections in quadruple precision. The solids are convex: a line is inside for one
// stretch. The oracle gives that stretch for the solid grown and shrunk by the documented error bound, and the hit must lie between.
#include <gtest/gtest.h>

#include <optional>

#include "geometry/shape.h"
#include "tests/geometry/quad.h"

namespace rt::test::solids_test {
namespace {

struct Stretch {
    Quad enter, leave;
};
using Inside = std::optional<Stretch>;

constexpr double forever = 1e30;

Inside common(const Inside& a, const Inside& b) {
    if (!a || !b) return {};
    const Stretch both{max(a->enter, b->enter), min(a->leave, b->leave)};
    return both.enter <= both.leave ? Inside(both) : Inside();
}

/// Where normal . p <= distance along the line.
Inside half_space(const Ray& ray, const Quad3& normal, Quad distance) {
    const Quad along = dot(ray.direction, normal), rest = distance - dot(ray.origin, normal);
    if (along == 0) return rest >= 0 ? Inside(Stretch{-forever, forever}) : Inside();
    return along > 0 ? Stretch{-forever, rest / along} : Stretch{rest / along, forever};
}

Inside inside(const Sphere& s, const Ray& ray, Quad grown) {
    const Quad r = max(Quad(s.radius) + grown, 0);
    const Quad3 f = Quad3(ray.origin) - s.center, d = ray.direction;
    const Quad a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - r * r, discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    return Stretch{(-b - sqrt(discriminant)) / (2 * a), (-b + sqrt(discriminant)) / (2 * a)};
}

Inside inside(const Box& box, const Ray& ray, Quad grown) {
    Inside all = Stretch{-forever, forever};
    for (int i = 0; i < 3; ++i) {
        const Quad3 axis(i == 0, i == 1, i == 2);
        all = common(all, half_space(ray, axis, Quad(box.max[i]) + grown));
        all = common(all, half_space(ray, Quad(-1) * axis, grown - Quad(box.min[i])));
    }
    return all;
}

/// The side grows by `grown` along its normal, the caps along the axis.
Inside inside(const Cone& cone, const Ray& ray, Quad grown) {
    const Quad3 base = cone.base, axis = Quad3(cone.cap) - base;
    const Quad h = length(axis);
    const Quad3 w = (1 / h) * axis;
    const Quad slope = (Quad(cone.cap_radius) - Quad(cone.base_radius)) / h;
    const Quad r0 = Quad(cone.base_radius) + grown * sqrt(1 + slope * slope);
    Inside caps = common(half_space(ray, w, dot(base, w) + h + grown), half_space(ray, Quad(-1) * w, grown - dot(base, w)));
    const Quad3 f = Quad3(ray.origin) - base, d = ray.direction;
    // |f + t d|^2 - z^2 = (r0 + slope z)^2 with z = z0 + t z1
    const Quad z0 = dot(f, w), z1 = dot(d, w), r = r0 + slope * z0;
    // A shrunk tip must not leave its mirror image: where the radius is positive.
    const Quad growth = slope * z1;
    if (growth > 0) caps = common(caps, Stretch{-r / growth, forever});
    if (growth < 0) caps = common(caps, Stretch{-forever, -r / growth});
    const Quad a = dot(cross(d, w), cross(d, w)) - slope * slope * z1 * z1;
    const Quad b = 2 * (dot(f, d) - z0 * z1 - r * slope * z1);
    const Quad c = dot(f, f) - z0 * z0 - r * r;
    const Quad discriminant = b * b - 4 * a * c;
    if (a > 0 && discriminant < 0) return {};
    const Quad t0 = (-b - sqrt(discriminant)) / (2 * a), t1 = (-b + sqrt(discriminant)) / (2 * a);
    Inside side = Stretch{min(t0, t1), max(t0, t1)};
    if (a < 0) side = growth > 0 ? Stretch{max(t0, t1), forever} : Stretch{-forever, min(t0, t1)};
    return common(caps, side);
}

/// The rules that a hit, or its absence, must obey for one interval.
template <typename S>
void check(const S& shape, const Ray& ray, const Interval& range, double extent) {
    ShapeHit hit;
    const bool found = intersect(shape, ray, range, hit);
    const double reach = found ? std::fabs(hit.t) : length(ray.origin) / length(ray.direction);
    const Quad error = hit_error(ray, reach, extent);
    const Inside most = inside(shape, ray, error), least = inside(shape, ray, -error);
    const auto surely_in_range = [&](Quad from, Quad to) { return from > range.min && to < range.max; };
    if (!found) {
        ASSERT_FALSE(least && (surely_in_range(most->enter, least->enter) || surely_in_range(least->leave, most->leave)));
        return;
    }
    ASSERT_TRUE(range.contains(hit.t));
    ASSERT_TRUE(most.has_value());
    ASSERT_TRUE(most->enter <= hit.t && hit.t <= most->leave);
    if (!least) return;
    const bool at_entry = hit.t <= least->enter, at_exit = hit.t >= least->leave;
    ASSERT_TRUE(at_entry || at_exit);
    if (!at_entry) {
        ASSERT_FALSE(surely_in_range(most->enter, least->enter)) << "the nearer hit was missed";
    }
}

/// The whole line ahead, then what is left behind the first hit, then what lies before the second one.
template <typename S>
void check_all_intervals(const S& shape, const Ray& ray, double extent) {
    check(shape, ray, {}, extent);
    const Inside exact = inside(shape, ray, 0);
    if (!exact) return;
    const auto middle = static_cast<double>((exact->enter + exact->leave) / 2);
    check(shape, ray, {middle, infinity}, extent);
    check(shape, ray, {-infinity, middle}, extent);
    check(shape, ray, {static_cast<double>(exact->leave), infinity}, extent);
}

constexpr int rounds = 20000;

TEST(Sphere, AgreesWithQuadruplePrecision) {
    Random random(1);
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Sphere sphere{random.in_cube(random.coin() ? 0.0 : 10.0 * size), size};
        // Inside, on and just outside of the surface, and tangents of it.
        const Vec3 out = random.direction();
        const double height = random.coin() ? random.between(0.0, 1.1) : 1.0 + random.between(-1e-14, 1e-14);
        Ray ray = aimed_at(sphere.center + height * size * out, size, random);
        if (i % 4 == 0) ray = {sphere.center + height * size * out + size * random.between(-9, 9) * cross(out, random.direction()), {}};
        if (i % 4 == 0) ray.direction = cross(out, random.direction());
        check_all_intervals(sphere, ray, max_abs(sphere.center) + size);
        if (HasFatalFailure()) FAIL() << "round " << i;
    }
}

TEST(Box, AgreesWithQuadruplePrecision) {
    Random random(2);
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Vec3 center = random.in_cube(random.coin() ? 0.0 : 10.0 * size);
        const Vec3 half(size * random.magnitude(1e-3, 1), size * random.magnitude(1e-3, 1), size * random.magnitude(1e-3, 1));
        const Box box{center - half, center + half};
        // A point of the hull with some coordinates on faces: faces, edges and corners.
        Vec3 target;
        for (int k = 0; k < 3; ++k)
            target[k] = random.index(3) == 0 ? box.min[k] : random.index(2) == 0 ? box.max[k] : random.between(box.min[k], box.max[k]);
        Ray ray = aimed_at(target, size, random);
        for (int k = 0; k < 3; ++k)
            if (random.index(5) == 0) {
                ray.direction[k] = random.coin() ? 0.0 : -0.0;
                ray.origin[k] = target[k];
            }
        if (length(ray.direction) == 0.0) continue;
        check_all_intervals(box, ray, max_abs(center) + size);
        if (HasFatalFailure()) FAIL() << "round " << i;
    }
}

TEST(Cone, AgreesWithQuadruplePrecision) {
    Random random(3);
    for (int i = 0; i < rounds; ++i) {
        const double size = random.magnitude(1e-3, 1e6);
        const Vec3 base = random.in_cube(random.coin() ? 0.0 : 10.0 * size);
        const Vec3 w = random.direction();
        const double height = size * random.magnitude(1e-2, 1.0);
        Cone cone{base, size * random.between(0.0, 1.0), base + height * w, size * random.between(0.0, 1.0)};
        if (i % 3 == 0) cone.cap_radius = cone.base_radius;
        if (i % 7 == 0) cone.cap_radius = 0.0;
        const double s = random.index(3) == 0 ? static_cast<double>(random.coin()) : random.between(0.0, 1.0);
        const double r = cone.base_radius + s * (cone.cap_radius - cone.base_radius);
        const Vec3 out = unit(cross(w, random.direction()));
        const Vec3 target = base + s * height * w + (random.coin() ? r : random.between(0.0, r)) * out;
        Ray ray = aimed_at(target, size, random);
        if (i % 5 == 0) ray.direction = w;              // parallel to the axis
        if (i % 5 == 1) ray.direction = cross(w, out);  // a tangent of the side
        check_all_intervals(cone, ray, max_abs(base) + 3.0 * size);
        if (HasFatalFailure()) FAIL() << "round " << i;
    }
}

TEST(Cone, OpenHasNoDiscs) {
    const Cone tube{{0, 0, 0}, 1.0, {0, 2, 0}, 1.0, true};
    ShapeHit hit;
    EXPECT_FALSE(intersect(tube, {{0, 5, 0}, {0, -1, 0}}, {}, hit));
    // Down through the open top to the far inner wall: the entry is no surface.
    ASSERT_TRUE(intersect(tube, {{-0.5, 2.5, 0}, {1, -1, 0}}, {}, hit));
    EXPECT_DOUBLE_EQ(hit.t, 1.5);
    EXPECT_EQ(hit.part, 0u);
    Cone closed = tube;
    closed.open = false;
    ASSERT_TRUE(intersect(closed, {{-0.5, 2.5, 0}, {1, -1, 0}}, {}, hit));
    EXPECT_DOUBLE_EQ(hit.t, 0.5);
    EXPECT_EQ(hit.part, 2u);
}

TEST(Cone, OnlyTheNappeBetweenTheCapsExists) {
    const Cone cone{{0, 0, 0}, 1.0, {0, 1, 0}, 0.0};  // tip at y = 1; the other nappe would open above it
    ShapeHit hit;
    EXPECT_FALSE(intersect(cone, {{-5, 1.5, 0}, {1, 0, 0}}, {}, hit));
    ASSERT_TRUE(intersect(cone, {{-5, 0.5, 0}, {1, 0, 0}}, {}, hit));
    EXPECT_DOUBLE_EQ(hit.t, 4.5);
    // Steeper than the cone, through both nappes' continuation.
    ASSERT_TRUE(intersect(cone, {{0.1, 9, 0}, {0, -1, 0}}, {}, hit));
    EXPECT_NEAR(hit.t, 8.1, 1e-14);
    EXPECT_EQ(hit.part, 0u);
}

TEST(Cone, RadiiOfOppositeSignMakeTwoConesTipToTip) {
    const Cone cone{{0, 0, 0}, 0.4, {0, 1, 0}, -0.4};
    ShapeHit hit;
    // From the left at height y the side is |0.4 - 0.8 y| from the axis; its normal leans away from the tip.
    for (const double y : {0.25, 0.75}) {
        ASSERT_TRUE(intersect(cone, {{-2, y, 0}, {1, 0, 0}}, {}, hit));
        EXPECT_NEAR(hit.t, 1.8, 1e-14);
        const Vec3 n = unit(normal(cone, {-0.2, y, 0}, hit));
        EXPECT_NEAR(length(n - unit(Vec3(-1, y < 0.5 ? 0.8 : -0.8, 0))), 0.0, 1e-14);
    }
    // Down along x = 0.3: the top disc, out through the upper side, in through the lower one, the bottom disc.
    double after = 0.0;
    const double expected_t[] = {1.0, 1.125, 1.875, 2.0};
    const std::uint32_t expected_part[] = {2, 0, 0, 1};
    for (int i = 0; i < 4; ++i) {
        ASSERT_TRUE(intersect(cone, {{0.3, 2, 0}, {0, -1, 0}}, {after, infinity}, hit));
        EXPECT_NEAR(hit.t, expected_t[i], 1e-14);
        EXPECT_EQ(hit.part, expected_part[i]);
        after = hit.t + 1e-9;
    }
    EXPECT_FALSE(intersect(cone, {{0.3, 2, 0}, {0, -1, 0}}, {after, infinity}, hit));
    EXPECT_FALSE(intersect(cone, {{0.3, 0.5, -2}, {0, 0, 1}}, {}, hit));
}

TEST(Box, OriginOnASlabPlaneGivesNoNan) {
    const Box box;
    ShapeHit hit;
    ASSERT_TRUE(intersect(box, {{-1, 0, -3}, {0, 0, 1}}, {}, hit));
    EXPECT_EQ(hit.t, 2.0);
    EXPECT_EQ(hit.part, 4u);
    EXPECT_FALSE(intersect(box, {{std::nextafter(-1.0, -2.0), 0, -3}, {0, 0, 1}}, {}, hit));
    ASSERT_TRUE(intersect(box, {{-1, 0, 0}, {1, 0, 0}}, {}, hit));
    EXPECT_EQ(hit.t, 2.0);
    EXPECT_EQ(hit.part, 1u);
}

}  // namespace
}  // namespace rt::test::solids_test
