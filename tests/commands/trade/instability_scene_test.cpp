// What grows with a scene, and what does not.
#include "commands/trade/instability_scene.h"

#include <gtest/gtest.h>

#include "tests/scene/checkers.h"
#include "world/compile.h"

namespace rt::instability_scene_test {
namespace {

constexpr double by = 4.0;  // exact

Scene with(Shape shape, const std::optional<Transform>& transform = {}) {
    Scene scene;
    Object object;
    object.shape = std::move(shape);
    object.transform = transform;
    scene.objects.push_back(std::move(object));
    return scene;
}

TEST(ScaledScene, EveryShapeGrows) {
    const Transform moved = Transform::rotate({10, 20, 30}, Rotation::povray).then(Transform::translate({5, 6, 7}));
    const Polygon polygon{{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {0, 0, 1}}};
    MeshData mesh;
    mesh.vertices = {{0, 0, 1}, {1, 0, 0}, {0, 3, 0}};
    mesh.faces = {{0, 1, 2}};
    const Vec3 a(0, 0, 1), b(1, 0, 0), c(0, 3, 0), n(0, 0, 1);
    const Shape shapes[] = {Sphere{{1, 2, 3}, 2},
                            Plane{{0, 1, 0}, 3},
                            Box{{-1, -2, -3}, {1, 2, 3}},
                            Cone{{0, 1, 0}, 1, {1, 4, 0}},
                            Torus{1.5, 1},
                            Disc{{1, 2, 3}, {0, 1, 0}, 2, 1},
                            Triangle{a, b, c},
                            SmoothTriangle{a, b, c, n, n, n},
                            polygon,
                            Mesh{mesh}};
    for (const Shape& shape : shapes) {
        for (const std::optional<Transform>& transform : {std::optional<Transform>{}, std::optional(moved)}) {
            const Scene scene = with(shape, transform);
            CompileOptions options;
            options.index = IndexKind::brute_force;
            const auto silent = [](std::string_view) {};
            const World before = compile(scene, options, silent), after = compile(scaled(scene, by), options, silent);
            int hits = 0;
            for (int i = 0; i < 400; ++i) {
                const Vec3 target =
                    (transform ? transform->point({1, 2, 3}) : Vec3(0.7, 1, 0.5)) + 0.2 * Vec3(i % 7 - 3, i % 11 - 5, i % 5);
                const Vec3 origin(i % 13 - 6, 9.0 - i % 3, -12);
                Hit one, other;
                const bool met = before.nearest({origin, unit(target - origin)}, {}, RayKind::image, one);
                ASSERT_EQ(after.nearest({by * origin, unit(target - origin)}, {}, RayKind::image, other), met) << name(shape);
                if (!met) continue;
                ++hits;
                EXPECT_NEAR(other.shape.t, by * one.shape.t, 1e-12 * other.shape.t) << name(shape);
                const Vec3 at = origin + one.shape.t * unit(target - origin);
                EXPECT_LT(length(before.normal(one, at) - after.normal(other, by * at)), 1e-12) << name(shape);
            }
            EXPECT_GT(hits, 10) << name(shape);
        }
    }
}

TEST(ScaledScene, DistancesInsideGrowAndSharedOnesOfOthersStay) {
    Scene scene = with(Sphere{});
    Interior interior;
    interior.fade_distance = 3.0, interior.fade_power = 2.0, interior.ior = 1.5;
    scene.objects[0].interior = Shared<Interior>(interior);
    const Scene larger = scaled(scene, by);
    EXPECT_EQ((*larger.objects[0].interior)->fade_distance, 12.0);
    EXPECT_EQ((*larger.objects[0].interior)->fade_power, 2.0);
    EXPECT_EQ((*larger.objects[0].interior)->ior, 1.5);
    EXPECT_EQ((*scene.objects[0].interior)->fade_distance, 3.0);
}

TEST(ScaledScene, LampsGrowButForTheirAngles) {
    Scene scene;
    Light& spot = scene.lights.emplace_back();
    spot.type = Light::Type::spotlight;
    spot.location = {1, 2, 3}, spot.point_at = {4, 5, 6};
    spot.radius = 30.0, spot.falloff = 45.0, spot.tightness = 10.0, spot.fade_distance = 7.0, spot.fade_power = 2.0;
    spot.area.emplace();
    spot.area->axis1 = {1, 0, 0}, spot.area->axis2 = {0, 0, 2};
    Light& cylinder = scene.lights.emplace_back(spot);
    cylinder.type = Light::Type::cylinder;
    const Scene larger = scaled(scene, by);
    for (const Light& light : larger.lights) {
        EXPECT_EQ(light.location, Vec3(4, 8, 12));
        EXPECT_EQ(light.point_at, Vec3(16, 20, 24));
        EXPECT_EQ(light.fade_distance, 28.0);
        EXPECT_EQ(light.fade_power, 2.0);
        EXPECT_EQ(light.tightness, 10.0);
        EXPECT_EQ(light.area->axis1, Vec3(4, 0, 0));
        EXPECT_EQ(light.area->axis2, Vec3(0, 0, 8));
    }
    EXPECT_EQ(larger.lights[0].radius, 30.0);
    EXPECT_EQ(larger.lights[0].falloff, 45.0);
    EXPECT_EQ(larger.lights[1].radius, 120.0);
    EXPECT_EQ(larger.lights[1].falloff, 180.0);
}

TEST(ScaledScene, CamerasSeeTheSame) {
    Scene scene;
    Camera& camera = scene.camera;
    camera.location = {1, 2, -8}, camera.look_at = Vec3(0, 1, 0), camera.angle = 50.0;
    camera.transform = Transform::rotate({0, 10, 0}, Rotation::povray).then(Transform::translate({1, 0, 0}));
    for (const Projection type : {Projection::perspective, Projection::orthographic}) {
        for (const bool stated : {false, true}) {
            camera.projection = type, camera.up_or_right_stated = stated;
            const auto silent = [](std::string_view) {};
            const CameraBasis a = camera_basis(camera, Profile::povray, {}, silent);
            const CameraBasis b = camera_basis(scaled(scene, by).camera, Profile::povray, {}, silent);
            const double across = type == Projection::orthographic ? by : 1.0;
            EXPECT_LT(length(b.origin - by * a.origin), 1e-13);
            EXPECT_LT(length(unit(b.direction) - unit(a.direction)), 1e-14);
            EXPECT_LT(length(b.right - across * a.right), 1e-13);
            EXPECT_LT(length(b.up - across * a.up), 1e-13);
        }
    }
    camera.projection = Projection::perspective;
    const auto silent = [](std::string_view) {};
    const CameraBasis a = camera_basis(camera, Profile::csc473, {}, silent);
    const CameraBasis b = camera_basis(scaled(scene, by).camera, Profile::csc473, {}, silent);
    EXPECT_EQ(b.origin, by * a.origin);
    EXPECT_EQ(b.direction, a.direction);
    EXPECT_EQ(b.right, a.right);
}

Pigment squares() {
    Pigment black, white;
    white.content = PigmentColor{Rgb(1.0), 0.0, 0.0};
    black.content = PigmentColor{};
    return checker_of(white, black);
}

TEST(ScaledScene, PatternsGrowOnceAndStayShared) {
    Scene scene = with(Sphere{});
    const Pigment inner = checker_of(squares(), squares(), Transform::scale(Vec3(0.1)));
    const Pigment outer = checker_of(inner, inner, Transform::translate({1, 2, 3}));
    scene.objects[0].texture = TextureLayers({{PlainTexture{outer, {}}}, {PlainTexture{squares(), {}}}});
    scene.objects[0].interior_texture =
        TextureLayers({checker_of({{PlainTexture{squares(), {}}}}, {{PlainTexture{}}}, Transform::translate({1, 0, 0}))});
    scene.objects[0].shape_textures = std::vector<TextureLayers>{TextureLayers({{PlainTexture{squares(), {}}}})};
    scene.objects.push_back(scene.objects[0]);
    Object plain;
    plain.texture = TextureLayers({{PlainTexture{}}});
    scene.objects.push_back(plain);

    const Scene larger = scaled(scene, by);
    const auto& layers = **larger.objects[0].texture;
    const Pigment& pigment = std::get<PlainTexture>(layers[0].content).pigment;
    EXPECT_EQ(moved(pigment, {1, 1, 1}), Vec3(8, 12, 16));
    const auto& cells = *std::get<Shared<PigmentMap>>(pattern_of(pigment).map);
    EXPECT_EQ(cells.pigments[0], inner) << "it lies in the outer one's space";
    EXPECT_EQ(moved(std::get<PlainTexture>(layers[1].content).pigment, {1, 1, 1}), Vec3(4, 4, 4));
    const PatternTexture& textures = pattern_of((**larger.objects[0].interior_texture)[0]);
    EXPECT_EQ(moved(textures.pattern.pattern, {1, 1, 1}), Vec3(8, 4, 4));
    EXPECT_EQ(std::get<PlainTexture>(textures.map->textures[0]->at(0).content).pigment, squares()) << "likewise";
    const auto& of_shape = std::get<PlainTexture>((**larger.objects[0].shape_textures)[0]->at(0).content);
    EXPECT_EQ(moved(of_shape.pigment, {1, 1, 1}), Vec3(4, 4, 4));
    EXPECT_EQ(larger.objects[1].texture->identity(), larger.objects[0].texture->identity());
    EXPECT_EQ(larger.objects[2].texture->identity(), scene.objects[2].texture->identity()) << "nothing in it to grow";
}

}  // namespace
}  // namespace rt::instability_scene_test
