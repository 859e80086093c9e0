// Lights, background, features, camera interiors, normals and rays that are no rays.
#include "world/compile.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <limits>

#include "tests/world/random_scene.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace rt::compile_test {
namespace {

Object with_color(const Shape& shape, const PigmentColor& color, const Finish& finish = {}) {
    Object object;
    object.shape = shape;
    Texture texture;
    texture.content = PlainTexture{Pigment{color, {}, {}}, finish};
    object.texture = TextureLayers(std::vector{texture});
    return object;
}

const PigmentColor opaque{Rgb(1.0), 0.0, 0.0};
const PigmentColor clear{Rgb(1.0), 0.9, 0.0};

World compiled(const Scene& scene, const CompileOptions& options = {}) { return compile(scene, options, no_messages); }

TEST(Compile, EmptySceneHasNoFeaturesAndNoHits) {
    const World world = compiled(Scene{});
    Hit hit;
    EXPECT_FALSE(world.nearest({{}, {0, 0, 1}}, {}, RayKind::image, hit));
    EXPECT_FALSE(world.occluded({{}, {0, 0, 1}}, {}));
    const Features& f = world.features;
    EXPECT_FALSE(f.transmits || f.refracts || f.reflects || f.fades || f.patterns || f.layers || f.area_lights || f.visibility_flags ||
                 f.catalogue);
    EXPECT_EQ(world.scene_extent, 0.0);
    EXPECT_EQ(world.scene_size, 0.0);
}

TEST(Compile, BlackLightsAreLeftOut) {
    Scene scene;
    scene.lights.resize(3);
    scene.lights[1].color = {0, 0, -0.2};
    scene.lights[1].area = AreaLight{};
    scene.lights[2].color = Rgb(1e-12);
    const World world = compiled(scene);
    ASSERT_EQ(world.lights.size(), 1u);
    EXPECT_EQ(world.lights[0].color.b, -0.2);
    EXPECT_TRUE(world.features.area_lights);
}

TEST(Compile, LightsOfGroupsShineOnTheirGroups) {
    // The second light is black and left out.
    Scene scene;
    scene.light_groups = 3;
    scene.lights.resize(5);
    for (std::uint32_t i = 0; i < 5; ++i) scene.lights[i].color = Rgb(i == 1 ? 0.0 : 1.0), scene.lights[i].group = i == 0 ? 0 : i - 1;
    const auto lights_of = [&](std::uint32_t group, bool own_only) {
        Object object = with_color(Sphere{Vec3(0.0), 1.0}, opaque);
        object.light_group = group;
        object.own_lights_only = own_only;
        scene.objects = {object};
        const World world = compiled(scene);
        std::vector<bool> list;
        for (std::uint32_t i = 0; i < world.lights.size(); ++i) list.push_back(world.lights_up(i, 0));
        return list;
    };
    EXPECT_EQ(lights_of(0, false), (std::vector<bool>{true, false, false, false}));
    EXPECT_EQ(lights_of(1, false), (std::vector<bool>{true, true, false, false}));
    EXPECT_EQ(lights_of(2, true), (std::vector<bool>{false, false, true, false}));
    EXPECT_EQ(lights_of(3, true), (std::vector<bool>{false, false, false, true}));
    scene.light_groups = 0;
    EXPECT_FALSE(compiled(scene).features.light_groups);
}

TEST(Compile, MasksAreMetByTheirLightAlone) {
    Scene scene;
    Light light;
    light.color = Rgb(1.0);
    scene.lights = {light, light};
    scene.lights[0].color = Rgb(0.0);  // left out
    scene.lights[1].mask = Mask{{Solid{Sphere{Vec3(5, 0, 0), 1.0}, {}, false}, Solid{Sphere{Vec3(10, 0, 0), 1.0}, {}, false}}, {}};
    for (const double x : {0.0, 15.0}) scene.objects.push_back(with_color(Sphere{Vec3(x, 0, 0), 1.0}, opaque));
    for (const IndexKind kind : {IndexKind::brute_force, IndexKind::embree}) {
        CompileOptions options;
        options.index = kind;
        const World world = compiled(scene, options);
        EXPECT_NEAR(world.scene_size, 17.0, 1e-9);
        const Ray at_mask{{10, 0, -5}, {0, 0, 1}}, along{{2, 0, 0}, {1, 0, 0}}, at_last{{15, 0, -5}, {0, 0, 1}};
        Hit hit;
        EXPECT_FALSE(world.nearest(at_mask, {}, RayKind::image, hit) || world.nearest(at_mask, {}, RayKind::shadow, hit));
        EXPECT_FALSE(world.occluded(at_mask, {}));
        EXPECT_TRUE(world.nearest(at_last, {}, RayKind::image, hit));
        EXPECT_EQ(world.through(0, at_mask, {}), 4.0);
        EXPECT_EQ(world.through(0, along, {}), 2.0) << "the first one on the way";
        EXPECT_EQ(world.through(0, at_last, {}), std::nullopt);
        EXPECT_EQ(world.through(0, at_mask, {0.0, 3.0}), std::nullopt);
    }
}

TEST(Compile, MasksCanBeSets) {
    // The half of a sphere with x above 0.
    Scene scene;
    Light light;
    light.color = Rgb(1.0);
    Mask mask{{Solid{Sphere{Vec3(0.0), 1.0}, {}, false}}, std::vector<ObjectSet>(1)};
    mask.sets[0].nodes.resize(3);
    mask.sets[0].nodes[0].kind = SetNode::Kind::all;
    mask.sets[0].nodes[0].size = 3;
    mask.sets[0].nodes[2].kind = SetNode::Kind::solid;
    mask.sets[0].solids = {Solid{Plane{Vec3(-1, 0, 0), 0.0}, {}, false}};
    light.mask = mask;
    scene.lights = {light, light};
    scene.objects.push_back(with_color(Sphere{Vec3(0, 5, 0), 1.0}, opaque));
    const World world = compiled(scene);
    for (const std::uint32_t i : {0u, 1u}) {
        EXPECT_NEAR(world.through(i, {{0.6, 0, -5}, {0, 0, 1}}, {}).value_or(0.0), 4.2, 1e-12);
        EXPECT_EQ(world.through(i, {{-0.6, 0, -5}, {0, 0, 1}}, {}), std::nullopt);
        EXPECT_EQ(world.through(i, {{0, 5, -5}, {0, 0, 1}}, {}), std::nullopt);
    }
}

TEST(Compile, AreaLightsHaveAtMostTheLampsAskedFor) {
    Scene scene;
    Light light;
    light.color = Rgb(1.0);
    light.area = AreaLight{{2, 0, 0}, {0, 3, 0}, 9, 2, 1, true, false, true};
    scene.lights = {light};
    const auto lights = [&](std::optional<int> most) {
        CompileOptions options;
        options.light_samples = most;
        return compiled(scene, options).lights;
    };
    EXPECT_EQ(lights({}), scene.lights);
    EXPECT_EQ(lights(9), scene.lights);
    light.area->size1 = 4;
    EXPECT_EQ(lights(4), std::vector{light}) << "nothing else of the light changes";
    light.area.reset();
    EXPECT_EQ(lights(1), std::vector{light}) << "a lamp at its centre";
}

TEST(Compile, TransparentBackgroundsAreDarkerSinceLanguage37) {
    Scene scene;
    scene.background = {{0.8, 0.6, 0.4}, 0.0, 0.5};
    scene.language_version = 3.7;
    World world = compiled(scene);
    EXPECT_EQ(world.background, Rgb(0.4, 0.3, 0.2));
    EXPECT_EQ(world.background_transmit, 0.5);
    EXPECT_FALSE(world.legacy_opacity);
    scene.language_version = 3.6;
    world = compiled(scene);
    EXPECT_EQ(world.background, Rgb(0.8, 0.6, 0.4));
    EXPECT_TRUE(world.legacy_opacity);
}

TEST(Compile, FeaturesNameWhatTheSceneHas) {
    Scene scene;
    Finish mirror;
    mirror.reflection.min = Rgb(0.5);
    mirror.specular = 0.3;
    scene.objects = {with_color(Sphere{}, opaque, mirror)};
    scene.objects[0].no_image = true;
    const Features f = compiled(scene).features;
    EXPECT_TRUE(f.reflects && f.catalogue && f.visibility_flags);
    EXPECT_FALSE(f.transmits || f.refracts || f.fades || f.patterns || f.layers);

    Interior water;  // an opaque object with an interior refracts nothing
    water.ior = 1.33;
    scene.objects[0].interior = Shared<Interior>(water);
    EXPECT_FALSE(compiled(scene).features.refracts);
    scene.objects[0] = with_color(Sphere{}, clear);
    EXPECT_TRUE(compiled(scene).features.transmits);
    EXPECT_FALSE(compiled(scene).features.refracts);
    scene.objects[0].interior = Shared<Interior>(water);
    EXPECT_TRUE(compiled(scene).features.refracts);
}

TEST(Compile, OnlyOpaqueCastersBlockLightForGood) {
    const Ray ray{{0, 0, -5}, {0, 0, 1}};
    Scene scene;
    for (const IndexKind kind : {IndexKind::brute_force, IndexKind::embree}) {
        CompileOptions options;
        options.index = kind;
        scene.objects = {with_color(Sphere{}, clear)};
        EXPECT_FALSE(compiled(scene, options).occluded(ray, {}));
        scene.objects = {with_color(Sphere{}, opaque)};
        EXPECT_TRUE(compiled(scene, options).occluded(ray, {}));
        EXPECT_FALSE(compiled(scene, options).occluded(ray, {0.0, 4.0}));  // the end does not count
        scene.objects[0].no_shadow = true;
        EXPECT_FALSE(compiled(scene, options).occluded(ray, {}));
    }
}

TEST(Compile, FindsTheInteriorsAroundTheCamera) {
    const std::vector<std::tuple<Shape, bool, bool>> cases = {
        {Sphere{{0, 0, 0}, 2}, true, true},
        {Sphere{{3, 0, 0}, 2}, false, false},
        {Box{Vec3(-1), Vec3(1)}, true, true},
        {Plane{{0, 1, 0}, 1.0}, true, true},
        {Plane{{0, 1, 0}, -1.0}, false, true},
        {Cone{{0, -1, 0}, 1.0, {0, 1, 0}, 0.0, true}, true, true},
        {Cone{{0, -1, 0}, 1.0, {0, -0.5, 0}, 1.0, false}, false, false},
        {Torus{1.0, 0.5}, false, true},
        {Torus{0.4, 0.5}, true, true},
        {Disc{{0, 1, 0}, {0, 1, 0}, 0.1, 0.0}, true, true},
        {Mesh{closed_mesh(100)}, false, false},
    };
    // What was turned inside out counts in its box alone, as in POV-Ray.
    for (const auto& [shape, inside, in_box] : cases) {
        for (const bool inverse : {false, true}) {
            Scene scene;
            scene.objects = {with_color(Sphere{{9, 9, 9}, 1}, clear), with_color(shape, clear)};
            scene.objects[1].inverse = inverse;
            // Moved there and back: the test happens in the shape's own space.
            scene.camera.location = {5, 5, 5};
            scene.objects[1].transform = Transform::scale(Vec3(3.0)).then(Transform::translate({5, 5, 5}));
            const World world = compiled(scene);
            const bool expected = !std::holds_alternative<Mesh>(shape) && in_box && inside != inverse;
            ASSERT_EQ(world.camera_interiors.size(), expected ? 1u : 0u) << name(shape) << (inverse ? " inverse" : "");
            if (expected) {
                EXPECT_EQ(world.camera_interiors[0], world.objects[1].interior);
            }
        }
    }
}

/// The object's normal where a ray towards +z through (x, y) meets it.
Vec3 normal_at(const Object& object, double x, double y) {
    Scene scene;
    scene.objects = {object};
    const World world = compiled(scene);
    const Ray ray{{x, y, -50}, {0, 0, 1}};
    Hit hit;
    EXPECT_TRUE(world.nearest(ray, {}, RayKind::image, hit));
    return world.normal(hit, ray.at(hit.shape.t));
}

void expect_near(const Vec3& found, const Vec3& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << "component " << i;
}

TEST(Normal, FollowsTheInverseTransposeAndIsUnit) {
    Object object = with_color(Sphere{}, opaque);
    object.transform = Transform::scale({2, 1, 1});
    // The ellipsoid x^2/4 + y^2 + z^2 = 1 at x = 1: gradient (x/2, 2y, 2z).
    expect_near(normal_at(object, 1.0, 0.5), unit(Vec3(0.5, 1.0, -2.0 * std::sqrt(0.5))));
    object.inverse = true;
    expect_near(normal_at(object, 1.0, 0.5), -unit(Vec3(0.5, 1.0, -2.0 * std::sqrt(0.5))));
}

TEST(Normal, OfHugeAndTinyTrianglesIsStillUnit) {
    for (const double size : {1e-90, 1e-30, 1e30, 1e90}) {
        Scene scene;
        scene.objects = {with_color(Triangle{{-size, -size, 0}, {size, -size, 0}, {0, size, 0}}, opaque)};
        const World world = compiled(scene);
        const Hit hit{{1.0, 0, 0.3, 0.3}, 0, 0};
        expect_near(world.normal(hit, {}), {0, 0, -1});
    }
}

TEST(Normal, FlatFacesTurnAsInPovray) {
    // Measured: a triangle's side follows its corners as they stand after the transform, a mesh's follows the inverse transpose, and
    // `inverse` turns a mesh but not a triangle.
    const Vec3 a{-2, -2, 0}, b{2, -2, 0}, c{0, 2, 0};
    Object triangle = with_color(Triangle{a, b, c}, opaque);
    MeshData data;
    data.vertices = {a, b, c};
    data.faces = {{0, 1, 2}};
    Object mesh = with_color(Mesh{data}, opaque);
    expect_near(normal_at(triangle, 0, 0), {0, 0, -1});
    expect_near(normal_at(mesh, 0, 0), {0, 0, -1});
    triangle.transform = mesh.transform = Transform::scale({-1, 1, 1});
    expect_near(normal_at(triangle, 0, 0), {0, 0, 1});
    expect_near(normal_at(mesh, 0, 0), {0, 0, -1});
    triangle.inverse = mesh.inverse = true;
    expect_near(normal_at(triangle, 0, 0), {0, 0, 1});
    expect_near(normal_at(mesh, 0, 0), {0, 0, 1});
}

TEST(Normal, SmoothTrianglesTransformBeforeAndMeshesAfterInterpolation) {
    const Vec3 a{-1, -1, 0}, b{1, -1, 0}, c{0, 1, 0};
    const Vec3 na = unit(Vec3(-1, 0, -1)), nb = unit(Vec3(1, 0, -2)), nc = unit(Vec3(0, 1, -1));
    const Transform stretch = Transform::scale({1, 3, 0.4});
    const auto stretched = [](const Vec3& n) { return Vec3(n.x, n.y / 3.0, n.z / 0.4); };
    Object triangle = with_color(SmoothTriangle{a, b, c, na, nb, nc}, opaque);
    MeshData data;
    data.vertices = {a, b, c};
    data.faces = {{0, 1, 2}};
    data.normals = {na, nb, nc};
    data.normal_faces = {{0, 1, 2}};
    Object mesh = with_color(Mesh{data}, opaque);
    triangle.transform = mesh.transform = stretch;
    // (0, -1/5) before the stretch has the weights 0.3, 0.3, 0.4.
    expect_near(normal_at(triangle, 0, -0.6), unit(0.3 * unit(stretched(na)) + 0.3 * unit(stretched(nb)) + 0.4 * unit(stretched(nc))));
    expect_near(normal_at(mesh, 0, -0.6), unit(stretched(0.3 * na + 0.3 * nb + 0.4 * nc)));
}

TEST(Normal, TheFlatSideOfAMeshDecidesWhatIsInside) {
    MeshData data;
    data.vertices = {{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}};
    data.faces = {{0, 1, 2}};
    data.normals = {{0, 0, 1}};
    data.normal_faces = {{0, 0, 0}};
    Scene scene;
    scene.objects = {with_color(Mesh{data}, opaque),
                     with_color(SmoothTriangle{{-2, -2, 1}, {2, -2, 1}, {0, 2, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, opaque)};
    const World world = compiled(scene);
    const Ray ray{{0, 0, -5}, {0, 0, 1}};
    Hit hit;
    ASSERT_TRUE(world.nearest(ray, {}, RayKind::image, hit));
    EXPECT_FALSE(world.met_from_inside(hit, ray.at(5.0), ray.direction));
    ASSERT_TRUE(world.nearest(ray, {5.5, infinity}, RayKind::image, hit));
    EXPECT_TRUE(world.met_from_inside(hit, ray.at(6.0), ray.direction));
}

TEST(Rays, ThatAreNoRaysMeetNothing) {
    Random random(1);
    const Scene scene = random_scene(random, 60, 1.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Precision precision : {Precision::exact, Precision::fast}) {
        CompileOptions options;
        options.index = IndexKind::embree;
        options.precision = precision;
        const World world = compiled(scene, options);
        for (const double bad : {nan, infinity, -infinity}) {
            for (int component = 0; component < 6; ++component) {
                Ray ray{{0.1, 0.2, -3.0}, {0, 0, 1}};
                (component < 3 ? ray.origin : ray.direction)[component % 3] = bad;
                Hit hit;
                EXPECT_FALSE(world.nearest(ray, {}, RayKind::image, hit));
                EXPECT_FALSE(world.occluded(ray, {}));
            }
        }
        Hit hit;
        world.nearest({{0.1, 0.2, 0.3}, {0, 0, 0}}, {}, RayKind::image, hit);  // no direction: any answer, but an answer
        EXPECT_FALSE(world.nearest({{0.1, 0.2, -3}, {0, 0, 1}}, {nan, nan}, RayKind::image, hit));
        EXPECT_FALSE(world.nearest({{0.1, 0.2, -3}, {0, 0, 1}}, {2.0, 1.0}, RayKind::image, hit));
    }
}

TEST(Rays, BeyondTheRangeOfFloatsAreAnsweredInDouble) {
    for (const double extent : {1e-60, 1e-42, 1e39, 1e60, 1e120}) {
        Random random(5);
        Scene scene;
        for (int i = 0; i < 100; ++i) {
            scene.objects.push_back(with_color(Box{Vec3(-0.1 * extent), Vec3(0.1 * extent)}, opaque));
            scene.objects.back().transform = Transform::translate(random.in_cube(extent));
        }
        CompileOptions list, index;
        list.index = IndexKind::brute_force;
        index.index = IndexKind::embree;
        const World brute = compiled(scene, list), world = compiled(scene, index);
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const Ray ray = random_ray(random, scene, extent);
            Hit expected, found;
            const bool met = brute.nearest(ray, {}, RayKind::image, expected);
            hits += met;
            ASSERT_EQ(world.nearest(ray, {}, RayKind::image, found), met) << extent;
            if (met) {
                ASSERT_TRUE(found.object == expected.object && found.shape.t == expected.shape.t) << extent;
            }
        }
        EXPECT_GT(hits, 300) << extent;
    }
}

TEST(Compile, LeavesTheFloatingPointEnvironmentAlone) {
    Random random(2);
    const Scene scene = random_scene(random, 100, 1.0);
    CompileOptions options;
    options.index = IndexKind::embree;
    std::fesetenv(FE_DFL_ENV);
    compiled(scene, options);
#ifdef __SSE__
    EXPECT_EQ(_mm_getcsr() & ~0x3fu, 0x1f80u);
#endif
    volatile double tiny = std::numeric_limits<double>::min();
    EXPECT_GT(tiny / 4.0, 0.0);
}

TEST(Compile, ExtentAndSizeAreThoseOfTheBoundedSurfaces) {
    Scene scene;
    scene.objects = {with_color(Sphere{{-3, 0, 0}, 2}, opaque), with_color(Plane{{0, 1, 0}, -100}, opaque),
                     with_color(Sphere{{1, 1, 0}, 0.5}, opaque)};
    EXPECT_NEAR(compiled(scene).scene_extent, 5.0, 1e-12);  // bounds are rounded outward
    EXPECT_NEAR(compiled(scene).scene_size, 6.5, 1e-12);
}

}  // namespace
}  // namespace rt::compile_test
