// What is known but not modelled: refused by name, or listed, or left out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_unmodelled_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The features that `requires` would list, in the order in which they are met.
std::vector<std::string> features(const std::string& text) {
    ParseOptions options;
    options.collect_unmodelled = true;
    const ParsedScene p = parse_block(text, options);
    EXPECT_EQ(p.error, "") << text;
    std::vector<std::string> names;
    for (const Unmodelled& u : p.scene.unmodelled) names.push_back(u.feature);
    return names;
}

TEST(Unmodelled, IsAnErrorWithItsPlace) {
    EXPECT_EQ(parse_block("ovus { 1, 0.5 }").error, "'ovus' is not modelled.");
    EXPECT_EQ(parse_block("sphere { 0, 1 pigment { tiling 2 } }").error, "'tiling' is not modelled.");
}

TEST(Unmodelled, OnePassListsEverything) {
    EXPECT_THAT(features("media { density { spherical } } sphere { 0, 1 pigment { tiling 2 } texture { material_map { png \"a\" } } } "
                         "union { sphere { 0, 1 } ovus { 1, 0.5 } } sphere { 0, 1 normal { pavement } }"),
                ElementsAre("media", "density", "tiling", "material_map", "ovus", "pavement"));
}

TEST(Unmodelled, SkippingStopsAtTheRightBrace) {
    ParseOptions options;
    options.collect_unmodelled = true;
    EXPECT_EQ(parse_block("sphere { 0, 1 pigment { wood color_map { [0 rgb 1] } scale 2 } finish { phong 1 foo } }", options).error,
              "No matching } in 'finish', undeclared identifier 'foo' found instead");
}

TEST(Unmodelled, TheRestOfTheSceneIsRead) {
    ParseOptions lenient;
    lenient.lenient = true;
    const ParsedScene p = parse_block(
        "ovus { 1, 0.5 pigment { rgb 1 } }\n#declare N = normal { bumps 1 }\n#declare Sky = sky_sphere { "
        "pigment { "
        "rgb 1 } }\nsky_sphere { Sky }\nsphere { 0, 2 texture { pigment { granite scale 2 } normal { N } finish { phong 1 } } scale 3 }",
        lenient);
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.objects.size(), 1u);
    EXPECT_EQ(layer(p.scene.objects[0]).finish.phong, 1.0);
    EXPECT_TRUE(p.scene.objects[0].transform);
    EXPECT_THAT(p.messages, testing::Contains(HasSubstr("'ovus' is not modelled and is ignored.")));
}

TEST(Unmodelled, APatternIsShownInGrey) {
    ParseOptions lenient;
    lenient.lenient = true;
    const ParsedScene p = parse_block("sphere { 0, 1 pigment { pavement color_map { [0 rgb 1] [1 rgb 0] } } }", lenient);
    EXPECT_EQ(color_of(p.scene.objects.at(0)).rgb, Rgb(0.5));
}

TEST(Unmodelled, Cameras) {
    EXPECT_THAT(features("camera { omnimax angle 180 aperture 1 blur_samples 4 }"), ElementsAre("omnimax camera", "aperture"));
}

TEST(Unmodelled, DeclaredButEmptyObjectsCanBePlaced) {
    EXPECT_THAT(features("#declare B = ovus { 1, 0.5 } object { B scale 2 pigment { rgb 1 } } B"), ElementsAre("ovus"));
}

TEST(Unmodelled, AnUnclosedBlockIsStillAnError) {
    ParseOptions options;
    options.collect_unmodelled = true;
    EXPECT_EQ(parse_block("ovus { 1, 0.5", options).error, "No matching } in 'ovus', End of File found instead");
}

TEST(Nesting, IsLimited) {
    std::string deep;
    for (int i = 0; i < 5000; ++i) deep += "object { ";
    EXPECT_THROW(parse_text({"t.pov", deep}, {}, [](std::string_view) {}), LimitError);
    std::string pigments = "sphere { 0, 1 ";
    for (int i = 0; i < 5000; ++i) pigments += "pigment { checker ";
    EXPECT_THROW(parse_text({"t.pov", pigments}, {}, [](std::string_view) {}), LimitError);
    std::string transforms = "sphere { 0, 1 ";
    for (int i = 0; i < 5000; ++i) transforms += "transform { ";
    EXPECT_THROW(parse_text({"t.pov", transforms}, {}, [](std::string_view) {}), LimitError);
}

}  // namespace
}  // namespace rt::blocks_unmodelled_test
