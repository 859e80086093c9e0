// Prisms, letters, lathes, surfaces of revolution, blobs and superellipsoids: their hits lie on the surface, none is missed where the
// inside changes, the normal stands on the surface, all lie in the bounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shape.h"
#include "tests/geometry/check_hits.h"

namespace rt::test::further_shapes_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

Outline outline_of(const std::vector<CurvePiece>& pieces) {
    Outline outline;
    for (const CurvePiece& piece : pieces) outline.add(piece);
    turn_outwards(outline);
    return outline;
}

/// A triangle with a round side, and a square hole in it.
Outline round_triangle() {
    std::vector<CurvePiece> pieces = spline_pieces(SplineKind::linear, {{0, 0}, {2, 0}, {0, 2}});
    pieces.push_back(CurvePiece{{Vec2(0, 2), Vec2(-1, 1.5), Vec2(-1, 0.5), Vec2(0, 0)}});
    for (const CurvePiece& p : spline_pieces(SplineKind::linear, {{0.2, 0.2}, {0.7, 0.2}, {0.7, 0.7}, {0.2, 0.7}, {0.2, 0.2}}))
        pieces.push_back(p);
    return outline_of(pieces);
}

Lathe vase() {
    return Lathe{outline_of(spline_pieces(SplineKind::cubic, {{0, -1.5}, {0, -1}, {1, -0.7}, {0.4, 0}, {0.8, 0.8}, {0, 1}, {0, 1.5}}))};
}

Sor bottle() {
    const SorSlice low{-1.0, 0.0, {0.25, 0.6, 1.1, 0.5}}, high{0.0, 1.0, {0.5, -0.05, 0.1, 0.3}};
    return Sor{std::vector<SorSlice>{low, high}, false};
}

BlobComponent component(const Vec3& base, const Vec3& cap, double radius, double strength) {
    BlobComponent c;
    c.base = base, c.cap = cap, c.radius = radius, c.strength = strength;
    c.box = {glm::min(base, cap) - Vec3(radius), glm::max(base, cap) + Vec3(radius)};
    return c;
}

Blob three_blobs() {
    BlobData data;
    data.threshold = 0.4;
    data.components = {component({-0.5, 0, 0}, {-0.5, 0, 0}, 0.9, 1.0), component({-0.2, -0.6, 0}, {0.7, 0.5, 0.3}, 0.6, 1.2),
                       component({0, 0.3, -0.4}, {0, 0.3, -0.4}, 0.5, -0.8)};
    BlobComponent& flat = data.components[0];
    flat.moved = true;
    flat.to_own = Mat3(1.0, 0, 0, 0, 1.5, 0, 0, 0, 0.8);
    return Blob{data};
}

/// A ray beside this one meets the same part of the surface next to the hit, at a right angle to the normal.
template <typename S>
void check_normal(const S& shape, const Ray& ray, const ShapeHit& hit, const Vec3& n, double size, int& neighbours) {
    const double step = 1e-6 * size;
    for (const Vec3& aside : {Vec3(1, 2, 0), Vec3(0, 1, -2), Vec3(-2, 0, 1)}) {
        ShapeHit other;
        const double before = 100.0 * step / length(ray.direction);
        if (!intersect(shape, {ray.origin + step * aside, ray.direction}, {hit.t - before, hit.t + before}, other) ||
            other.part != hit.part)
            continue;
        const Vec3 across = ray.origin + step * aside + other.t * ray.direction - ray.at(hit.t);
        EXPECT_LT(std::fabs(dot(unit(across), n)), 1e-3);
        ++neighbours;
    }
}

/// The distance of a point from the surface to first order: how far off the inside function is zero along the normal.
template <typename S>
void check_surface(const S& shape, double size, unsigned seed, double tolerance) {
    Random random(seed);
    const Bounds box = bounds(shape);
    const Vec3 middle = 0.5 * (box.min + box.max);
    int hits = 0, neighbours = 0;
    for (int i = 0; i < 1500; ++i) {
        const Ray ray = aimed_at(middle + random.in_cube(size), size, random);
        visit_hits(shape, ray, {-infinity, infinity}, [&](const ShapeHit& hit) {
            ++hits;
            const Vec3 p = ray.at(hit.t);
            const Vec3 n = unit(normal(shape, p, hit));
            const double error = hit_error(ray, hit.t, 2.0 * size) + tolerance * size;
            for (int k = 0; k < 3; ++k) EXPECT_TRUE(p[k] >= box.min[k] - error && p[k] <= box.max[k] + error) << "ray " << i;
            // The normal points out of the inside.
            EXPECT_TRUE(contains(shape, p - error * n) && !contains(shape, p + error * n)) << "ray " << i << " t " << hit.t;
            if (length(ray.origin) < 10.0 * size) check_normal(shape, ray, hit, n, size, neighbours);
            return testing::Test::HasFailure();
        });
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    EXPECT_GT(hits, 300);
    EXPECT_GT(neighbours, 200);
}

constexpr double rounding = 64 * 0x1p-53;

TEST(FurtherShapes, HitsLieOnTheSurface) {
    check_surface(Prism{round_triangle(), -0.5, 1.0, false, false}, 1.5, 1, rounding);
    check_surface(Prism{round_triangle(), 0.5, 1.25, true, false}, 1.5, 2, rounding);
    check_surface(Prism{round_triangle(), -1.25, -0.5, true, false}, 1.5, 11, rounding);
    check_surface(Text{std::vector<Glyph>{{round_triangle(), 0.0, 0.5}}}, 1.5, 3, rounding);
    check_surface(vase(), 1.0, 4, rounding);
    check_surface(bottle(), 1.0, 5, rounding);
    check_surface(three_blobs(), 1.0, 6, 16 * rounding);
    check_surface(Superellipsoid{0.3, 0.3}, 1.0, 7, rounding);
    check_surface(Superellipsoid{1.0, 0.4}, 1.0, 8, rounding);
    check_surface(Superellipsoid{1.5, 1.0}, 1.0, 9, rounding);
    check_surface(Superellipsoid{0.02, 0.02}, 1.0, 10, 1e-12);
}

TEST(FurtherShapes, ParityIsTheInside) {
    check_inside(Prism{round_triangle(), -0.5, 1.0, false, false}, 1.5, 1);
    check_inside(Prism{round_triangle(), 0.5, 1.25, true, false}, 1.5, 2);
    check_inside(Prism{round_triangle(), -0.5, 1.0, true, false}, 1.5, 3);
    check_inside(Text{std::vector<Glyph>{{round_triangle(), 0.0, 0.5}}}, 1.5, 4);
    check_inside(vase(), 1.0, 5);
    check_inside(bottle(), 1.0, 6);
    check_inside(three_blobs(), 1.0, 7);
    for (const double e : {0.1, 0.5, 1.0, 2.0})
        for (const double n : {0.1, 0.5, 1.0, 2.0}) check_inside(Superellipsoid{e, n}, 1.0, 8);
}

// Rays within a plane of symmetry go through vertices, joints and borders exactly.
TEST(FurtherShapes, RaysThroughJoints) {
    const Prism square{outline_of(spline_pieces(SplineKind::linear, {{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}})), -1.0, 1.0, false, false};
    EXPECT_THAT(all_hits(square, {{-3, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(2, 1e-15), DoubleNear(4, 1e-15)));
    EXPECT_THAT(all_hits(square, {{0, 0, -3}, {0, 0, 1}}), ElementsAre(DoubleNear(2, 1e-15), DoubleNear(4, 1e-15)));
    EXPECT_THAT(all_hits(square, {{0, 3, 0}, {0, -2, 0}}), ElementsAre(1.0, 2.0));
    const Lathe joint{outline_of(spline_pieces(SplineKind::linear, {{0, -1}, {1, 0}, {0, 1}}))};
    EXPECT_THAT(all_hits(joint, {{-3, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(2, 1e-15), DoubleNear(4, 1e-15)));
    EXPECT_THAT(all_hits(joint, {{-2, -0.5, 0}, {1, 0.5, 0}}), ElementsAre(DoubleNear(1, 1e-14), DoubleNear(7.0 / 3.0, 1e-14)));
    const std::vector<double> along = all_hits(bottle(), {{-3, 0, 0}, {1, 0, 0}});
    EXPECT_THAT(along, ElementsAre(DoubleNear(3 - std::sqrt(0.5), 1e-15), DoubleNear(3 + std::sqrt(0.5), 1e-15)));
    EXPECT_THAT(all_hits(bottle(), {{0, 3, 0}, {0, -1, 0}}), ElementsAre(2.0, 4.0));
    Sor open = bottle();
    open.open = true;
    EXPECT_THAT(all_hits(open, {{0, 3, 0}, {0, -1, 0}}), IsEmpty());
}

// A lathe seen along rays that are horizontal or nearly so.
TEST(FurtherShapes, NearlyHorizontalRaysOfALathe) {
    Random random(3);
    const Lathe shape = vase();
    for (int i = 0; i < 3000; ++i) {
        const Vec3 target(random.between(-0.5, 0.5), random.between(-0.95, 0.95), random.between(-0.5, 0.5));
        Vec3 d = random.direction();
        d.y = random.coin() ? 0.0 : random.between(-1.0, 1.0) * random.magnitude(1e-9, 1e-2);
        const Ray ray{target - 3.0 * d, d};
        std::vector<double> ts = all_hits(shape, ray);
        if (ts.empty()) continue;
        ts.insert(ts.begin(), ts.front() - 10.0);
        ts.push_back(ts.back() + 10.0);
        for (std::size_t k = 1; k < ts.size(); ++k)
            ASSERT_EQ(contains(shape, ray.at(0.5 * (ts[k - 1] + ts[k]))), k % 2 == 0) << "ray " << i << " d.y " << d.y;
    }
}

TEST(FurtherShapes, BlobFieldsByHand) {
    BlobData data;
    data.threshold = 0.25;  // (1 - d^2)^2 = 1/4 where d^2 = 1/2
    data.components = {component(Vec3(0.0), Vec3(0.0), 1.0, 1.0)};
    const double r = std::sqrt(0.5);
    EXPECT_THAT(all_hits(Blob{data}, {{-3, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(3 - r, 1e-15), DoubleNear(3 + r, 1e-15)));
    data.components = {component({-1, 0, 0}, {1, 0, 0}, 1.0, 1.0)};
    EXPECT_THAT(all_hits(Blob{data}, {{-3, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(2 - r, 1e-15), DoubleNear(4 + r, 1e-15)));
    EXPECT_THAT(all_hits(Blob{data}, {{0.5, 3, 0}, {0, -1, 0}}), ElementsAre(DoubleNear(3 - r, 1e-15), DoubleNear(3 + r, 1e-15)));
    EXPECT_TRUE(contains(Blob{data}, {0.9, 0.7, 0}));
    EXPECT_FALSE(contains(Blob{data}, {0.9, 0.71, 0}));
    // A component whose border is exactly where the sum reaches the threshold.
    data.threshold = 0.5625;
    data.components = {component(Vec3(0.0), Vec3(0.0), 1.0, 1.0), component({-1.5, 0, 0}, {-1.5, 0, 0}, 1.0, -1.0)};
    EXPECT_THAT(all_hits(Blob{data}, {{-3, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(2.5, 1e-15), DoubleNear(3.5, 1e-15)));
    data.threshold = 2.0;
    EXPECT_THAT(all_hits(Blob{data}, {{-3, 0, 0}, {1, 0, 0}}), IsEmpty());
}

TEST(FurtherShapes, SuperellipsoidsByHand) {
    EXPECT_THAT(all_hits(Superellipsoid{1, 1}, {{-3, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(2, 1e-15), DoubleNear(4, 1e-15)));
    const double diagonal = std::pow(0.5, 0.5);  // |x| + |y| = 1 in the plane z = 0
    EXPECT_THAT(all_hits(Superellipsoid{2, 1}, {{-3, -3, 0}, {1, 1, 0}}), ElementsAre(DoubleNear(2.5, 1e-15), DoubleNear(3.5, 1e-15)));
    EXPECT_NEAR(length(unit(normal(Superellipsoid{2, 1}, {0.5, 0.5, 0}, {})) - Vec3(diagonal, diagonal, 0)), 0.0, 1e-15);
    EXPECT_THAT(all_hits(Superellipsoid{1, 1}, {{-3, 1.01, 0}, {1, 0, 0}}), IsEmpty());
    // Concave: |x|^(1/2) + |y|^(1/2) = 1 in the plane z = 0, on the diagonal x = y = 1/4.
    EXPECT_THAT(all_hits(Superellipsoid{4, 1}, {{-3, -3, 0}, {1, 1, 0}}), ElementsAre(DoubleNear(2.75, 1e-14), DoubleNear(3.25, 1e-14)));
    // Along 2 x + y = 0.68 two of four hits lie in one octant, on the same side of the middle of the way through it.
    EXPECT_EQ(all_hits(Superellipsoid{4, 1}, {{-1, 2.68, 0}, {1, -2, 0}}).size(), 4u);
}

TEST(Outlines, SplinesByTheirFormulas) {
    const std::vector<Vec2> p{{0, 0}, {1, 2}, {3, 1}, {4, 4}};
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const Vec2 quadratic = p[1] + 0.5 * t * (p[2] - p[0]) + 0.5 * t * t * (p[0] - 2.0 * p[1] + p[2]);
        EXPECT_NEAR(glm::length(spline_pieces(SplineKind::quadratic, p)[0].at(t) - quadratic), 0.0, 1e-15);
        const Vec2 cubic = p[1] + 0.5 * t * (p[2] - p[0]) + 0.5 * t * t * (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]) +
                           0.5 * t * t * t * (-p[0] + 3.0 * p[1] - 3.0 * p[2] + p[3]);
        EXPECT_NEAR(glm::length(spline_pieces(SplineKind::cubic, p)[0].at(t) - cubic), 0.0, 2e-15);
        EXPECT_NEAR(glm::length(spline_pieces(SplineKind::linear, p)[1].at(t) - (p[1] + t * (p[2] - p[1]))), 0.0, 1e-15);
    }
    EXPECT_EQ(spline_pieces(SplineKind::linear, p).size(), 3u);
    EXPECT_EQ(spline_pieces(SplineKind::quadratic, p).size(), 2u);
    EXPECT_EQ(spline_pieces(SplineKind::cubic, p).size(), 1u);
    EXPECT_EQ(spline_pieces(SplineKind::bezier, p)[0].points[1], p[1]);
}

TEST(Outlines, HolesAreOutside) {
    const Outline outline = round_triangle();
    EXPECT_TRUE(outline.contains({0.1, 0.1}));
    EXPECT_FALSE(outline.contains({0.5, 0.5}));
    EXPECT_TRUE(outline.contains({-0.5, 1.0}));
    EXPECT_FALSE(outline.contains({1.5, 1.5}));
    EXPECT_TRUE(outline.contains({0.9, 0.2}));  // at the height of two corners
}

}  // namespace
}  // namespace rt::test::further_shapes_test
