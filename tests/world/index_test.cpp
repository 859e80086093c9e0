// The index against brute force, bit for bit; and closed meshes from inside.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>

#include "tests/world/random_scene.h"
#include "world/surface_index.h"

namespace rt::index_test {
namespace {

/// RAYTRACE_DEEP=1 casts a hundred times the rays.
int effort() { return std::getenv("RAYTRACE_DEEP") ? 100 : 1; }

World compiled(const Scene& scene, IndexKind index, Precision precision = Precision::exact) {
    CompileOptions options;
    options.index = index;
    options.precision = precision;
    options.threads = 1;
    return compile(scene, options, no_messages);
}

struct Answer {
    bool found = false;
    Hit hit;
    bool operator==(const Answer& other) const {
        const auto same = [](double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); };
        const ShapeHit &a = hit.shape, &b = other.hit.shape;
        return found == other.found && hit.object == other.hit.object && hit.primitive == other.hit.primitive && a.part == b.part &&
               same(a.t, b.t) && same(a.u, b.u) && same(a.v, b.v);
    }
    std::string text() const {
        return found ? fmt::format("object {} primitive {} t {:a} u {:a} v {:a} part {}", hit.object, hit.primitive, hit.shape.t,
                                   hit.shape.u, hit.shape.v, hit.shape.part)
                     : "no hit";
    }
};

Answer ask(const World& world, const Ray& ray, const Interval& range, RayKind kind) {
    Answer answer;
    answer.found = world.nearest(ray, range, kind, answer.hit);
    return answer;
}

std::string describe(const Ray& r, const Interval& range) {
    return fmt::format("origin {:a} {:a} {:a} direction {:a} {:a} {:a} range {:a} {:a}", r.origin.x, r.origin.y, r.origin.z, r.direction.x,
                       r.direction.y, r.direction.z, range.min, range.max);
}

Interval random_range(Random& random, double extent) {
    Interval range;
    if (random.chance(0.5)) range.min = extent * random.log(1e-9, 1.0);
    if (random.chance(0.3)) range.max = range.min + extent * random.log(1e-3, 10.0);
    return range;
}

class EveryScale : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(World, EveryScale, testing::Values(1e-3, 0.1, 1.0, 30.0, 1e3, 1e6));

TEST_P(EveryScale, ExactIndexFindsWhatBruteForceFinds) {
    const double extent = GetParam();
    constexpr RayKind kinds[] = {RayKind::image, RayKind::reflected, RayKind::shadow};
    int differences = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        Random random(1000 * seed + std::bit_cast<std::uint64_t>(extent) % 997);
        const Scene scene = random_scene(random, seed < 4 ? 40 : 15, extent);
        const World brute = compiled(scene, IndexKind::brute_force);
        const World index = compiled(scene, IndexKind::embree);
        ASSERT_TRUE(index.surfaces->indexed());
        ASSERT_FALSE(brute.surfaces->indexed());
        Blocker last;
        int hits = 0;
        const int rays = 2100 * effort();
        for (int i = 0; i < rays && differences < 5; ++i) {
            const Ray ray = random_ray(random, scene, extent);
            const Interval range = random_range(random, extent);
            const Answer expected = ask(brute, ray, range, kinds[i % 3]);
            const Answer found = ask(index, ray, range, kinds[i % 3]);
            hits += expected.found;
            if (!(found == expected)) {
                ++differences;
                ADD_FAILURE() << found.text() << " instead of " << expected.text() << '\n' << describe(ray, range) << " seed " << seed;
            }
            const bool blocked = brute.occluded(ray, range);
            // With the blocker of the ray before, with its own, and with none.
            ASSERT_EQ(index.occluded(ray, range, last), blocked) << describe(ray, range);
            ASSERT_EQ(last.object != Blocker::none, blocked);
            Blocker own = last;
            ASSERT_EQ(index.occluded(ray, range, own), blocked) << describe(ray, range);
            ASSERT_EQ(index.occluded(ray, range), blocked) << describe(ray, range);
        }
        EXPECT_GT(hits, rays / 10);
    }
}

/// Up to eight rays that start and go much the same way, or, if `scattered`, do not.
std::vector<Ray> random_packet(Random& random, const Scene& scene, double extent, bool scattered) {
    std::vector<Ray> rays{random_ray(random, scene, extent)};
    const double spread = random.log(1e-9, 0.1);
    const auto count = static_cast<std::size_t>(1 + random.whole(static_cast<int>(packet_size)));
    while (rays.size() < count) {
        const Ray& first = rays.front();
        rays.push_back(scattered
                           ? random_ray(random, scene, extent)
                           : Ray{first.origin + spread * random.in_cube(extent), unit(first.direction + spread * random.direction())});
    }
    return rays;
}

TEST_P(EveryScale, PacketsMeetWhatTheirRaysMeet) {
    const double extent = GetParam();
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Random random(77 * seed + std::bit_cast<std::uint64_t>(extent) % 991);
        const Scene scene = random_scene(random, seed < 3 ? 40 : 15, extent);
        const World brute = compiled(scene, IndexKind::brute_force);
        const World index = compiled(scene, IndexKind::embree, seed % 3 == 2 ? Precision::fast : Precision::exact);
        const World& alone = seed % 3 == 2 ? index : brute;
        for (int i = 0; i < 300 * effort(); ++i) {
            const std::vector<Ray> rays = random_packet(random, scene, extent, i % 4 == 0);
            const Interval range = random_range(random, extent);
            std::array<Hit, packet_size> hits;
            const std::uint32_t found = index.nearest(rays, range, RayKind::image, hits);
            for (std::size_t k = 0; k < rays.size(); ++k) {
                const Answer expected = ask(alone, rays[k], range, RayKind::image);
                const bool met = (found >> k & 1u) != 0;
                const Answer answer{met, met ? hits[k] : Hit{}};
                ASSERT_EQ(answer, expected) << answer.text() << " instead of " << expected.text() << "\nray " << k << " of " << rays.size()
                                            << ", " << describe(rays[k], range) << " seed " << seed;
            }
            EXPECT_EQ(found >> rays.size(), 0u);
        }
    }
}

/// How often and how far two worlds disagree.
struct Disagreement {
    int rays = 0, other_object = 0;
    double worst = 0.0;  ///< of the distances where both meet the same

    void compare(const Answer& expected, const Answer& found, double extent) {
        ++rays;
        if (expected.found != found.found || (found.found && expected.hit.primitive != found.hit.primitive))
            ++other_object;
        else if (found.found)
            worst = std::fmax(worst, std::fabs(expected.hit.shape.t - found.hit.shape.t) / extent);
    }
    std::string text() const {
        return fmt::format("{} of {} rays meet something else; the others differ by at most {:.1e} extents", other_object, rays, worst);
    }
};

TEST_P(EveryScale, FastIndexDisagreesRarelyAndLittle) {
    const double extent = GetParam();
    Random random(7);
    Disagreement anywhere, at_edges;
    for (int s = 0; s < 4; ++s) {
        Scene scene = random_scene(random, 40, extent);
        MeshData mesh = closed_mesh(2000);
        for (Vec3& vertex : mesh.vertices) vertex *= extent;
        Object object;
        object.shape = Mesh{mesh};
        scene.objects.insert(scene.objects.end(), 10, object);
        for (std::size_t i = 0; i < 10; ++i)
            scene.objects.end()[-1 - static_cast<std::ptrdiff_t>(i)].transform = Transform::scale(Vec3(0.1 * random.real(1.0, 9.0)));
        const World exact = compiled(scene, IndexKind::embree);
        const World fast = compiled(scene, IndexKind::embree, Precision::fast);
        for (int i = 0; i < 1000 * effort(); ++i) {
            const Ray ray{random.in_cube(2.0 * extent), random.direction()};
            anywhere.compare(ask(exact, ray, {}, RayKind::image), ask(fast, ray, {}, RayKind::image), extent);
            const Ray aimed = random_ray(random, scene, extent);
            if (length(aimed.origin) > 4.0 * extent) continue;
            at_edges.compare(ask(exact, aimed, {}, RayKind::image), ask(fast, aimed, {}, RayKind::image), extent);
        }
    }
    fmt::print("fast, extent {}: anywhere {}; at edges {}\n", extent, anywhere.text(), at_edges.text());
    EXPECT_LE(anywhere.other_object, 2 + anywhere.rays / 1000);
    EXPECT_LE(at_edges.other_object, at_edges.rays / 5);
    EXPECT_LT(std::fmax(anywhere.worst, at_edges.worst), 1e-6);
}

TEST(FastIndex, DoesNotAskTheLastBlocker) {
    // Single precision and doubles disagree at edges: which of them answers must not depend on the rays before.
    Random random(11);
    Scene scene;
    Object object;
    const Triangle triangle{{0, 0, 0}, {1, 0, 0.3}, {0.2, 1, 0.1}};
    object.shape = triangle;
    scene.objects.push_back(object);
    const World exact = compiled(scene, IndexKind::embree);
    const World fast = compiled(scene, IndexKind::embree, Precision::fast);
    int disagreements = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 origin = random.in_cube(2.0);
        const Ray ray{origin, unit(triangle.a + random.real(0.0, 1.0) * (triangle.b - triangle.a) - origin)};
        Blocker last;
        const bool in_doubles = exact.occluded(ray, {}, last);
        const bool alone = fast.occluded(ray, {});
        disagreements += in_doubles && !alone;
        ASSERT_EQ(fast.occluded(ray, {}, last), alone) << describe(ray, {});
    }
    EXPECT_GT(disagreements, 10);
}

TEST(HeightField, OnesSideIsThatOfTheTriangleThatIsMet) {
    HeightField field;
    field.data = HeightFieldData(2, 3, {0, 0, 30000, 10000, 65535, 0});
    field.normals = sample_normals(*field.data);
    Object object;
    object.shape = FurtherShape(field);
    object.transform = Transform::scale(Vec3(2, -1, 3)).then(Transform::rotate({10, 20, 30}, Rotation::povray));
    Scene scene;
    scene.objects.push_back(object);
    const World world = compiled(scene, IndexKind::embree);
    const auto at = [&](const Vec3& p) { return object.transform->point(p); };
    const Vec3 from = at(Vec3(0.2, 5, 0.1)), corner = at(field.data->point(0, 0));
    Hit hit;
    ASSERT_TRUE(world.nearest({from, unit(at(Vec3(0.2, 0, 0.1)) - from)}, {}, RayKind::image, hit));
    const Vec3 normal = world.normal(hit, from);
    const Vec3 side = world.flat_side(hit, normal);
    EXPECT_NEAR(length(side), 1.0, 1e-12);
    EXPECT_NEAR(dot(side, at(field.data->point(1, 0)) - corner), 0.0, 1e-12);
    EXPECT_NEAR(dot(side, at(field.data->point(0, 1)) - corner), 0.0, 1e-12);
    EXPECT_GT(length(cross(side, normal)), 0.01);
}

TEST(ClosedMesh, NoRayLeavesThroughEdgesOrVertices) {
    const MeshData mesh = closed_mesh(10000);
    ASSERT_GT(mesh.faces.size(), 9000u);
    for (const double scale : {1.0, 1e-3, 1e6}) {
        Scene scene;
        Object object;
        object.shape = Mesh{mesh};
        object.transform = Transform::scale(Vec3(scale, 0.7 * scale, scale)).then(Transform::rotate({10, 20, 30}, Rotation::povray));
        scene.objects.push_back(object);
        const World world = compiled(scene, IndexKind::embree);
        Random random(3);
        for (int i = 0; i < 4000 * effort(); ++i) {
            const auto& face = mesh.faces[static_cast<std::size_t>(random.whole(static_cast<int>(mesh.faces.size())))];
            const Vec3 a = object.transform->point(mesh.vertices[face[0]]), b = object.transform->point(mesh.vertices[face[1]]);
            const double f = random.chance(0.3) ? 0.0 : random.real(0.0, 1.0);
            const Vec3 origin = random.in_cube(0.3 * scale);
            const Ray ray{origin, unit(a + f * (b - a) - origin)};
            ASSERT_TRUE(ask(world, ray, {}, RayKind::image).found) << describe(ray, {});
            ASSERT_TRUE(world.occluded(ray, {})) << describe(ray, {});
        }
    }
}

TEST(Ties, GoToTheFirstInTheFile) {
    // Thirty copies of each face, in an index that visits them in its own order.
    Scene scene;
    Object box, sphere, triangle;
    box.shape = Box{{-1, -1, 0}, {1, 1, 1}};
    sphere.shape = Sphere{{0, 0, 1}, 1.0};
    triangle.shape = Triangle{{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}};
    for (int i = 0; i < 30; ++i)
        for (const Object& object : {sphere, triangle, box}) scene.objects.push_back(object);
    for (const IndexKind kind : {IndexKind::embree, IndexKind::brute_force, IndexKind::automatic}) {
        const World world = compiled(scene, kind);
        const Answer on_axis = ask(world, {{0, 0, -4}, {0, 0, 1}}, {}, RayKind::image);
        EXPECT_EQ(on_axis.text(), ask(world, {{0, 0, -4}, {0, 0, 1}}, {}, RayKind::shadow).text());
        EXPECT_EQ(on_axis.hit.object, 0u);
        EXPECT_EQ(on_axis.hit.shape.t, 4.0);
        const Answer aside = ask(world, {{0.5, 0.5, -4}, {0, 0, 1}}, {}, RayKind::image);
        EXPECT_EQ(aside.hit.object, 1u);
        EXPECT_EQ(aside.hit.primitive, 1u);
    }
}

TEST(Index, AutomaticKeepsAFewObjectsInAListAndManyInTheIndex) {
    Scene scene;
    Object sphere;
    sphere.shape = Sphere{};
    scene.objects.assign(3, sphere);
    EXPECT_FALSE(compiled(scene, IndexKind::automatic).surfaces->indexed());
    scene.objects.assign(300, sphere);
    EXPECT_TRUE(compiled(scene, IndexKind::automatic).surfaces->indexed());
}

Texture plain_texture(double filter, double reflection) {
    Finish finish;
    finish.reflection.min = finish.reflection.max = Rgb(reflection);
    return {PlainTexture{{PigmentColor{Rgb(1.0), filter, 0.0}, {}, {}}, finish}};
}

TEST(Index, AutomaticKeepsManyObjectsInAListForFewRays) {
    Object sphere;
    sphere.shape = Sphere{};
    Light lamp;
    lamp.color = Rgb(1.0);
    CompileOptions options;
    const auto indexed = [&](const Texture& texture, std::size_t lamps, FewRays few) {
        Scene scene;
        sphere.texture = std::vector<Texture>{texture};
        scene.objects.assign(300, sphere);
        scene.lights.assign(lamps, lamp);
        options.few_rays = few;
        return compile(scene, options, no_messages).surfaces->indexed();
    };
    const Texture dull = plain_texture(0, 0), mirror = plain_texture(0, 0.5), glass = plain_texture(0.5, 0);
    EXPECT_FALSE(indexed(dull, 31, {.camera = 2, .further = 6}));  // 2 rays, 62 shadow rays
    EXPECT_TRUE(indexed(dull, 32, {.camera = 2, .further = 6}));
    EXPECT_FALSE(indexed(mirror, 3, {.camera = 2, .further = 7}));  // chains of 8 surfaces
    EXPECT_TRUE(indexed(mirror, 3, {.camera = 2, .further = 8}));
    EXPECT_FALSE(indexed(glass, 3, {.camera = 2, .further = 2}));  // trees of 8 surfaces
    EXPECT_TRUE(indexed(glass, 3, {.camera = 2, .further = 3}));
    EXPECT_FALSE(indexed(glass, 100, {.camera = 64, .further = 6, .shaded = false}));
    EXPECT_TRUE(indexed(glass, 100, {.camera = 65, .further = 6, .shaded = false}));
    EXPECT_FALSE(indexed(dull, 1, {}));
    lamp.area.emplace();
    EXPECT_TRUE(indexed(dull, 1, {}));
    options.precision = Precision::fast;  // need not find the same hits
    EXPECT_TRUE(indexed(dull, 0, {}));
    options.precision = Precision::exact;
    options.index = IndexKind::embree;
    EXPECT_TRUE(indexed(dull, 0, {}));
}

TEST(Index, AHugeGroundDoesNotBlurTheRest) {
    // A ground of 1e9 and spheres of 1e-3: kept in one index, the padding alone would be a thousand times a sphere.
    Random random(11);
    Scene scene;
    Object ground;
    ground.shape = Sphere{{0, -1e9, 0}, 1e9};
    scene.objects.push_back(ground);
    for (int i = 0; i < 200; ++i) {
        Object object;
        object.shape = Sphere{random.in_cube(0.1) + Vec3(0, 0.2, 0), 1e-3};
        scene.objects.push_back(object);
    }
    const World world = compiled(scene, IndexKind::embree), brute = compiled(scene, IndexKind::brute_force);
    EXPECT_EQ(world.surfaces->listed(), std::vector<std::uint32_t>{0});
    for (int i = 0; i < 5000; ++i) {
        const Ray ray{random.in_cube(1.0) + Vec3(0, 1.1, 0), random.direction()};
        ASSERT_EQ(ask(world, ray, {}, RayKind::image).text(), ask(brute, ray, {}, RayKind::image).text());
    }
}

}  // namespace
}  // namespace rt::index_test
