// Rays from inside closed surfaces, aimed at edges and vertices: none leaves.
#include <gtest/gtest.h>

#include "geometry/shape.h"
#include "tests/geometry/quad.h"

namespace rt::test::watertight_test {
namespace {

/// A closed ball of triangles, stretched by `scale`: with unequal scales its facets are needles.
MeshData ball(int rings, int segments, const Vec3& center, const Vec3& scale) {
    MeshData mesh;
    mesh.vertices.push_back(center + scale * Vec3(0, 1, 0));
    for (int i = 1; i < rings; ++i)
        for (int j = 0; j < segments; ++j) {
            const double a = pi * i / rings, b = 2 * pi * j / segments;
            mesh.vertices.push_back(center + scale * Vec3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)));
        }
    mesh.vertices.push_back(center - scale * Vec3(0, 1, 0));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(1 + (i - 1) * segments + j % segments); };
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (int j = 0; j < segments; ++j) {
        mesh.faces.push_back({0, at(1, j), at(1, j + 1)});
        for (int i = 1; i + 1 < rings; ++i) {
            mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
        mesh.faces.push_back({at(rings - 1, j), last, at(rings - 1, j + 1)});
    }
    return mesh;
}

int escapes(const MeshData& mesh, const Vec3& center, double inner, int rays, unsigned seed) {
    Random random(seed);
    int escaped = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3 origin = center + inner * random.in_cube(0.3);
        const auto& face = mesh.faces[random.index(mesh.faces.size())];
        const Vec3 a = mesh.vertices[face[0]], b = mesh.vertices[face[1]];
        const double s = random.index(3) == 0 ? 0.0 : random.between(0, 1);
        Vec3 direction = a + s * (b - a) - origin;
        if (random.coin()) direction = unit(direction);
        const TriangleRay ray({origin, direction});
        bool met = false;
        ShapeHit hit;
        for (const auto& f : mesh.faces)
            met = met || intersect(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]], ray, {}, hit);
        escaped += !met;
    }
    return escaped;
}

TEST(Watertight, NoRayLeavesAClosedMesh) {
    EXPECT_EQ(escapes(ball(24, 32, {0, 0, 0}, Vec3(1)), {0, 0, 0}, 1.0, 10000, 1), 0);
    EXPECT_EQ(escapes(ball(24, 32, {1e3, -2e4, 7}, Vec3(1e-2)), {1e3, -2e4, 7}, 1e-2, 5000, 2), 0);
    EXPECT_EQ(escapes(ball(24, 32, {0, 0, 0}, {1e3, 1e-3, 1}), {0, 0, 0}, 1e-3, 10000, 3), 0);
    EXPECT_EQ(escapes(ball(8, 200, {3, 3, 3}, {1, 1e4, 1}), {3, 3, 3}, 1.0, 5000, 4), 0);
}

TEST(Watertight, SymmetricRaysHitDiagonalsExactly) {
    // A cube of 12 triangles and rays whose sheared products are equal: every area test is a tie.
    MeshData cube;
    for (int k = 0; k < 8; ++k) cube.vertices.push_back({k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1});
    cube.faces = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            for (int z = -4; z <= 4; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                int met = 0;
                ShapeHit hit;
                const TriangleRay ray({{0, 0, 0}, Vec3(x, y, z)});
                for (const auto& f : cube.faces)
                    met += intersect(cube.vertices[f[0]], cube.vertices[f[1]], cube.vertices[f[2]], ray, {}, hit);
                EXPECT_GE(met, 1) << x << ' ' << y << ' ' << z;
            }
}

/// From inside, at the rim between side and cap and at the edges of a box.
TEST(Watertight, NoRayLeavesAClosedConeOrBox) {
    Random random(5);
    for (int i = 0; i < 50000; ++i) {
        const Vec3 base = random.in_cube(100), w = random.direction();
        const Cone cone{base, random.between(0, 1), base + random.magnitude(1e-3, 1e2) * w, random.between(0.1, 1)};
        const Vec3 inside = 0.5 * (cone.base + cone.cap);
        const Vec3 rim = random.coin() ? cone.base + cone.base_radius * unit(cross(w, random.direction()))
                                       : cone.cap + cone.cap_radius * unit(cross(w, random.direction()));
        ShapeHit hit;
        ASSERT_TRUE(intersect(cone, {inside, rim - inside}, {}, hit)) << i;
        ASSERT_NEAR(hit.t, 1.0, 1e-6) << i;  // flat cones are met at small angles
        const Box box{base, base + Vec3(1, 2, 3)};
        const Vec3 corner(random.coin() ? box.min.x : box.max.x, random.coin() ? box.min.y : box.max.y, random.between(base.z, base.z + 3));
        const Vec3 middle = 0.5 * (box.min + box.max);
        ASSERT_TRUE(intersect(box, {middle, corner - middle}, {}, hit)) << i;
        ASSERT_NEAR(hit.t, 1.0, 1e-12) << i;
    }
}

}  // namespace
}  // namespace rt::test::watertight_test
