// Textures that double with each line: the limit is met before the memory is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/syntax/read_scene.h"

namespace rt {
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
    expect_limit(doubling(first_pigment, pigments, 40),
                 "File 't.pov' line 7: Parse Error: A texture has more than 100 pigments in its layers and cells.\n"
                 "   7 | #declare P6 = pigment { checker pigment { P5 } pigment { P5 } }\n"
                 "     |                         ^^^^^^^",
                 100);
}

TEST(TextureLimit, CheckersOfTextures) {
    expect_limit(doubling(first_texture, textures, 40),
                 "File 't.pov' line 8: Parse Error: A texture has more than 100 pigments in its layers and cells.\n"
                 "   8 | #declare P7 = texture { checker texture { P6 } texture { P6 } }\n"
                 "     |                         ^^^^^^^",
                 100);
}

TEST(TextureLimit, Layers) {
    expect_limit(doubling(first_texture, layers, 40),
                 "File 't.pov' line 8: Parse Error: A texture has more than 100 pigments in its layers and cells.\n"
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

TEST(TextureLimit, TheDefaultIsAHundredThousand) {
    EXPECT_EQ(read_scene(doubling(first_texture, layers, 16)).error, "");
    EXPECT_TRUE(read_scene(doubling(first_texture, layers, 17)).limit);
}

}  // namespace
}  // namespace rt
