// Normals, bounds and names; rays that are not numbers.
#include <gtest/gtest.h>

#include <string>

#include "geometry/shape.h"
#include "tests/geometry/quad.h"

namespace rt::test::surface_test {
namespace {

constexpr double inf = infinity;

// Functions that vanish on the surface and grow outwards.
double implicit(const Sphere& s, const Vec3& p, const ShapeHit&) { return length(p - s.center) - s.radius; }
double implicit(const Torus& s, const Vec3& p, const ShapeHit&) {
    return std::hypot(std::hypot(p.x, p.z) - s.major_radius, p.y) - s.minor_radius;
}
double implicit(const Box& s, const Vec3& p, const ShapeHit& hit) {
    const int axis = static_cast<int>(hit.part / 2);
    return hit.part % 2 == 0 ? s.min[axis] - p[axis] : p[axis] - s.max[axis];
}
double implicit(const Cone& s, const Vec3& p, const ShapeHit& hit) {
    const Vec3 w = unit(s.cap - s.base);
    const double height = length(s.cap - s.base), z = dot(p - s.base, w);
    if (hit.part == 1) return -z;
    if (hit.part == 2) return z - height;
    return length(p - s.base - z * w) - (s.base_radius + z / height * (s.cap_radius - s.base_radius));
}

/// Random rays at the shape: the normal is the gradient of the implicit function, and hits lie inside the bounds.
template <typename S>
void check_surface(const S& shape, double size, unsigned seed) {
    Random random(seed);
    const Bounds b = bounds(shape);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = aimed_at(0.5 * (b.min + b.max) + random.in_cube(size), size, random);
        ShapeHit hit;
        if (!intersect(shape, ray, {}, hit)) continue;
        ++hits;
        const Vec3 p = ray.at(hit.t);
        const double h = 1e-5 * size;
        Vec3 gradient;
        for (int k = 0; k < 3; ++k) {
            Vec3 step(0.0);
            step[k] = h;
            gradient[k] = (implicit(shape, p + step, hit) - implicit(shape, p - step, hit)) / (2 * h);
        }
        ASSERT_NEAR(length(unit(normal(shape, p, hit)) - unit(gradient)), 0.0, 1e-6) << "ray " << i;
        const double slack = hit_error(ray, hit.t, max_abs(b.max) + max_abs(b.min));
        for (int k = 0; k < 3; ++k) {
            ASSERT_GE(p[k], b.min[k] - slack);
            ASSERT_LE(p[k], b.max[k] + slack);
        }
    }
    ASSERT_GT(hits, 200);
}

TEST(Surface, NormalsAreGradientsAndHitsLieInTheBounds) {
    check_surface(Sphere{{3, -2, 5}, 2.0}, 2.0, 1);
    check_surface(Torus{2.0, 0.5}, 2.0, 2);
    check_surface(Box{{-1, -2, -3}, {3, 1, 2}}, 3.0, 3);
    check_surface(Cone{{1, 2, 3}, 2.0, {-1, 4, 5}, 0.5}, 2.0, 4);
    check_surface(Cone{{1, 2, 3}, 0.0, {-1, 4, 5}, 2.5}, 2.0, 5);
    check_surface(Cone{{-1, 0, 0}, 1.0, {1, 3, 0}, 1.0, true}, 2.0, 6);
    check_surface(Cone{{0, 0, 0}, 1e-3, {0, 1e-3, 0}, 2e-3}, 2e-3, 7);
}

TEST(Surface, BoundsAreTight) {
    const auto near = [](const Bounds& b, const Vec3& low, const Vec3& high) {
        EXPECT_NEAR(length(b.min - low), 0.0, 1e-12);
        EXPECT_NEAR(length(b.max - high), 0.0, 1e-12);
    };
    near(bounds(Sphere{{1, 2, 3}, -2.0}), {-1, 0, 1}, {3, 4, 5});
    near(bounds(Torus{2.0, 0.5}), {-2.5, -0.5, -2.5}, {2.5, 0.5, 2.5});
    near(bounds(Disc{{1, 2, 3}, {0, 0, 1}, 2.0}), {-1, 0, 3}, {3, 4, 3});
    near(bounds(Cone{{0, 0, 0}, 1.0, {0, 5, 0}, 2.0}), {-2, 0, -2}, {2, 5, 2});
    near(bounds(Triangle{{0, 5, 1}, {-1, 2, 3}, {2, -3, 0}}), {-1, -3, 0}, {2, 5, 3});
    near(bounds(SmoothTriangle{{0, 5, 1}, {-1, 2, 3}, {2, -3, 0}}), {-1, -3, 0}, {2, 5, 3});
    near(bounds(Polygon{{{0, 0, 0}, {1, 0, 2}, {0, 3, 0}}}), {0, 0, 0}, {1, 3, 2});
    MeshData mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};  // the last belongs to no face
    mesh.faces = {{0, 1, 2}};
    near(bounds(Mesh{mesh}), {0, 0, 0}, {1, 1, 0});
    EXPECT_FALSE(bounds(Plane{}).is_finite());
    const double diagonal = std::sqrt(0.5);
    near(bounds(Disc{{0, 0, 0}, {diagonal, diagonal, 0}, 1.0}), {-diagonal, -diagonal, -1}, {diagonal, diagonal, 1});
}

TEST(Surface, TheTipOfAConeHasANormal) {
    const Cone tip{{0, 0, 0}, 1.0, {0, 2, 0}, 0.0};
    EXPECT_EQ(unit(normal(tip, {0, 2, 0}, {})), Vec3(0, 1, 0));
    const Cone funnel{{0, 0, 0}, 0.0, {0, 2, 0}, 1.0};
    EXPECT_EQ(unit(normal(funnel, {0, 0, 0}, {})), Vec3(0, -1, 0));
}

TEST(Surface, Names) {
    const auto named = [](const Shape& shape) { return std::string(name(shape)); };
    EXPECT_EQ(named(Sphere{}), "sphere");
    EXPECT_EQ(named(Plane{}), "plane");
    EXPECT_EQ(named(Box{}), "box");
    EXPECT_EQ(named(Cone{}), "cylinder");
    EXPECT_EQ(named(Cone{{0, 0, 0}, 1.0, {0, 1, 0}, 0.0}), "cone");
    EXPECT_EQ(named(Torus{}), "torus");
    EXPECT_EQ(named(Disc{}), "disc");
    EXPECT_EQ(named(Triangle{}), "triangle");
    EXPECT_EQ(named(SmoothTriangle{}), "smooth_triangle");
    EXPECT_EQ(named(Polygon{}), "polygon");
    EXPECT_EQ(named(Mesh{}), "mesh");
}

template <typename S>
void check_strange_rays(const S& shape) {
    const double odd[] = {std::nan(""), inf, -inf, 0.0, -0.0, 1e308, 1e-310, 1.0};
    Random random(8);
    const auto any = [&] { return Vec3(odd[random.index(8)], odd[random.index(8)], odd[random.index(8)]); };
    for (int i = 0; i < 20000; ++i) {
        const Ray ray{any(), any()};
        ShapeHit hit;
        const bool found = intersect(shape, ray, {}, hit);
        if (found) {
            ASSERT_TRUE(hit.t > 0.0 && hit.t < inf);
        }
        if (!is_finite(ray.origin) || std::isnan(length(ray.direction))) {
            ASSERT_FALSE(found && is_finite(ray.at(hit.t)));
        }
    }
    ShapeHit hit;
    EXPECT_FALSE(intersect(shape, {{std::nan(""), 0, -5}, {0, 0, 1}}, {}, hit));
    EXPECT_FALSE(intersect(shape, {{0.2, 0, -5}, {0, std::nan(""), 1}}, {}, hit));
    EXPECT_FALSE(intersect(shape, {{0.2, 0.2, -5}, {0, 0, 0}}, {}, hit));
    EXPECT_FALSE(intersect(shape, {{0.2, 0.2, -inf}, {0, 0, 1}}, {}, hit));
}

TEST(Surface, RaysThatAreNotNumbersHitNothing) {
    check_strange_rays(Sphere{});
    check_strange_rays(Plane{});
    check_strange_rays(Box{});
    check_strange_rays(Cone{});
    check_strange_rays(Cone{{0, 0, 0}, 1.0, {0, 1, 0}, 0.0});
    check_strange_rays(Torus{});
    check_strange_rays(Disc{});
    check_strange_rays(Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    check_strange_rays(SmoothTriangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    check_strange_rays(Polygon{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 0}}});
    check_strange_rays(Polygon{});
}

}  // namespace
}  // namespace rt::test::surface_test
