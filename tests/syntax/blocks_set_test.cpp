// Sets of objects: what their parts are, what the whole gives them, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

#include "tests/scene/checkers.h"
#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_set_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = SetNode::Kind;

Scene scene_of(const std::string& text) {
    ParsedScene parsed = parse_block(text);
    EXPECT_EQ(parsed.error, "") << text;
    EXPECT_THAT(parsed.messages, IsEmpty()) << text;
    return std::move(parsed.scene);
}

std::vector<Kind> kinds(const ObjectSet& set) {
    std::vector<Kind> kinds;
    for (const SetNode& node : set.nodes) kinds.push_back(node.kind);
    return kinds;
}

std::vector<std::uint32_t> sizes(const ObjectSet& set) {
    std::vector<std::uint32_t> sizes;
    for (const SetNode& node : set.nodes) sizes.push_back(node.size);
    return sizes;
}

Rgb rgb_of(const Scene& scene, std::size_t object) { return color_of(scene.objects.at(object)).rgb; }

TEST(Sets, UnionsAreTheirParts) {
    const Scene scene = scene_of("union { sphere { 0, 1 } union { box { 0, 1 } torus { 1, 0.2 } } plane { y, 0 } translate x }");
    ASSERT_EQ(scene.objects.size(), 4u);
    EXPECT_THAT(scene.sets, IsEmpty());
    for (const Object& object : scene.objects) EXPECT_EQ(object.transform->offset, Vec3(1, 0, 0));
}

TEST(Sets, PartsOfTheSameKindAreOneSet) {
    const Scene scene =
        scene_of("sphere { 0, 3 } difference { difference { sphere { 0, 1 } box { 0, 1 } } union { torus { 1, 0.2 } plane { y, 0 } } }");
    ASSERT_EQ(scene.sets.size(), 1u);
    const ObjectSet& set = scene.sets.front();
    EXPECT_EQ(set.first_object, 1u);
    EXPECT_THAT(kinds(set), ElementsAre(Kind::all, Kind::surface, Kind::surface, Kind::surface, Kind::surface));
    EXPECT_THAT(sizes(set), ElementsAre(5, 1, 1, 1, 1));
    std::vector<bool> inverse;
    for (const Object& object : scene.objects) inverse.push_back(object.inverse);
    EXPECT_THAT(inverse, ElementsAre(false, false, true, true, true));
}

TEST(Sets, InverseTurnsIntersectionsIntoMergesAndBack) {
    const Scene scene = scene_of("intersection { sphere { 0, 3 } intersection { sphere { 0, 1 } box { 0, 1 inverse } inverse } }");
    EXPECT_THAT(kinds(scene.sets.at(0)), ElementsAre(Kind::all, Kind::surface, Kind::merged, Kind::surface, Kind::surface));
    EXPECT_THAT(sizes(scene.sets.at(0)), ElementsAre(5, 1, 3, 1, 1));
    EXPECT_TRUE(scene.objects.at(1).inverse);
    EXPECT_FALSE(scene.objects.at(2).inverse);
    EXPECT_THAT(kinds(scene_of("union { sphere { 0, 3 } box { 0, 1 } inverse }").sets.at(0)),
                ElementsAre(Kind::all, Kind::surface, Kind::surface));
}

TEST(Sets, InverseLeavesWhatClipsAsItIs) {
    const Scene scene = scene_of("difference { sphere { 0, 3 } box { 0, 1 } clipped_by { plane { y, 0 } } inverse }");
    ASSERT_EQ(scene.sets.size(), 1u);
    EXPECT_THAT(kinds(scene.sets[0]), ElementsAre(Kind::all, Kind::merged, Kind::surface, Kind::surface, Kind::solid));
    EXPECT_TRUE(scene.objects[0].inverse);
    EXPECT_FALSE(scene.objects[1].inverse);
    EXPECT_FALSE(scene.sets[0].solids[0].inverse);
    const Scene cut = scene_of("difference { sphere { 0, 3 } sphere { 0, 1 clipped_by { plane { y, 0 } } } }");
    EXPECT_TRUE(cut.objects[1].inverse);
    EXPECT_FALSE(cut.sets[0].solids[0].inverse);
}

TEST(Sets, WhatIsInUnionsIsASetOfItsOwn) {
    const Scene scene =
        scene_of("union { merge { sphere { 0, 1 } box { 0, 1 } } sphere { 0, 1 } sphere { 0, 1 clipped_by { box { 0, 1 } } } }");
    ASSERT_EQ(scene.sets.size(), 2u);
    EXPECT_THAT(kinds(scene.sets[0]), ElementsAre(Kind::merged, Kind::surface, Kind::surface));
    EXPECT_THAT(kinds(scene.sets[1]), ElementsAre(Kind::all, Kind::surface, Kind::solid));
    EXPECT_TRUE(scene.sets[1].nodes[0].clips);
    EXPECT_EQ(scene.sets[1].nodes[1].index, 3u);
    EXPECT_EQ(scene.sets[1].nodes[2].index, 0u);
    EXPECT_EQ(scene.sets[1].solids.size(), 1u);
}

TEST(Sets, TheTextureOfTheWholeIsForPartsWithoutOne) {
    const Scene scene = scene_of(
        "#declare U = union { sphere { 0, 1 } sphere { 0, 1 pigment { rgb 0.2 } } pigment { rgb 0.3 } }\n"
        "object { U } object { U pigment { rgb 0.4 } } difference { object { U } box { 0, 1 } pigment { rgb 0.5 } } union { sphere { 0, 1 "
        "} box { 0, 1 } }");
    EXPECT_EQ(rgb_of(scene, 0), Rgb(0.3));
    EXPECT_EQ(rgb_of(scene, 1), Rgb(0.2));
    EXPECT_EQ(rgb_of(scene, 2), Rgb(0.4));
    EXPECT_EQ(rgb_of(scene, 3), Rgb(0.2));
    EXPECT_EQ(rgb_of(scene, 4), Rgb(0.3));
    EXPECT_EQ(rgb_of(scene, 6), Rgb(0.5));
    EXPECT_EQ(rgb_of(scene, 7), Rgb(0.0));
}

TEST(Sets, TransformsMoveWhatStoodBeforeThem) {
    const Scene scene = scene_of(
        "union { sphere { 0, 1 pigment { checker rgb 0 rgb 1 } } sphere { 0, 1 } pigment { checker rgb 0 rgb 1 } translate x "
        "clipped_by { box { 0, 1 } } translate y clipped_by { sphere { 0, 1 } } }");
    for (int i : {0, 1}) EXPECT_EQ(scene.objects[i].transform->offset, Vec3(1, 1, 0));
    for (int i : {0, 1}) EXPECT_EQ(moved(layer(scene.objects[i]).pigment, Vec3(0.0)), Vec3(1, 1, 0));
    const std::vector<Solid>& solids = scene.sets.at(0).solids;
    EXPECT_EQ(solids.at(0).transform->offset, Vec3(0, 1, 0));
    EXPECT_FALSE(solids.at(1).transform);
    const Scene inside = scene_of("sphere { 0, 1 clipped_by { plane { y, 0 } box { 0, 1 } rotate 90*x } rotate 90*x }");
    for (const Solid& solid : inside.sets.at(0).solids) EXPECT_LT(length(solid.transform->point(Vec3(1, 2, 3)) - Vec3(1, -2, -3)), 1e-12);
    const Scene before = scene_of("union { sphere { 0, 1 } sphere { 0, 1 } translate x pigment { checker rgb 0 rgb 1 } }");
    EXPECT_EQ(moved(layer(before.objects[0]).pigment, Vec3(0.0)), Vec3(0, 0, 0));
}

TEST(Sets, OfUvMappingASurfaceTakesItsCoordinatesAlong) {
    const Scene scene = scene_of(
        "union { sphere { 0, 1 uv_mapping pigment { checker rgb 0 rgb 1 } } sphere { 0, 1 pigment { checker rgb 0 rgb 1 } } translate x }");
    EXPECT_EQ(moved(layer(scene.objects[0]).pigment, Vec3(0.0)), Vec3(0, 0, 0));
    EXPECT_EQ(moved(layer(scene.objects[1]).pigment, Vec3(0.0)), Vec3(1, 0, 0));
    EXPECT_EQ(parse_block("union { sphere { 0, 1 } box { 0, 1 } pigment { rgb 1 } uv_mapping }").error,
              "uv_mapping must be specified before texture.");
    const ParsedScene of_set = parse_block(
        "union { sphere { 0, 1 } sphere { 0, 1 pigment { checker rgb 0, rgb 1 } } uv_mapping pigment { checker rgb 0, rgb 1 } translate x "
        "}");
    for (const Object& part : of_set.scene.objects) EXPECT_TRUE(part.uv_mapping);
    EXPECT_EQ(moved(layer(of_set.scene.objects.at(0)).pigment, Vec3(0.0)), Vec3(0.0)) << "the whole's texture stays";
    EXPECT_EQ(moved(layer(of_set.scene.objects.at(1)).pigment, Vec3(0.0)), Vec3(1, 0, 0)) << "the part's moves";
}

TEST(Sets, PartsWithOneTextureShareItWhenTheyAreMoved) {
    const Scene scene = scene_of(
        "#declare T = texture { pigment { checker rgb 0 rgb 1 } } union { sphere { 0, 1 texture { T } } sphere { 0, 1 texture { T } } "
        "rotate 30*x }");
    EXPECT_EQ((*scene.objects[0].texture).identity(), (*scene.objects[1].texture).identity());
    EXPECT_NE(moved(layer(scene.objects[0]).pigment, Vec3(1.0)), Vec3(1.0));
}

TEST(Sets, TheInteriorOfTheWholeIsOneMedium) {
    const Scene scene = scene_of(
        "#declare U = union { sphere { 0, 1 } sphere { 0, 1 interior { ior 1.1 } } box { 0, 1 } interior { ior 1.5 } }\n"
        "object { U } object { U } union { object { U } object { U } } sphere { 0, 1 interior { ior 2 } }");
    std::vector<std::uint32_t> media;
    for (const Object& object : scene.objects) media.push_back(object.medium);
    EXPECT_THAT(media, ElementsAre(1, 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 0));
    EXPECT_EQ((**scene.objects[0].interior).ior, 1.5);
    EXPECT_EQ((**scene.objects[1].interior).ior, 1.1);
}

TEST(Sets, PartsWithoutAnInteriorHaveOneInCommon) {
    const Scene scene = scene_of(
        "difference { box { -1, 1 interior { ior 1.5 } } union { sphere { 0, 1 } sphere { x, 1 } } sphere { y, 1 } }\n"
        "union { sphere { 0, 1 } sphere { x, 1 } } sphere { 0, 1 }");
    std::vector<std::uint32_t> media;
    for (const Object& object : scene.objects) media.push_back(object.medium);
    EXPECT_THAT(media, ElementsAre(0, 2, 2, 2, 3, 3, 0));
}

TEST(Sets, FlagsOfPartsCountInUnionsOnly) {
    const std::string parts = "{ box { -1, 0 no_image no_shadow } sphere { 0, 1 } ";
    const auto flags = [&](const std::string& text) {
        const Object object = scene_of(text).objects.at(0);
        return std::pair(object.no_image, object.no_shadow);
    };
    EXPECT_EQ(flags("union " + parts + "}"), std::pair(true, true));
    EXPECT_EQ(flags("union " + parts + "split_union off }"), std::pair(false, false));
    EXPECT_EQ(flags("union " + parts + "clipped_by { box { -1, 1 } } }"), std::pair(false, false));
    EXPECT_EQ(flags("merge " + parts + "}"), std::pair(true, false));
    EXPECT_EQ(flags("difference " + parts + "}"), std::pair(false, false));
    EXPECT_EQ(flags("union { intersection " + parts + "no_image } sphere { 0, 1 } no_shadow }"), std::pair(true, true));
}

TEST(Sets, LightsMoveAndShineInTheScene) {
    const Scene scene = scene_of("union { sphere { 0, 1 } light_source { <1, 2, 3> rgb 1 } translate <1, 0, 0> }");
    EXPECT_EQ(scene.lights.at(0).location, Vec3(2, 2, 3));
    EXPECT_EQ(scene.objects.size(), 1u);
}

TEST(Sets, CutawayTextures) {
    const Scene scene = scene_of(
        "difference { box { -1, 1 pigment { rgb 0.2 } } sphere { 0, 1 } sphere { x, 1 pigment { rgb 0.3 } } cutaway_textures }"
        "difference { box { -1, 1 pigment { rgb 0.2 } } sphere { 0, 1 } cutaway_textures pigment { rgb 0.4 } }");
    EXPECT_EQ(rgb_of(scene, 1), Rgb(0.2));
    EXPECT_EQ(rgb_of(scene, 2), Rgb(0.3));
    EXPECT_EQ(rgb_of(scene, 4), Rgb(0.4));
    for (const Object& object : scene.objects) EXPECT_FALSE(object.shape_textures) << "nothing to ask at each point";
}

TEST(Sets, BoundsStandAroundTheWhole) {
    const ObjectSet bounded = scene_of("difference { sphere { 0, 1 } box { 0, 1 } bounded_by { sphere { 0, 1 } } }").sets.at(0);
    EXPECT_EQ(kinds(bounded), (std::vector<Kind>{Kind::bounded, Kind::all, Kind::surface, Kind::surface, Kind::solid}));
    EXPECT_EQ(kinds(parse_block("sphere { 0, 1 bounded_by { box { -1, 1 } } }").scene.sets.at(0)),
              (std::vector<Kind>{Kind::bounded, Kind::surface, Kind::solid}));
    EXPECT_EQ(kinds(parse_block("union { sphere { 0, 1 } box { 0, 1 } bounded_by { box { -1, 1 } } }").scene.sets.at(0)),
              (std::vector<Kind>{Kind::bounded, Kind::any, Kind::surface, Kind::surface, Kind::solid}));
    // An inverted object is bounded by the same; what a clip has named says nothing more.
    const Scene inverted = parse_block("sphere { 0, 1 bounded_by { box { -1, 1 } } inverse }").scene;
    EXPECT_TRUE(inverted.objects.at(0).inverse);
    EXPECT_TRUE(inverted.sets.at(0).nodes.at(0).inverse);
    EXPECT_FALSE(inverted.sets.at(0).solids.at(0).inverse);
    EXPECT_EQ(parse_block("sphere { 0, 1 bounded_by { box { -1, 1 } } clipped_by { bounded_by } }").scene.sets.at(0).solids.size(), 1u);
    EXPECT_THAT(scene_of("sphere { 0, 1 clipped_by { bounded_by } }").sets, IsEmpty());
}

TEST(Sets, WarningsAboutBounds) {
    EXPECT_THAT(parse_block("sphere { 0, 1 bounded_by { box { -1, 1 } } }").messages,
                ElementsAre(HasSubstr("Parse Warning: Unnecessary bounding object removed.")));
    EXPECT_THAT(parse_block("union { sphere { 0, 1 } box { 0, 1 } bounded_by { box { -1, 1 } } }").messages,
                ElementsAre(HasSubstr("Parse Warning: CSG union unnecessarily bounded.")));
    // What has no box needs its bounds.
    for (const char* shape : {"quadric { <1,1,-1>, 0, 0, -1", "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1>"})
        EXPECT_THAT(parse_block(std::string(shape) + " bounded_by { box { -1, 1 } } }").messages, IsEmpty()) << shape;
    EXPECT_EQ(parse_block("quadric { <1,0,1>, 0, 0, -1 bounded_by { box { -1, 1 } } }").messages.size(), 1u);
}

TEST(Sets, ThatLackPartsAreNothingOrLess) {
    ParseOptions lenient;
    lenient.lenient = true;
    EXPECT_THAT(parse_block("difference { julia_fractal { 0 } sphere { 0, 1 } box { 0, 1 } }", lenient).scene.objects, IsEmpty());
    EXPECT_EQ(parse_block("difference { sphere { 0, 1 } julia_fractal { 0 } box { 0, 1 } }", lenient).scene.objects.size(), 2u);
    EXPECT_THAT(parse_block("union { }").messages, ElementsAre(HasSubstr("Parse Warning: Should have at least 2 objects in csg.")));
    EXPECT_EQ(parse_block("difference { sphere { 0, 1 } }").messages.size(), 1u);
}

TEST(Sets, RefusalsAndWarningsAreThoseOfPovRay) {
    const auto error = [](const std::string& text) { return parse_block(text).error; };
    EXPECT_EQ(error("union { sphere { 0, 1 } scale 2 sphere { 1, 1 } }"), "No matching } in 'union', sphere found instead");
    EXPECT_EQ(error("#declare S = sphere { 0, 1 } union { S sphere { 1, 1 } }"), "No matching } in 'union', sphere found instead");
    EXPECT_EQ(error("union { sphere { 0, 1 }, sphere { 1, 1 } }"), "No matching } in 'union', , found instead");
    EXPECT_EQ(error("merge { sphere { 0, 1 } sphere { 1, 1 } cutaway_textures }"),
              "cutaway_textures can only be used with intersection and difference.");
    EXPECT_EQ(error("difference { sphere { 0, 1 } sphere { 1, 1 } split_union off }"), "split_union found in non-union object.");
    EXPECT_EQ(error("union { sphere { 0, 1 } sphere { 1, 1 } sturm }"), "Keyword 'sturm' cannot be used with this object.");
    EXPECT_EQ(error("sphere { 0, 1 clipped_by { } }"), "Expected 'object', } found instead");
    EXPECT_EQ(error("sphere { 0, 1 clipped_by { box { 0, 1 }, box { 0, 1 } } }"), "No matching } in 'clipped_by', , found instead");
    const std::string bounded = "sphere { 0, 1 bounded_by { box { -1, 1 } } ", clipped = "sphere { 0, 1 clipped_by { box { -1, 1 } } ";
    EXPECT_EQ(error(bounded + "clipped_by { bounded_by } clipped_by { plane { y, 0 } } }"),
              "Cannot add clips after linking bounds and clips.");
    EXPECT_EQ(error("#declare S = " + clipped + "bounded_by { clipped_by } } object { S bounded_by { plane { y, 0 } } }"),
              "Cannot add bounds after linking bounds and clips.");
    EXPECT_EQ(error(bounded + "clipped_by { plane { y, 0 } } clipped_by { bounded_by } }"), "Cannot link bounds with previous clips.");
    EXPECT_EQ(error(clipped + "bounded_by { plane { y, 0 } } bounded_by { clipped_by } }"), "Cannot link clips with previous bounds.");
    EXPECT_EQ(error("sphere { 0, 1 clipped_by { bounded_by } clipped_by { plane { y, 0 } } }"), "");
    for (const char* body : {"box { 0, 1 pigment { rgb 1 } }", "triangle { 0, x, y }", "union { box { 0, 1 } light_source { 0 rgb 1 } }"}) {
        EXPECT_EQ(error(std::string("sphere { 0, 1 clipped_by { ") + body + " } }"),
                  "Illegal texture or patch in clip, bound or object pattern.");
        EXPECT_EQ(error(std::string("sphere { 0, 1 bounded_by { ") + body + " } }"),
                  "Illegal texture or patch in clip, bound or object pattern.");
    }
    EXPECT_THAT(parse_block("intersection { sphere { 0, 1 } triangle { 0, x, y } }").messages,
                ElementsAre(HasSubstr("Parse Warning: Patch objects not allowed in intersection.")));
    EXPECT_THAT(parse_block("merge { sphere { 0, 1 } triangle { 0, x, y } }").messages, IsEmpty());
}

/// Random sets as text, and what they contain as set theory has it.
class RandomSet {
public:
    explicit RandomSet(unsigned seed) : random_(seed) { root_ = make(3); }
    const std::string& text() const { return nodes_[root_].text; }
    bool contains(const Vec3& p) const { return contains(root_, p); }

private:
    enum class Join { shape, all, any, difference };
    struct Node {
        Join join = Join::shape;
        bool inverse = false;
        Vec3 center{0.0};
        std::vector<std::size_t> parts;
        std::optional<std::size_t> clip;
        std::string text;
    };

    int whole(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    std::size_t make(int depth) {
        Node node;
        if (depth < 3 && (depth == 0 || whole(3) == 0)) {
            node.center = {0.5 * whole(5) - 1.0, 0.5 * whole(5) - 1.0, 0.5 * whole(5) - 1.0};
            node.text = fmt::format("sphere {{ <{}, {}, {}>, 1", node.center.x, node.center.y, node.center.z);
        } else {
            const int kind = whole(4);
            node.join = kind == 0 ? Join::all : kind == 3 ? Join::difference : Join::any;
            node.text = std::array{"intersection {", "union {", "merge {", "difference {"}[static_cast<std::size_t>(kind)];
            for (int i = 0; i < 2 + whole(2); ++i) {
                node.parts.push_back(make(depth - 1));
                node.text += " " + nodes_[node.parts.back()].text;
            }
        }
        if (depth > 0 && whole(4) == 0) {
            node.clip = make(0);
            node.text += " clipped_by { " + nodes_[*node.clip].text + " }";
        }
        node.inverse = whole(3) == 0;
        node.text += node.inverse ? " inverse }" : " }";
        nodes_.push_back(std::move(node));
        return nodes_.size() - 1;
    }
    /// `turned` inside out, down to the shapes: whatever is clipped is turned, what it is clipped by is not.
    bool contains(std::size_t at, const Vec3& p, bool turned = false) const {
        const Node& node = nodes_[at];
        if (node.clip && !contains(*node.clip, p)) return false;
        turned ^= node.inverse;
        if (node.join == Join::shape) return (length(p - node.center) < 1.0) != turned;
        const auto holds = [&](std::size_t part) {
            return contains(part, p, turned != (node.join == Join::difference && part != node.parts[0]));
        };
        return (node.join == Join::any) != turned ? std::ranges::any_of(node.parts, holds) : std::ranges::all_of(node.parts, holds);
    }

    std::mt19937 random_;
    std::vector<Node> nodes_;
    std::size_t root_ = 0;
};

bool contains(const Scene& scene, const ObjectSet& set, std::size_t at, const Vec3& p) {
    const SetNode& node = set.nodes[at];
    const auto in_sphere = [&](const Shape& shape) { return length(p - std::get<Sphere>(shape).center) < 1.0; };
    if (node.kind == Kind::surface) {
        const Object& object = scene.objects[set.first_object + node.index];
        return in_sphere(object.shape) != object.inverse;
    }
    if (node.kind == Kind::solid) return in_sphere(set.solids[node.index].shape) != set.solids[node.index].inverse;
    const bool any = node.kind != Kind::all;
    for (std::size_t i = at + 1; i < at + node.size; i += set.nodes[i].size)
        if (contains(scene, set, i, p) == any) return any;
    return !any;
}

/// Complements of intersections, of differences, of what is clipped, in each other.
TEST(Sets, ContainWhatSetTheorySays) {
    std::size_t inside = 0, outside = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const RandomSet stated(seed);
        // In a set, so that a union is one tree as well.
        const Scene scene = scene_of("intersection { " + stated.text() + " sphere { 0, 1 } }");
        ASSERT_EQ(scene.sets.size(), 1u);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
        for (int i = 0; i < 50; ++i) {
            const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
            const bool expected = length(p) < 1.0 && stated.contains(p);
            ASSERT_EQ(contains(scene, scene.sets[0], 0, p), expected) << stated.text();
            ++(expected ? inside : outside);
        }
    }
    EXPECT_GT(inside, 5000u);
    EXPECT_GT(outside, 5000u);
}

TEST(Sets, AreLimited) {
    std::string doubling = "#declare U = union { sphere { 0, 1 } sphere { x, 1 } }\n";
    for (int i = 0; i < 20; ++i) doubling += "#declare U = union { object { U } object { U translate x } }\n";
    ParseOptions options;
    options.max_set_parts = 1000;
    try {
        parse_block(doubling, options);
        ADD_FAILURE() << "no limit";
    } catch (const LimitError& e) {
        EXPECT_EQ(
            first_line(e.what()),
            "File 'test.pov' line 9: Parse Error: The sets of objects have more than 1000 parts in all. --limit parts=N allows more.");
    }
    std::string deep = "#declare D = sphere { 0, 1 }\n";
    for (int i = 0; i < 600; ++i) deep += "#declare D = merge { intersection { object { D } sphere { 0, 1 } } sphere { 0, 1 } }\n";
    try {
        parse_block(deep);
        ADD_FAILURE() << "no limit";
    } catch (const LimitError& e) {
        EXPECT_THAT(e.what(), HasSubstr("Parse Error: Sets of objects are nested more than 1000 deep."));
    }
}

}  // namespace
}  // namespace rt::blocks_set_test
