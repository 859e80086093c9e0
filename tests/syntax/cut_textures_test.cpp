// Which parts of sets with cutaway_textures show what they cut, and which textures show there. Every case is one that POV-Ray rendered.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/syntax/blocks_scene.h"

namespace rt::cut_textures_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t none = TextureWeight::of_object;

/// In `text` R, G and B are spheres of one colour each, P one without a texture, D the default texture's colour.
Scene scene_of(const std::string& text) {
    const std::string names =
        "#default { pigment { rgb 0.25 } } #declare R = sphere { 0, 2 pigment { rgb x } } #declare G = sphere { 0, 2 pigment { rgb y } } "
        "#declare B = sphere { 0, 2 pigment { rgb z } } #declare P = sphere { x, 2 } ";
    ParsedScene parsed = parse_block(names + text);
    EXPECT_EQ(parsed.error, "") << text;
    return std::move(parsed.scene);
}

std::string letter(const TextureLayers& layers) {
    const Rgb rgb = std::get<PigmentColor>(std::get<PlainTexture>(layers->front().content).pigment.content).rgb;
    return rgb == Rgb(1, 0, 0) ? "R" : rgb == Rgb(0, 1, 0) ? "G" : rgb == Rgb(0, 0, 1) ? "B" : rgb == Rgb(0.25) ? "D" : "?";
}

const SetNode* node_of(const Scene& scene, std::uint32_t object) {
    for (const ObjectSet& set : scene.sets)
        for (const SetNode& node : set.nodes)
            if (node.kind == SetNode::Kind::surface && set.first_object + node.index == object) return &node;
    return nullptr;
}

/// What each object shows: a letter, or in brackets those of what it cuts.
std::vector<std::string> shown(const std::string& text) {
    const Scene scene = scene_of(text);
    std::vector<std::string> all;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const SetNode* const node = node_of(scene, i);
        const bool cuts = node && node->cuts;
        EXPECT_EQ(cuts, object.shape_textures.has_value()) << text;
        std::string textures = letter(*object.texture);
        if (cuts) {
            textures = "[";
            for (const TextureLayers& layers : **object.shape_textures) textures += letter(layers);
            textures += "]";
        }
        all.push_back(textures);
    }
    return all;
}

TEST(CutTextures, PartsWithoutOneShowThoseOfAllOthers) {
    EXPECT_THAT(shown("difference { union { object { R } object { G } } object { P } cutaway_textures }"), ElementsAre("R", "G", "[RG]"));
    EXPECT_THAT(shown("intersection { object { P } object { R } object { G } object { B } object { P } cutaway_textures }"),
                ElementsAre("[RGB]", "R", "G", "B", "[RGB]"));
    EXPECT_THAT(shown("difference { merge { object { R } object { R } } object { P } cutaway_textures }"), ElementsAre("R", "R", "R"));
    EXPECT_THAT(shown("difference { union { object { R } object { G } } object { P } cutaway_textures texture { pigment { rgb z } } }"),
                ElementsAre("R", "G", "B"));
    EXPECT_THAT(shown("intersection { object { P } object { P } cutaway_textures }"), ElementsAre("D", "D"));
}

TEST(CutTextures, WhatIsTakenAwayDoesNotShow) {
    EXPECT_THAT(shown("difference { object { R } object { G } object { P } cutaway_textures }"), ElementsAre("R", "G", "R"));
    EXPECT_THAT(shown("difference { object { R } object { P } object { G inverse } cutaway_textures }"), ElementsAre("R", "R", "G"));
    EXPECT_THAT(shown("difference { object { R } union { object { G } object { B } } object { P } cutaway_textures }"),
                ElementsAre("R", "G", "B", "R"));
    EXPECT_THAT(shown("intersection { difference { object { R } object { G } } object { B } object { P } cutaway_textures }"),
                ElementsAre("R", "G", "B", "[RB]"));
    EXPECT_THAT(shown("intersection { object { R } object { G inverse } object { P } cutaway_textures }"), ElementsAre("R", "G", "[RG]"))
        << "inverse alone takes nothing away";
    EXPECT_THAT(shown("difference { object { P } object { P } object { G } cutaway_textures }"), ElementsAre("[]", "[]", "G")) << "black";
}

TEST(CutTextures, PartsOfUnionsHaveTheTextureOfEverythingElse) {
    EXPECT_THAT(shown("intersection { object { R } union { object { P } object { P } } cutaway_textures }"), ElementsAre("R", "D", "D"));
    EXPECT_THAT(shown("difference { object { R } intersection { object { P } object { P } } cutaway_textures }"),
                ElementsAre("R", "D", "D"));
    EXPECT_THAT(shown("difference { object { R } union { object { P } object { P } } cutaway_textures }"), ElementsAre("R", "R", "R"))
        << "all but the points of a union are an intersection";
    EXPECT_THAT(shown("difference { union { object { R } object { P } } object { P } cutaway_textures }"), ElementsAre("R", "D", "[RD]"));
    EXPECT_THAT(shown("difference { object { R } intersection { object { G } union { object { P } object { P } } cutaway_textures } }"),
                ElementsAre("R", "G", "D", "D"));
    EXPECT_THAT(shown("difference { object { R } intersection { object { G } union { object { P } object { B } } cutaway_textures } }"),
                ElementsAre("R", "G", "D", "B"))
        << "all but the points of an intersection are a union, which cuts nothing";
}

TEST(CutTextures, SetsInSetsAreCutAsWell) {
    EXPECT_THAT(shown("intersection { object { R } union { intersection { object { P } object { G } } object { B } } cutaway_textures }"),
                ElementsAre("R", "[RGB]", "G", "B"));
    EXPECT_THAT(shown("intersection { object { R } intersection { object { P } object { G } cutaway_textures } }"),
                ElementsAre("R", "[RG]", "G"))
        << "from the outermost intersection on";
    EXPECT_THAT(shown("union { object { B } intersection { object { P } object { R } object { G } cutaway_textures } }"),
                ElementsAre("B", "[RG]", "R", "G"));
    EXPECT_THAT(shown("intersection { object { P } object { R } intersection { object { P } object { G } cutaway_textures } }"),
                ElementsAre("D", "R", "[DRG]", "G"));
    EXPECT_THAT(shown("intersection { object { R } union { intersection { object { P } object { P } } object { G } } cutaway_textures }"),
                ElementsAre("R", "D", "D", "G"))
        << "a set without any texture has one as a whole";
    EXPECT_THAT(shown("intersection { object { R } object { G } object { P clipped_by { box { -1, 1 } } } cutaway_textures "
                      "bounded_by { box { -9, 9 } } }"),
                ElementsAre("R", "G", "[RG]"));
}

/// Its own texture is what a part shows whose parts state some, and others show of it.
TEST(CutTextures, ABlobOfTexturesIsNoPartWithoutOne) {
    const std::string blob = "blob { sphere { 0, 1, 2 } sphere { 0, 1, 2 pigment { rgb z } } } ";
    const Scene scene = scene_of("intersection { " + blob + "object { P } object { R } cutaway_textures }");
    EXPECT_EQ(letter(*scene.objects.at(0).texture), "D");
    ASSERT_TRUE(scene.objects.at(1).shape_textures);
    std::string cut;
    for (const TextureLayers& layers : **scene.objects.at(1).shape_textures) cut += letter(layers);
    EXPECT_EQ(cut, "DR");
}

TEST(CutTextures, EachTextureHasANumberInItsWhole) {
    const Scene scene = scene_of(
        "union { difference { union { object { R } object { G } object { R } } object { P } cutaway_textures } "
        "difference { union { object { G } object { B } } object { P } object { P } cutaway_textures } }");
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) numbers.push_back(node_of(scene, i)->texture);
    EXPECT_THAT(numbers, ElementsAre(0, 1, 0, none, 0, 1, none, none));
    EXPECT_EQ(scene.objects.at(6).shape_textures->identity(), scene.objects.at(7).shape_textures->identity());
}

}  // namespace
}  // namespace rt::cut_textures_test
