// What POV-Ray shows of bodies that reach out of their bounds, or of the boxes that it makes of their parts. Each case is a scene that
// POV-Ray rendered, seen along z.
#include <gtest/gtest.h>

#include "tests/world/random_scene.h"
#include "world/surface_index.h"

namespace rt::gates_test {
namespace {

using Kind = SetNode::Kind;

Object body(const Shape& shape) {
    Object object;
    object.shape = shape;
    object.texture = TextureLayers(std::vector<Texture>(1));
    return object;
}

/// x^2 + y^2 + z^2 = 1 as a surface without a box.
FurtherShape ball() { return make_poly(2, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}); }

/// The object, the first of the scene, with what it is bounded by.
void bound(Scene& scene, const Shape& by) {
    ObjectSet set;
    set.nodes.resize(3);
    set.nodes[0].kind = Kind::bounded;
    set.nodes[0].size = 3;
    set.nodes[2].kind = Kind::solid;
    set.solids.push_back({by, {}, false});
    scene.sets.push_back(set);
}

/// Makes what is bounded and the second object the parts of one body.
void join(Scene& scene, Kind kind) {
    std::vector<SetNode>& nodes = scene.sets.front().nodes;
    SetNode whole;
    whole.kind = kind;
    whole.size = 5;
    nodes.insert(nodes.begin(), whole);
    nodes.emplace_back().index = 1;
}

void add_others(Scene& scene) {
    for (const double x : {50.0, 60.0, 70.0}) scene.objects.push_back(body(Sphere{Vec3(x, 0, 0), 1.0}));
}

World compiled(const Scene& scene, IndexKind index = IndexKind::embree) {
    CompileOptions options;
    options.index = index;
    options.threads = 1;
    return compile(scene, options, no_messages);
}

/// Where a ray along z from (x, y, -5) meets the scene first; 0 if nowhere.
double first_hit(const World& world, double x, double y) {
    Hit hit;
    return world.nearest({Vec3(x, y, -5), Vec3(0, 0, 1)}, {}, RayKind::image, hit) ? hit.shape.t : 0.0;
}

TEST(Gates, ARayThatMissesTheBoundMissesTheObject) {
    Scene scene;
    scene.objects.push_back(body(ball()));
    bound(scene, Sphere{Vec3(0.5, 0, 0), 0.6});
    add_others(scene);
    for (const IndexKind index : {IndexKind::embree, IndexKind::brute_force}) {
        const World world = compiled(scene, index);
        EXPECT_NEAR(first_hit(world, 0.5, 0.0), 5.0 - std::sqrt(0.75), 1e-9) << "in front of the bound, yet seen through it";
        EXPECT_EQ(first_hit(world, -0.2, 0.0), 0.0);
        EXPECT_EQ(first_hit(world, 0.0, 0.55), 0.0) << "in the bound's box, but not in it";
        EXPECT_TRUE(world.occluded({Vec3(0.5, 0.0, -5), Vec3(0, 0, 1)}, {0.0, 4.5}));
        EXPECT_FALSE(world.occluded({Vec3(-0.2, 0.0, -5), Vec3(0, 0, 1)}, {}));
    }
}

TEST(Gates, AShapeWithABoxHasOnlyTheBoxOfItsBounds) {
    Scene scene;
    scene.objects.push_back(body(Torus{0.7, 0.3}));
    scene.objects.front().transform = Transform::rotate(Vec3(90, 0, 0), Rotation::povray);
    bound(scene, Sphere{Vec3(0.5, 0, 0), 0.6});
    add_others(scene);
    const World world = compiled(scene);
    EXPECT_GT(first_hit(world, 0.0, 0.55), 0.0);
    EXPECT_EQ(first_hit(world, 0.0, 0.65), 0.0);
    scene.sets.front().solids.front().shape = Box{Vec3(-5, -0.2, -5), Vec3(5, 0.2, 5)};
    EXPECT_GT(first_hit(compiled(scene), 0.0, 0.65), 0.0) << "a larger box than its own is none";
}

/// Spheres, boxes and their like are asked as they are where a scene has one or two objects, lights included.
TEST(Gates, OfFewObjectsSomeHaveNoBox) {
    Scene scene;
    scene.objects.push_back(body(Sphere{Vec3(0.0), 1.0}));
    bound(scene, Sphere{Vec3(0.5, 0, 0), 0.6});
    EXPECT_GT(first_hit(compiled(scene), -0.2, 0.0), 0.0);
    scene.lights.resize(1);
    EXPECT_GT(first_hit(compiled(scene), -0.2, 0.0), 0.0);
    scene.lights.resize(2);
    EXPECT_EQ(first_hit(compiled(scene), -0.2, 0.0), 0.0);
    scene.lights.clear();
    scene.objects.front().shape = Torus{0.7, 0.5};
    EXPECT_EQ(first_hit(compiled(scene), -0.2, 0.0), 0.0);
    scene.objects.front().shape = Box{Vec3(-1), Vec3(1)};
    EXPECT_GT(first_hit(compiled(scene), -0.2, 0.0), 0.0);
}

/// What lies before the box is seen only where nothing is met before the box.
TEST(Gates, WhatIsBeforeTheBoxMayBeMissed) {
    Scene scene;
    scene.objects.push_back(body(Sphere{Vec3(0.0), 1.0}));
    bound(scene, Box{Vec3(-2, -2, 0.6), Vec3(2, 2, 0.7)});
    scene.objects.push_back(body(Box{Vec3(-2, -0.2, -0.2), Vec3(2, 0.2, 0.2)}));
    EXPECT_EQ(first_hit(compiled(scene), 0.0, 0.0), 4.0) << "two objects, both asked";
    scene.lights.resize(1);
    const World world = compiled(scene);
    EXPECT_NEAR(first_hit(world, 0.0, 0.0), 4.8, 1e-12);
    EXPECT_NEAR(first_hit(world, 0.0, 0.5), 5.0 - std::sqrt(0.75), 1e-12);
}

/// All behind a disc is its inside; its box is that of the square around it.
TEST(Gates, AnIntersectionWithADiscIsCutAtTheDiscsBox) {
    Scene scene;
    scene.objects.push_back(body(Disc{Vec3(0.0), unit(Vec3(1, 2, 0.5)), 0.6, 0.0}));
    scene.objects.push_back(body(Sphere{Vec3(0.0), 1.0}));
    ObjectSet set;
    set.nodes.resize(3);
    set.nodes[0].kind = Kind::all;
    set.nodes[0].size = 3;
    set.nodes[2].index = 1;
    scene.sets.push_back(set);
    for (const std::size_t lights : {0u, 3u}) {
        scene.lights.resize(lights);
        const World world = compiled(scene);
        EXPECT_NEAR(first_hit(world, -0.69, 0.0), 5.0 - std::sqrt(1.0 - 0.69 * 0.69), 1e-9);
        EXPECT_EQ(first_hit(world, -0.70, 0.0), 0.0);
        EXPECT_GT(first_hit(world, 0.0, -0.41), 0.0);
        EXPECT_EQ(first_hit(world, 0.0, -0.42), 0.0);
    }
}

/// Of a part of a set the bounds count as well, but not its box.
TEST(Gates, PartsHaveBoundsOfTheirOwn) {
    Scene scene;
    scene.objects.push_back(body(Torus{0.8, 0.3}));
    scene.objects.front().transform = Transform::rotate(Vec3(90, 0, 0), Rotation::povray);
    scene.objects.push_back(body(Sphere{Vec3(0, 1.2, 0), 0.2}));
    bound(scene, Sphere{Vec3(0.5, 0, 0), 0.6});
    join(scene, Kind::merged);
    add_others(scene);
    const World world = compiled(scene);
    EXPECT_GT(first_hit(world, 0.8, 0.0), 0.0);
    EXPECT_EQ(first_hit(world, -0.8, 0.0), 0.0);
    EXPECT_EQ(first_hit(world, 0.0, 0.55), 0.0) << "inside of a set the bound itself counts";
    EXPECT_GT(first_hit(world, 0.0, 1.2), 0.0);
}

/// The inside of a height field goes down without end.
TEST(Gates, AHeightFieldLimitsNothingBelow) {
    Scene scene;
    scene.objects.push_back(body(Box{Vec3(-1, -3, 0.1), Vec3(2, 3, 0.9)}));
    HeightField field;
    field.data = HeightFieldData(2, 2, {40000, 40000, 40000, 40000});
    scene.objects.push_back(body(FurtherShape(field)));
    ObjectSet set;
    set.nodes.resize(3);
    set.nodes[0].kind = Kind::all;
    set.nodes[0].size = 3;
    set.nodes[2].index = 1;
    scene.sets.push_back(set);
    add_others(scene);
    EXPECT_NEAR(first_hit(compiled(scene), 0.5, -2.0), 5.1, 1e-9);
}

/// Of a body that is cut out the bounds take away what they do not meet, but nothing of what it is cut out of.
TEST(Gates, BoundsOfWhatIsCutOutAreNoBoxOfTheWhole) {
    Scene scene;
    scene.objects.push_back(body(ball()));
    scene.objects.front().inverse = true;
    scene.objects.push_back(body(Box{Vec3(-2, -2, 0), Vec3(2)}));
    bound(scene, Sphere{Vec3(0.5, 0, 0), 0.6});
    scene.sets.front().nodes.front().inverse = true;
    join(scene, Kind::all);
    add_others(scene);
    const World world = compiled(scene);
    EXPECT_EQ(first_hit(world, 1.5, 0.0), 5.0);
    EXPECT_NEAR(first_hit(world, 0.5, 0.0), 5.0 + std::sqrt(0.75), 1e-9);
    EXPECT_EQ(first_hit(world, -0.5, 0.0), 7.0) << "the hole is there, its surface is not seen";
}

TEST(Gates, BoundsThatHoldAllOfAnObjectMakeNoPartOfIt) {
    Scene scene;
    scene.objects.push_back(body(Sphere{Vec3(0.0), 1.0}));
    bound(scene, Box{Vec3(-1), Vec3(1)});
    const World tight = compiled(scene);
    EXPECT_EQ(tight.surfaces->surfaces().objects[0].kind, SurfaceKind::sphere);
    scene.objects.front().shape = ball();
    EXPECT_EQ(compiled(scene).surfaces->surfaces().objects[0].kind, SurfaceKind::part);
}

}  // namespace
}  // namespace rt::gates_test
