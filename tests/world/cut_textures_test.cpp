// What shows at the points of surfaces that cut a set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/world/random_scene.h"
#include "world/surface_index.h"

namespace rt::cut_textures_test {
namespace {

using Kind = SetNode::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double third = 1.0 / 3.0;

/// A node of a tree: its parts, or a shape with the number of its texture.
struct Stated {
    SetNode node;
    Shape shape;
    std::vector<Stated> parts;
    bool inverse = false;
};

Stated part(const Shape& shape, std::uint32_t texture) {
    Stated stated{{}, shape, {}};
    stated.node.texture = texture;
    return stated;
}

Stated cut(const Shape& shape) {
    Stated stated{{}, shape, {}};
    stated.node.cuts = true;
    return stated;
}

Stated inverted(Stated stated) {
    stated.inverse = true;
    return stated;
}

Stated set_of(Kind kind, std::vector<Stated> parts, bool clips = false) {
    Stated stated{{}, {}, std::move(parts)};
    stated.node.kind = kind;
    stated.node.clips = clips;
    return stated;
}

const std::vector<TextureLayers> three(3, std::vector<Texture>(1));

void add(const Stated& stated, Scene& scene) {
    ObjectSet& set = scene.sets.front();
    const std::size_t at = set.nodes.size();
    set.nodes.push_back(stated.node);
    for (const Stated& part : stated.parts) add(part, scene);
    set.nodes[at].size = static_cast<std::uint32_t>(set.nodes.size() - at);
    if (!stated.parts.empty()) return;
    set.nodes[at].index = static_cast<std::uint32_t>(scene.objects.size());
    Object object;
    object.shape = stated.shape;
    object.inverse = stated.inverse;
    object.texture = three.front();
    if (stated.node.cuts) object.shape_textures = three;
    scene.objects.push_back(object);
}

/// What shows where a ray along z from (x, 0, -5) first meets the tree.
std::vector<TextureWeight> shown(const Stated& tree, double x, double least = 0.0) {
    Scene scene;
    scene.sets.emplace_back();
    add(tree, scene);
    CompileOptions options;
    options.threads = 1;
    const World world = compile(scene, options, no_messages);
    const Ray ray{{x, 0, -5}, {0, 0, 1}};
    Hit hit;
    std::vector<TextureWeight> weights;
    if (world.nearest(ray, {}, RayKind::image, hit)) world.texture_weights(hit, ray.at(hit.shape.t), least, weights);
    return weights;
}

const Sphere left{{-0.5, 0, 0}, 1.0}, right{{0.5, 0, 0}, 1.0};
const Plane behind{{0, 0, -1}, 0.0};  // the half space z > 0

TEST(CutTextures, ThePartsThatContainThePointShowInEqualShares) {
    const Stated cut_union = set_of(Kind::all, {set_of(Kind::any, {part(left, 0), part(right, 1)}), cut(behind)});
    EXPECT_THAT(shown(cut_union, -1.0), ElementsAre(TextureWeight{0, 1.0}));
    EXPECT_THAT(shown(cut_union, 0.25), ElementsAre(TextureWeight{0, 0.5}, TextureWeight{1, 0.5}));
    EXPECT_THAT(shown(cut_union, 1.0), ElementsAre(TextureWeight{1, 1.0}));
    EXPECT_THAT(shown(set_of(Kind::all, {part(left, 0), part(right, 1), part(left, 0), cut(behind)}), 0.0),
                ElementsAre(TextureWeight{0, 2 * third}, TextureWeight{1, third}));
    EXPECT_THAT(shown(set_of(Kind::all, {part(left, 0), inverted(part(Sphere{{0.5, 0, 0}, 0.25}, 1)), cut(behind)}), 0.0),
                ElementsAre(TextureWeight{0, 0.5}, TextureWeight{1, 0.5}))
        << "outside of an inverse part is inside";
}

TEST(CutTextures, SharesBelowTheLeastDoNotShow) {
    const Stated two = set_of(Kind::all, {part(left, 0), part(left, 0), part(right, 1), cut(behind)});
    EXPECT_THAT(shown(two, 0.0, 0.4), IsEmpty()) << "a part counts alone";
    EXPECT_EQ(shown(two, 0.0, 0.3).size(), 2u);
    EXPECT_THAT(shown(set_of(Kind::all, {part(left, 0), cut(behind)}), 0.0, 0.9), ElementsAre(TextureWeight{0, 1.0}));
}

TEST(CutTextures, PartsOfAnIntersectionShowTogetherOrNotAtAll) {
    const Stated both = set_of(Kind::all, {part(right, 0), part(left, 1)});
    const Stated tree = set_of(Kind::all, {set_of(Kind::any, {both, part(Sphere{{0.9, 0, 0}, 0.6}, 2)}), cut(behind)});
    EXPECT_THAT(shown(tree, 0.0), ElementsAre(TextureWeight{0, 0.5}, TextureWeight{1, 0.5}));
    EXPECT_THAT(shown(tree, 0.45), ElementsAre(TextureWeight{0, third}, TextureWeight{1, third}, TextureWeight{2, third}));
    EXPECT_THAT(shown(tree, 0.7), ElementsAre(TextureWeight{2, 1.0})) << "right of the left sphere";
}

/// On its own surface the point is inside, whatever rounding says.
TEST(CutTextures, ASetIsCutByItsOwnPart) {
    const Sphere ball{{0, 0, 1.03}, 1.1};
    const Stated inner = set_of(Kind::all, {cut(ball), part(right, 1)});
    const Stated tree = set_of(Kind::all, {part(left, 0), set_of(Kind::any, {inner, part(Sphere{{9, 0, 0}, 1.0}, 2)})});
    for (double x = -0.4; x < 0.45; x += 0.01) EXPECT_THAT(shown(tree, x), ElementsAre(TextureWeight{0, 0.5}, TextureWeight{1, 0.5})) << x;
}

TEST(CutTextures, TheOutermostIntersectionIsAskedAndNoUnionAround) {
    const Stated inner = set_of(Kind::all, {cut(behind), part(right, 1)});
    const Stated outer = set_of(Kind::all, {set_of(Kind::any, {inner, part(Sphere{{-9, 0, 0}, 1.0}, 2)}), part(left, 0)});
    EXPECT_THAT(shown(set_of(Kind::merged, {outer, part(Sphere{{0, 0, 2}, 1.9}, 2)}), 0.0),
                ElementsAre(TextureWeight{1, 0.5}, TextureWeight{0, 0.5}));
}

TEST(CutTextures, WhatIsClippedAwayShows) {
    const Stated clipped = set_of(Kind::all, {part(left, 0), part(Plane{{1, 0, 0}, -1.0}, TextureWeight::of_object)}, true);
    EXPECT_THAT(shown(set_of(Kind::all, {set_of(Kind::any, {clipped, part(right, 1)}), cut(behind)}), 0.0),
                ElementsAre(TextureWeight{0, 0.5}, TextureWeight{1, 0.5}));
}

/// A blob that cuts has no textures of its own to show.
TEST(CutTextures, AnyShapeMayCut) {
    BlobData data;
    data.components.emplace_back();
    data.components.front().strength = 4.0;
    data.components.front().box = {Vec3(-1), Vec3(1)};
    const Stated tree = set_of(Kind::all, {part(left, 0), part(right, 1), cut(FurtherShape(Blob{data}))});
    EXPECT_THAT(shown(tree, 0.0), ElementsAre(TextureWeight{0, 0.5}, TextureWeight{1, 0.5}));
}

}  // namespace
}  // namespace rt::cut_textures_test
