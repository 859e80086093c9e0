// Set operations beside the inside function of the whole along rays: random trees of parts that coincide, touch, lie in each other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/world/random_scene.h"
#include "world/surfaces.h"

namespace rt {
namespace {

/// RAYTRACE_DEEP=1 casts a hundred times the rays.
int effort() { return std::getenv("RAYTRACE_DEEP") ? 100 : 1; }

/// A tree of the test's own, with the inside as set theory has it.
struct Tree {
    Scene scene;
    SetPart root;

    /// POV-Ray's shapes, closed. `on` is whether points of the surface count.
    static bool encloses(const Object& object, const Vec3& p) {
        const Vec3 q = object.transform ? object.transform->inverse_point(p) : p;
        if (const auto* s = std::get_if<Sphere>(&object.shape)) return length(q - s->center) < s->radius;
        if (const auto* s = std::get_if<Plane>(&object.shape)) return dot(q, s->normal) < s->distance;
        if (const auto* s = std::get_if<Box>(&object.shape))
            return q.x > s->min.x && q.x < s->max.x && q.y > s->min.y && q.y < s->max.y && q.z > s->min.z && q.z < s->max.z;
        const auto& cone = std::get<Cone>(object.shape);  // along y, from 0
        const double height = (q.y - cone.base.y) / (cone.cap.y - cone.base.y);
        const double radius = cone.base_radius + height * (cone.cap_radius - cone.base_radius);
        return height > 0.0 && height < 1.0 && std::hypot(q.x - cone.base.x, q.z - cone.base.z) < radius;
    }

    bool contains(const SetPart& part, const Vec3& p) const {
        return part.complement != (part.what == SetPart::What::set ? contains(scene.sets[part.index], p) : in_body(part, p));
    }
    bool in_body(const SetPart& part, const Vec3& p) const {
        const Object& body = part.what == SetPart::What::clip ? scene.clips[part.index] : scene.objects[part.index];
        return encloses(body, p) != body.inverse;
    }
    bool contains(const SetNode& node, const Vec3& p) const {
        const auto holds = [&](const SetPart& inner) { return contains(inner, p); };
        if (!std::all_of(node.clips.begin(), node.clips.end(), holds)) return false;
        return node.kind == SetKind::intersection ? std::all_of(node.parts.begin(), node.parts.end(), holds)
                                                  : std::any_of(node.parts.begin(), node.parts.end(), holds);
    }
};

/// Corners on a coarse grid, so that faces, axes and centres of different parts are often the same.
double coarse(Random& random) { return 0.5 * (random.whole(7) - 3); }
Vec3 coarse_point(Random& random) { return {coarse(random), coarse(random), coarse(random)}; }

Shape random_body(Random& random) {
    switch (random.whole(4)) {
        case 0:
            return Sphere{coarse_point(random), 0.5 * (1 + random.whole(3))};
        case 1: {
            const Vec3 a = coarse_point(random);
            return Box{a, a + Vec3(0.5 * (1 + random.whole(4)), 0.5 * (1 + random.whole(4)), 0.5 * (1 + random.whole(4)))};
        }
        case 2: {
            const Vec3 axis[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, unit(Vec3(1, 1, 0))};
            return Plane{(random.chance(0.5) ? 1.0 : -1.0) * axis[random.whole(4)], coarse(random)};
        }
        default: {
            const Vec3 base = coarse_point(random);
            const double radius = 0.5 * (1 + random.whole(3));
            return Cone{base, radius, base + Vec3(0, 0.5 * (1 + random.whole(4)), 0), random.chance(0.5) ? radius : 0.5 * random.whole(3)};
        }
    }
}

Object random_object(Random& random) {
    Object object;
    object.shape = random_body(random);
    object.inverse = random.chance(0.15);
    // Quarter turns and powers of two keep coincidences.
    if (random.chance(0.3))
        object.transform = Transform::rotate(Vec3(90.0 * random.whole(4), 90.0 * random.whole(4), 0.0), Rotation::povray);
    object.texture = TextureLayers(std::vector<Texture>{{PlainTexture{}}});
    return object;
}

SetPart random_part(Random& random, Tree& tree, int depth);

SetPart random_set(Random& random, Tree& tree, int depth) {
    SetNode node;
    // Surfaces inside of a union are none of the set's.
    node.kind = random.chance(0.6) ? SetKind::intersection : SetKind::merge;
    const int parts = 2 + random.whole(2);
    for (int i = 0; i < parts; ++i) node.parts.push_back(random_part(random, tree, depth - 1));
    tree.scene.sets.push_back(node);
    return {SetPart::What::set, false, static_cast<std::uint32_t>(tree.scene.sets.size() - 1)};
}

SetPart random_part(Random& random, Tree& tree, int depth) {
    SetPart part;
    if (depth > 0 && random.chance(0.5)) {
        part = random_set(random, tree, depth);
    } else {
        if (!tree.scene.objects.empty() && random.chance(0.2))
            tree.scene.objects.push_back(tree.scene.objects[random.whole(static_cast<int>(tree.scene.objects.size()))]);
        else
            tree.scene.objects.push_back(random_object(random));
        part = {SetPart::What::object, false, static_cast<std::uint32_t>(tree.scene.objects.size() - 1)};
    }
    part.complement = random.chance(0.3);
    return part;
}

/// Everything but a merge shows the surfaces of an intersection, everything but an intersection those of a union, hidden ones included:
/// their trees have no complements of intersections.
bool shows_hidden_surfaces(const Tree& tree, const SetPart& part, bool flip = false) {
    if (part.what != SetPart::What::set) return false;
    const SetNode& node = tree.scene.sets[part.index];
    flip ^= part.complement;
    if (flip && node.kind == SetKind::intersection) return true;
    return std::any_of(node.parts.begin(), node.parts.end(),
                       [&](const SetPart& inner) { return shows_hidden_surfaces(tree, inner, flip); });
}

Tree random_tree(Random& random) {
    for (;;) {
        Tree tree;
        tree.root = random_set(random, tree, 2);
        if (!shows_hidden_surfaces(tree, tree.root)) return tree;
    }
}

World compiled(const Scene& scene, IndexKind index) {
    CompileOptions options;
    options.index = index;
    options.threads = 1;
    return compile(scene, options, no_messages);
}

/// All distances up to `end` at which the world's rays meet something.
std::vector<double> hits(const World& world, const Ray& ray, double end) {
    std::vector<double> all;
    Interval range{0.0, end};
    for (Hit hit; world.nearest(ray, range, RayKind::image, hit); range.min = hit.shape.t) all.push_back(hit.shape.t);
    return all;
}

/// Distances at which the inside of the tree begins or ends, from the surfaces of all parts alone; empty where two of them are so near
/// each other that it cannot be told, unless they are as good as one.
std::optional<std::vector<double>> boundaries(const Tree& tree, const World& parts, const Ray& ray, double end) {
    constexpr double same = 1e-9, apart = 1e-5;
    std::vector<double> candidates{0.0};
    for (const double t : hits(parts, ray, end)) {
        if (t - candidates.back() < same && candidates.size() > 1) continue;
        if (t - candidates.back() < apart) return std::nullopt;
        candidates.push_back(t);
    }
    candidates.push_back(end);
    std::vector<double> ends;
    bool before = tree.contains(tree.root, ray.at(0.5 * candidates[1]));
    for (std::size_t i = 1; i + 1 < candidates.size(); ++i) {
        const bool after = tree.contains(tree.root, ray.at(0.5 * (candidates[i] + candidates[i + 1])));
        if (after != before) ends.push_back(candidates[i]);
        before = after;
    }
    return ends;
}

/// As many distances, each once, whatever lies within a billionth of another.
std::vector<double> distinct(const std::vector<double>& all) {
    std::vector<double> once;
    for (const double t : all)
        if (once.empty() || t - once.back() > 1e-9) once.push_back(t);
    return once;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::fabs(x - y) < 1e-8; });
}

Ray random_ray(Random& random) {
    const Vec3 from = random.in_cube(6.0);
    if (random.chance(0.3)) {  // along an axis, off the grid
        Vec3 direction(0.0);
        direction[random.whole(3)] = random.chance(0.5) ? 1.0 : -1.0;
        return {from, direction};
    }
    return {from, unit(random.in_cube(2.0) - from)};
}

TEST(Sets, EveryIntervalIsThatOfTheInside) {
    constexpr double end = 30.0;
    Random random(7);
    std::size_t judged = 0, wrong = 0, met = 0;
    for (int i = 0; i < 400 * effort() && wrong < 5; ++i) {
        const Tree tree = random_tree(random);
        Scene separate = tree.scene;
        separate.sets.clear();
        const World parts = compiled(separate, IndexKind::brute_force);
        const World world = compiled(tree.scene, random.chance(0.5) ? IndexKind::embree : IndexKind::brute_force);
        for (int k = 0; k < 250; ++k) {
            const Ray ray = random_ray(random);
            const auto expected = boundaries(tree, parts, ray, end);
            if (!expected) continue;
            const std::vector<double> found = distinct(hits(world, ray, end));
            ++judged;
            met += !found.empty();
            if (same(found, *expected) || ++wrong > 5) continue;
            ADD_FAILURE() << fmt::format("tree {} ray {}: {} instead of {}", i, k, fmt::join(found, " "), fmt::join(*expected, " "));
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(judged, 80'000u * static_cast<unsigned>(effort()));
    EXPECT_GT(met, judged / 10);
}

Object body(const Shape& shape) {
    Object object;
    object.shape = shape;
    object.texture = TextureLayers(std::vector<Texture>{{PlainTexture{}}});
    return object;
}

Scene scene_of(std::vector<Object> objects, SetNode node) {
    Scene scene;
    scene.objects = std::move(objects);
    scene.sets.push_back(std::move(node));
    return scene;
}

SetPart part(std::uint32_t index, bool complement = false) { return {SetPart::What::object, complement, index}; }

/// A box minus one with the same front face has no front there, however a ray comes, and so no film of rounding errors.
TEST(Sets, FacesThatCoincideLeaveNothing) {
    const Scene scene = scene_of({body(Box{Vec3(-1), Vec3(1)}), body(Box{Vec3(-0.5, -0.5, -1), Vec3(0.5)})},
                                 {SetKind::intersection, {part(0), part(1, true)}, {}});
    const World world = compiled(scene, IndexKind::brute_force);
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from(random.real(-3, 3), random.real(-3, 3), -5), through(random.real(-0.45, 0.45), random.real(-0.45, 0.45), -1);
        Hit hit;
        ASSERT_TRUE(world.nearest({from, unit(through - from)}, {}, RayKind::image, hit));
        EXPECT_EQ(hit.object, 1u);
    }
}

TEST(Sets, OfASingleBodyTheOtherSideOfASharedFaceGoes) {
    const Scene scene =
        scene_of({body(Box{Vec3(-1), Vec3(0, 1, 1)}), body(Box{Vec3(0, -1, -1), Vec3(1)})}, {SetKind::merge, {part(0), part(1)}, {}});
    const World world = compiled(scene, IndexKind::brute_force);
    EXPECT_EQ(hits(world, {Vec3(-5, 0.2, 0.3), Vec3(1, 0, 0)}, 20.0), (std::vector<double>{4.0, 6.0}));
}

TEST(Sets, PartsBeyondTheOthersAreInNoIndex) {
    // A plane becomes bounded, and what cannot be seen at all is never asked.
    const Scene scene = scene_of({body(Plane{Vec3(0, 1, 0), 0.0}), body(Sphere{Vec3(0.0), 1.0}), body(Sphere{Vec3(9, 0, 0), 1.0})},
                                 {SetKind::intersection, {part(0), part(1), part(2, true)}, {}});
    Surfaces surfaces;
    for (const Object& object : scene.objects) surfaces.add(object, 7);
    surfaces.join(scene);
    EXPECT_TRUE(surfaces.bounds(0).is_finite());
    EXPECT_TRUE(surfaces.bounds(2).is_empty());
    EXPECT_FALSE(surfaces.bounds(1).is_empty());
}

TEST(Sets, InsideIsInsideOfAll) {
    const Scene scene =
        scene_of({body(Sphere{Vec3(0.0), 1.0}), body(Sphere{Vec3(1, 0, 0), 1.0})}, {SetKind::intersection, {part(0), part(1, true)}, {}});
    Surfaces surfaces;
    for (const Object& object : scene.objects) surfaces.add(object, 7);
    surfaces.join(scene);
    EXPECT_TRUE(surfaces.contains(0, Vec3(-0.5, 0, 0)));
    EXPECT_TRUE(surfaces.contains(1, Vec3(-0.5, 0, 0)));
    EXPECT_FALSE(surfaces.contains(0, Vec3(0.5, 0, 0)));
    EXPECT_FALSE(surfaces.contains(1, Vec3(0.5, 0, 0)));
    EXPECT_FALSE(surfaces.contains(1, Vec3(-3, 0, 0)));
}

}  // namespace
}  // namespace rt
