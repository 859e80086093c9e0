// The index under every rounding of the processor: its padding holds, and what it finds is what brute force finds under the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfenv>
#include <cstdlib>
#include <tuple>

#include "tests/world/random_scene.h"
#include "world/surface_index.h"

namespace rt::index_rounding_test {
namespace {

/// RAYTRACE_DEEP=1 casts a hundred times the rays.
int effort() { return std::getenv("RAYTRACE_DEEP") ? 100 : 1; }

World compiled(const Scene& scene, IndexKind index) {
    CompileOptions options;
    options.index = index;
    options.threads = 1;
    return compile(scene, options, no_messages);
}

std::string answer(const World& world, const Ray& ray) {
    Hit hit;
    if (!world.nearest(ray, {}, RayKind::image, hit)) return "nothing";
    return fmt::format("object {} primitive {} part {} t {:a} u {:a} v {:a}", hit.object, hit.primitive, hit.shape.part, hit.shape.t,
                       hit.shape.u, hit.shape.v);
}

std::string text(const Ray& r) {
    return fmt::format("origin {:a} {:a} {:a} direction {:a} {:a} {:a}", r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y,
                       r.direction.z);
}

class EveryRounding : public testing::TestWithParam<int> {
protected:
    EveryRounding() { std::fesetround(GetParam()); }
    ~EveryRounding() override { std::fesetround(FE_TONEAREST); }
};
INSTANTIATE_TEST_SUITE_P(World, EveryRounding, testing::Values(FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO));

TEST_P(EveryRounding, TheIndexFindsWhatBruteForceFinds) {
    int differences = 0;
    for (const double extent : {1e-3, 1.0, 1e6}) {
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            Random random(1000 * seed + std::bit_cast<std::uint64_t>(extent) % 997);
            const Scene scene = random_scene(random, seed < 3 ? 40 : 15, extent);
            const World brute = compiled(scene, IndexKind::brute_force), index = compiled(scene, IndexKind::embree);
            ASSERT_TRUE(index.surfaces->indexed());
            ASSERT_EQ(std::fegetround(), GetParam()) << "building the index leaves the rounding as it is";
            int hits = 0;
            const int rays = 1000 * effort();
            std::array<Ray, packet_size> packet;
            for (int i = 0; i < rays && differences < 5; ++i) {
                const Ray ray = packet[static_cast<std::size_t>(i) % packet_size] = random_ray(random, scene, extent);
                const std::string expected = answer(brute, ray), found = answer(index, ray);
                hits += expected != "nothing";
                differences += found != expected;
                EXPECT_EQ(found, expected) << text(ray) << " seed " << seed << " extent " << extent;
                EXPECT_EQ(index.occluded(ray, {}), brute.occluded(ray, {})) << text(ray);
                if ((static_cast<std::size_t>(i) + 1) % packet_size != 0) continue;
                std::array<Hit, packet_size> together;
                const std::uint32_t bits = index.nearest(packet, {}, RayKind::image, together);
                for (std::size_t k = 0; k < packet_size; ++k) {
                    Hit alone;
                    const bool met = (bits >> k & 1u) != 0;
                    ASSERT_EQ(met, brute.nearest(packet[k], {}, RayKind::image, alone)) << text(packet[k]);
                    ASSERT_TRUE(!met || together[k].primitive == alone.primitive) << text(packet[k]);
                }
            }
            EXPECT_GT(hits, rays / 10);
        }
    }
}

TEST_P(EveryRounding, NoRayLeavesAClosedMeshThroughEdgesOrVertices) {
    const MeshData mesh = closed_mesh(10000);
    Scene scene;
    Object object;
    object.shape = Mesh{mesh};
    scene.objects.push_back(object);
    const World world = compiled(scene, IndexKind::embree);
    Random random(3);
    for (int i = 0; i < 4000 * effort(); ++i) {
        const auto& face = mesh.faces[static_cast<std::size_t>(random.whole(static_cast<int>(mesh.faces.size())))];
        const Vec3 a = mesh.vertices[face[0]], b = mesh.vertices[face[1]];
        const double f = random.chance(0.3) ? 0.0 : random.real(0.0, 1.0);
        const Vec3 origin = random.in_cube(0.3);
        const Ray ray{origin, unit(a + f * (b - a) - origin)};
        ASSERT_NE(answer(world, ray), "nothing") << text(ray);
        ASSERT_TRUE(world.occluded(ray, {})) << text(ray);
    }
}

}  // namespace
}  // namespace rt::index_rounding_test
