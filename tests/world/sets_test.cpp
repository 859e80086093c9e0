// Sets against their inside, evaluated along the ray: whatever coincides, touches or is nested, surfaces are where the inside changes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "geometry/hits.h"
#include "tests/world/random_scene.h"
#include "world/surface_index.h"

namespace rt::sets_test {
namespace {

using Kind = SetNode::Kind;

int effort() { return std::getenv("RAYTRACE_DEEP") ? 100 : 1; }

/// A tree of bodies with all that the test asks of it.
struct Tree {
    Scene scene;
    ObjectSet set;

    bool holds(std::size_t node, const Vec3& p) const {
        const SetNode& n = set.nodes[node];
        if (n.kind == Kind::surface) {
            const Object& object = scene.objects[n.index];
            const Vec3 q = object.transform ? object.transform->inverse_point(p) : p;
            // Planes to the last bit, not with the tolerance that they have elsewhere.
            if (const auto* plane = std::get_if<Plane>(&object.shape)) return (dot(q, plane->normal) < plane->distance) != object.inverse;
            return std::visit([&](const auto& shape) { return contains(shape, q); }, object.shape) != object.inverse;
        }
        const bool any = n.kind != Kind::all;
        for (std::size_t i = node + 1; i < node + n.size; i += set.nodes[i].size)
            if (holds(i, p) == any) return any;
        return !any;
    }

    /// Every distance at which the ray meets any of the shapes, in order.
    std::vector<double> crossings(const Ray& ray) const {
        std::vector<double> ts;
        for (const Object& object : scene.objects) {
            const Ray r = object.transform ? object.transform->inverse_ray(ray) : ray;
            std::visit(
                [&](const auto& shape) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
                        visit_hits(shape, r, {}, [&](const ShapeHit& hit) {
                            ts.push_back(hit.t);
                            return false;
                        });
                },
                object.shape);
        }
        std::sort(ts.begin(), ts.end());
        return ts;
    }
};

/// Numbers from a few, so that faces coincide.
double coarse(Random& random) { return 0.5 * random.whole(5) - 1.0; }
Vec3 coarse_point(Random& random) { return {coarse(random), coarse(random), coarse(random)}; }

Shape random_solid(Random& random) {
    switch (random.whole(6)) {
        case 0:
            return Sphere{coarse_point(random), 0.5 + 0.25 * random.whole(4)};
        case 1: {
            Vec3 normal(0.0);
            normal[random.whole(3)] = random.chance(0.5) ? 1.0 : -1.0;
            return Plane{random.chance(0.7) ? normal : random.direction(), coarse(random)};
        }
        case 2: {
            const Vec3 base = coarse_point(random);
            Vec3 axis(0.0);
            axis[random.whole(3)] = 0.5 * (1 + random.whole(3));
            return Cone{base, 0.5, base + axis, random.chance(0.5) ? 0.5 : 0.25 * random.whole(4), false};
        }
        case 3:
            return Torus{0.5 + 0.25 * random.whole(2), 0.25};
        default: {
            const Vec3 a = coarse_point(random);
            return Box{a, a + Vec3(0.5 * (1 + random.whole(4)), 0.5 * (1 + random.whole(4)), 0.5 * (1 + random.whole(4)))};
        }
    }
}

Object body(const Shape& shape, bool inverse = false) {
    Object object;
    object.shape = shape;
    object.inverse = inverse;
    object.texture = TextureLayers(std::vector<Texture>(1));
    return object;
}

/// `slanted` turns everything, so that no ray and no face is parallel to an axis.
std::uint32_t add_body(Random& random, Tree& tree, int depth, const std::optional<Transform>& slanted) {
    const std::size_t at = tree.set.nodes.size();
    tree.set.nodes.emplace_back();
    if (depth == 0 || random.chance(0.3)) {
        std::vector<Object>& objects = tree.scene.objects;
        tree.set.nodes[at].index = static_cast<std::uint32_t>(objects.size());
        const bool twin = !objects.empty() && random.chance(0.1);
        objects.push_back(twin ? objects[random.whole(static_cast<int>(objects.size()))] : body(random_solid(random)));
        objects.back().inverse = random.chance(0.35);
        objects.back().transform = slanted;
        return 1;
    }
    std::uint32_t size = 1;
    const Kind kind = random.chance(0.6) ? Kind::all : Kind::merged;
    const int parts = 2 + random.whole(3);
    for (int i = 0; i < parts; ++i) size += add_body(random, tree, depth - 1, slanted);
    tree.set.nodes[at].kind = kind;
    tree.set.nodes[at].size = size;
    return size;
}

Tree random_tree(Random& random) {
    Tree tree;
    std::optional<Transform> slanted;
    if (random.chance(0.5))
        slanted = Transform::rotate(360.0 * random.in_cube(1.0), Rotation::povray).then(Transform::scale(Vec3(1.5, 1, 1)));
    while (tree.set.nodes.size() < 2) {
        tree = {};
        add_body(random, tree, 3, slanted);
    }
    tree.scene.sets.push_back(tree.set);
    return tree;
}

/// At corners, edges and faces of the grid that everything stands on, or anywhere. Along an axis, or at least 1e-5 off: closer to a face a
/// ray meets faces that cross at a corner within their errors, in an order that nobody can tell.
Ray ray_at(Random& random) {
    const Vec3 target = random.chance(0.5) ? coarse_point(random) : random.in_cube(1.5);
    Vec3 direction = random.direction();
    if (random.chance(0.2)) direction = unit(coarse_point(random) + random.log(1e-4, 1e-2) * random.direction());
    if (random.chance(0.05)) direction = unit(Vec3(random.whole(2), 1.0, random.whole(2)));
    for (int axis = 0; axis < 3; ++axis)
        if (std::fabs(direction[axis]) < 1e-5) direction[axis] = 0.0;
    direction = unit(direction);
    return {target - random.real(3.0, 30.0) * direction, direction};
}

std::vector<double> hits_of(const World& world, const Ray& ray) {
    std::vector<double> ts;
    Interval range;
    Hit hit;
    while (world.nearest(ray, range, RayKind::image, hit)) {
        ts.push_back(hit.shape.t);
        range.min = hit.shape.t;
    }
    return ts;
}

std::string listed(const std::vector<double>& ts) {
    std::string text;
    for (const double t : ts) text += fmt::format(" {:.17g}", t);
    return text;
}

/// Crossings within this of each other are one to the test, and so are the hits there.
double together(double t) { return 1e-5 + 1e-9 * t; }

/// Compares the world's hits with the changes of the inside; says what is wrong.
std::string fault(const Tree& tree, const World& world, const Ray& ray) {
    const std::vector<double> ts = tree.crossings(ray), hits = hits_of(world, ray);
    const auto told = [&](double t) { return fmt::format("at {:.17g}: crossings{}; hits{}", t, listed(ts), listed(hits)); };
    std::size_t next_hit = 0;
    bool before = ts.empty() ? false : tree.holds(0, ray.at(0.5 * ts.front()));
    for (std::size_t i = 0; i < ts.size();) {
        std::size_t end = i + 1;
        while (end < ts.size() && ts[end] - ts[end - 1] < together(ts[end])) ++end;
        const double from = ts[i] - 0.1 * together(ts[i]), to = ts[end - 1] + 0.1 * together(ts[i]);
        const bool tight = ts[end - 1] - ts[i] < 1e-7 * together(ts[i]);
        const bool behind = tree.holds(0, ray.at(end < ts.size() ? 0.5 * (ts[end - 1] + ts[end]) : to + 1.0));
        std::size_t count = 0;
        for (; next_hit < hits.size() && hits[next_hit] < to; ++next_hit, ++count)
            if (hits[next_hit] < from) return "a surface where none is, " + told(hits[next_hit]);
        if (before != behind && count == 0) return "no surface " + told(ts[i]);
        if (tight && count != (before != behind ? 1u : 0u)) return fmt::format("{} surfaces {}", count, told(ts[i]));
        before = behind;
        i = end;
    }
    return next_hit < hits.size() ? "a surface where none is, " + told(hits[next_hit]) : "";
}

TEST(Sets, SurfacesAreWhereTheInsideChanges) {
    constexpr int rays = 100;
    for (int seed = 0; seed < 1000 * effort(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Tree tree = random_tree(random);
        CompileOptions options;
        options.index = seed % 2 == 0 ? IndexKind::embree : IndexKind::brute_force;
        options.threads = 1;
        const World world = compile(tree.scene, options, no_messages);
        for (int i = 0; i < rays; ++i) {
            const Ray ray = ray_at(random);
            ASSERT_EQ(fault(tree, world, ray), "") << "seed " << seed << " ray " << i;
        }
    }
}

/// A set of all the objects.
Scene scene_of(Kind kind, std::vector<Object> objects) {
    Scene scene;
    ObjectSet set;
    set.nodes.emplace_back().kind = kind;
    for (std::uint32_t i = 0; i < objects.size(); ++i) set.nodes.emplace_back().index = i;
    set.nodes.front().size = static_cast<std::uint32_t>(set.nodes.size());
    scene.objects = std::move(objects);
    scene.sets.push_back(std::move(set));
    return scene;
}

World compiled(const Scene& scene) {
    CompileOptions options;
    options.index = IndexKind::brute_force;
    options.threads = 1;
    return compile(scene, options, no_messages);
}

TEST(Sets, WhereABoxTakesAwayAFaceNoFilmIsLeft) {
    const World world = compiled(scene_of(Kind::all, {body(Box{Vec3(-1), Vec3(1)}), body(Box{Vec3(-0.5, -0.5, -1), Vec3(0.5)}, true)}));
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from(random.real(-3, 3), random.real(-3, 3), -5), through(random.real(-0.45, 0.45), random.real(-0.45, 0.45), -1);
        Hit hit;
        ASSERT_TRUE(world.nearest({from, unit(through - from)}, {}, RayKind::image, hit));
        EXPECT_EQ(hit.object, 1u);
    }
}

TEST(Sets, AFaceBetweenTwoBodiesOfAMergeIsNone) {
    const World world = compiled(scene_of(Kind::merged, {body(Box{Vec3(-1), Vec3(0, 1, 1)}), body(Box{Vec3(0, -1, -1), Vec3(1)})}));
    EXPECT_EQ(hits_of(world, {Vec3(-5, 0.2, 0.3), Vec3(1, 0, 0)}), (std::vector<double>{4.0, 6.0}));
}

TEST(Sets, PartsReachNoFartherThanTheOthers) {
    const Scene scene =
        scene_of(Kind::all, {body(Plane{Vec3(0, 1, 0), 0.0}), body(Sphere{Vec3(0.0), 1.0}), body(Sphere{Vec3(9, 0, 0), 1.0}, true)});
    Surfaces surfaces;
    for (const Object& object : scene.objects) surfaces.add(object, 7);
    surfaces.add_set(scene.sets.front());
    EXPECT_TRUE(surfaces.bounds(0).is_finite());
    EXPECT_EQ(surfaces.objects[1].count, 1u);
    EXPECT_EQ(surfaces.objects[2].count, 0u) << "no piece of it can be seen, so no index has it";
}

TEST(Sets, BelowAHeightFieldIsItsInside) {
    HeightField flat;
    flat.data = HeightFieldData(2, 2, {100, 100, 100, 100});
    const World world = compiled(scene_of(Kind::all, {body(Box{Vec3(0.2, -3, 0.2), Vec3(0.8, 1, 0.8)}), body(FurtherShape(flat))}));
    EXPECT_EQ(hits_of(world, {Vec3(0.5, 2, 0.5), Vec3(0, -1, 0)}), (std::vector<double>{2.0 - 0x64p-16, 5.0}));
}

TEST(Sets, InsideIsInsideOfTheWhole) {
    const Scene scene = scene_of(Kind::all, {body(Sphere{Vec3(0.0), 1.0}), body(Sphere{Vec3(1, 0, 0), 1.0}, true)});
    Surfaces surfaces;
    for (const Object& object : scene.objects) surfaces.add(object, 7);
    surfaces.add_set(scene.sets.front());
    for (const std::uint32_t part : {0u, 1u}) {
        EXPECT_TRUE(surfaces.contains(part, Vec3(-0.5, 0, 0)));
        EXPECT_FALSE(surfaces.contains(part, Vec3(0.5, 0, 0)));
        EXPECT_FALSE(surfaces.contains(part, Vec3(-3, 0, 0)));
    }
}

/// A sheet contains nothing: of the others nothing is left, of the sheet what lies in them, on whichever side a ray comes.
TEST(Sets, OfAnIntersectionWithASheetThePieceOfTheSheetIsLeft) {
    const std::vector<Shape> sheets{Polygon{{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(9, 9, 0), Vec3(-9, 9, 0), Vec3(-9, -9, 0)}},
                                    Triangle{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 18, 0)}};
    for (const Shape& sheet : sheets) {
        const World world = compiled(scene_of(Kind::all, {body(Sphere{Vec3(0.0), 1.0}), body(sheet)}));
        for (const double side : {-1.0, 1.0}) {
            const std::vector<double> hits = hits_of(world, {Vec3(0.2, 0.3, 5.0 * side), Vec3(0, 0, -side)});
            ASSERT_EQ(hits.size(), 1u) << name(sheet);
            EXPECT_NEAR(hits[0], 5.0, 1e-12);
        }
        EXPECT_EQ(hits_of(world, {Vec3(2, 0.3, -5), Vec3(0, 0, 1)}).size(), 0u) << name(sheet);
    }
}

TEST(Sets, AClipCutsAndIsNotSeen) {
    Scene scene = scene_of(Kind::all, {body(Sphere{Vec3(0.0), 1.0})});
    ObjectSet& set = scene.sets.front();
    set.solids.push_back({Plane{Vec3(1, 0, 0), 0.0}, {}, false});
    SetNode clip;
    clip.kind = Kind::solid;
    set.nodes.push_back(clip);
    set.nodes.front().size = 3;
    set.nodes.front().clips = true;
    const World world = compiled(scene);
    EXPECT_EQ(hits_of(world, {Vec3(-5, 0, 0), Vec3(1, 0, 0)}), (std::vector<double>{4.0}));
    EXPECT_EQ(hits_of(world, {Vec3(-0.5, 0, -5), Vec3(0, 0, 1)}).size(), 2u);
    EXPECT_EQ(hits_of(world, {Vec3(0.5, 0, -5), Vec3(0, 0, 1)}).size(), 0u);
    EXPECT_EQ(world.surfaces->listed().size(), 1u) << "no ray asks for what clips";
}

/// However many of its parts it stands in, the camera is in a set once, with the interior that is stated of the whole.
TEST(Sets, ACameraInsideIsInsideOnce) {
    Scene scene = scene_of(Kind::merged, {body(Sphere{Vec3(0.0), 1.0}), body(Box{Vec3(-1), Vec3(1)})});
    for (Object& object : scene.objects) {
        object.medium = 1;
        object.interior.emplace().edit().ior = 1.5;
    }
    for (SetNode& node : scene.sets.front().nodes) node.medium = 1;
    Texture glass;
    std::get<PlainTexture>(glass.content).pigment.content = PigmentColor{Rgb(1.0), 1.0, 0.0};
    for (Object& object : scene.objects) object.texture = TextureLayers(std::vector<Texture>{glass});
    const World inside = compiled(scene);
    EXPECT_EQ(inside.objects[0].interior, inside.objects[1].interior) << "one medium";
    ASSERT_EQ(inside.camera_interiors.size(), 1u);
    EXPECT_EQ(inside.interiors[inside.camera_interiors[0]].ior, 1.5);
    scene.camera.location = Vec3(0, 0, -7);
    EXPECT_TRUE(compiled(scene).camera_interiors.empty());
}

}  // namespace
}  // namespace rt::sets_test
