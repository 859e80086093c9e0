// Textures that double with each line: the limit is met before the memory is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

#include "tests/syntax/read_scene.h"

namespace rt::texture_limit_test {
namespace {

/// `first`, then `count` declarations; `next` has {0} for the name before and {1} for the new one.
std::string doubling(std::string text, const std::string& next, int count) {
    for (int i = 0; i < count; ++i) text += fmt::format(fmt::runtime(next), fmt::format("P{}", i), fmt::format("P{}", i + 1));
    return text;
}

const std::string pigments = "#declare {1} = pigment {{ checker pigment {{ {0} }} pigment {{ {0} }} }}\n";
const std::string textures = "#declare {1} = texture {{ checker texture {{ {0} }} texture {{ {0} }} }}\n";
const std::string layers = "#declare {1} = texture {{ {0} }} texture {{ {0} }}\n";
const std::string first_pigment = "#declare P0 = pigment { rgb 1 }\n";
const std::string first_texture = "#declare P0 = texture { pigment { rgb 1 } }\n";

void expect_limit(const std::string& scene, const std::string& message, std::size_t limit) {
    ParseOptions options;
    options.max_texture_nodes = limit;
    const Outcome outcome = read_scene(scene, options);
    EXPECT_TRUE(outcome.limit);
    EXPECT_EQ(outcome.error, message);
}

TEST(TextureLimit, CheckersOfPigments) {
    expect_limit(
        doubling(first_pigment, pigments, 40),
        "File 't.pov' line 7: Parse Error: A texture has more than 100 pigments in its layers and cells. --limit texture=N allows more.\n"
        "   7 | #declare P6 = pigment { checker pigment { P5 } pigment { P5 } }\n"
        "     |                         ^^^^^^^",
        100);
}

TEST(TextureLimit, CheckersOfTextures) {
    expect_limit(
        doubling(first_texture, textures, 40),
        "File 't.pov' line 8: Parse Error: A texture has more than 100 pigments in its layers and cells. --limit texture=N allows more.\n"
        "   8 | #declare P7 = texture { checker texture { P6 } texture { P6 } }\n"
        "     |                         ^^^^^^^",
        100);
}

TEST(TextureLimit, Layers) {
    expect_limit(
        doubling(first_texture, layers, 40),
        "File 't.pov' line 8: Parse Error: A texture has more than 100 pigments in its layers and cells. --limit texture=N allows more.\n"
        "   8 | #declare P7 = texture { P6 } texture { P6 }\n"
        "     |                                           ^",
        100);
}

TEST(TextureLimit, IsMetExactly) {
    ParseOptions options;
    // A pigment after n declarations has 2^(n+1) - 1 nodes, textures and layers have 2^n.
    options.max_texture_nodes = 31;
    EXPECT_EQ(read_scene(doubling(first_pigment, pigments, 4), options).error, "");
    options.max_texture_nodes = 30;
    EXPECT_TRUE(read_scene(doubling(first_pigment, pigments, 4), options).limit);
    for (const std::string& next : {textures, layers}) {
        options.max_texture_nodes = 16;
        EXPECT_EQ(read_scene(doubling(first_texture, next, 4), options).error, "");
        options.max_texture_nodes = 15;
        EXPECT_TRUE(read_scene(doubling(first_texture, next, 4), options).limit);
    }
}

TEST(TextureLimit, TheDefaultIsTenThousand) {
    EXPECT_EQ(read_scene(doubling(first_texture, layers, 13)).error, "");
    EXPECT_TRUE(read_scene(doubling(first_texture, layers, 14)).limit);
}

TEST(TextureLimit, LayersThatGrowAfterTheyWereCountedAreCountedAgain) {
    ParseOptions options;
    options.max_texture_nodes = 6;
    const std::string text = "#declare C = pigment { checker rgb 1 rgb 0 } sphere { 0, 1 texture { } texture { } pigment { C } texture { }";
    EXPECT_EQ(error_text(text + " texture { } }", options), "");  // 1 + 3 + 1 + 1
    EXPECT_EQ(error_text(text + " texture { } texture { } }", options),
              "A texture has more than 6 pigments in its layers and cells. --limit texture=N allows more.");
}

const std::string pigment_chain = "#declare {1} = pigment {{ checker pigment {{ {0} }} pigment {{ rgb 1 }} }}\n";
const std::string texture_chain = "#declare {1} = texture {{ checker texture {{ {0} }} texture {{ }} }}\n";

TEST(TextureLimit, PatternsInsidePatterns) {
    for (const auto& [first, chain, name] :
         {std::tuple(first_pigment, pigment_chain, "pigment"), {first_texture, texture_chain, "texture"}}) {
        EXPECT_EQ(read_scene(doubling(first, chain, 100)).error, "");
        EXPECT_EQ(error_text(doubling(first, chain, 20'000)),
                  "The patterns of a texture are nested more than 100 deep. --limit texture-depth=N allows more.");
        EXPECT_TRUE(error_text(doubling(first, chain, 100) + fmt::format("sphere {{ 0, 1 {} {{ P100 }} }}", name)).empty());
    }
    // Pigments inside the cells of textures count as well.
    const std::string mixed =
        doubling(first_pigment, pigment_chain, 100) + "sphere { 0, 1 texture { checker texture { pigment { P100 } } } }";
    EXPECT_EQ(error_text(mixed), "The patterns of a texture are nested more than 100 deep. --limit texture-depth=N allows more.");
}

const std::string too_much =
    "The textures of the scene have more than 10 pigments beyond the first of each. --limit textures=N allows more.";

TEST(TextureLimit, ObjectsCountTogether) {
    ParseOptions options;
    options.max_scene_nodes = 10;
    const std::string tree = "#declare P = pigment { checker rgb 1 rgb 0 }\n";  // a pattern and two colours: 2 beyond the first
    const auto objects = [&](const std::string& modifiers, int count) {
        std::string text = tree + "#declare T = texture { pigment { P } }\n";
        for (int i = 0; i < count; ++i) text += "sphere { 0, 1 " + modifiers + " }\n";
        return text;
    };
    EXPECT_EQ(error_text(objects("pigment { P }", 5), options), "");
    EXPECT_EQ(error_text(objects("pigment { P }", 6), options), too_much);
    EXPECT_EQ(error_text(objects("texture { T }", 1000), options), "");  // all share one
    EXPECT_EQ(error_text(objects("pigment { rgb 1 }", 1000), options), "");
}

TEST(TextureLimit, NamesCountTogether) {
    ParseOptions options;
    options.max_scene_nodes = 10;
    std::string text = "#declare A = texture { } texture { } texture { }\n";  // two layers beyond the first
    for (int i = 0; i < 5; ++i) text += fmt::format("#declare B{} = texture {{ A rotate x }}\n", i);
    EXPECT_EQ(error_text(text, options), too_much);
}

TEST(TextureLimit, ManyLayersAreRefusedAtOnce) {
    std::string text = "#declare A =";
    for (int i = 0; i < 100'001; ++i) text += " texture { }";
    EXPECT_EQ(error_text(text), "A texture has more than 10000 pigments in its layers and cells. --limit texture=N allows more.");
}

}  // namespace
}  // namespace rt::texture_limit_test
