#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_color_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PigmentColor color(const std::string& text) { return color_of(sphere_with("pigment { " + text + " }")); }
PigmentColor make(double r, double g, double b, double f, double t) { return {Rgb(r, g, b), f, t}; }

TEST(Colour, VectorForms) {
    EXPECT_EQ(color("rgb <1,2,3>"), make(1, 2, 3, 0, 0));
    EXPECT_EQ(color("rgbf <1,2,3,4>"), make(1, 2, 3, 4, 0));
    EXPECT_EQ(color("rgbt <1,2,3,4>"), make(1, 2, 3, 0, 4));
    EXPECT_EQ(color("rgbft <1,2,3,4,5>"), make(1, 2, 3, 4, 5));
    EXPECT_EQ(color("rgbft <1,2,3,4>"), make(1, 2, 3, 4, 0));
    EXPECT_EQ(color("rgb <1,2>"), make(1, 2, 0, 0, 0));
    EXPECT_EQ(color("rgbf <1 2 3 4>"), make(1, 2, 3, 4, 0));
    EXPECT_EQ(color("rgb <1,2,3,4,5>"), make(1, 2, 3, 4, 5));
}

TEST(Colour, FloatsPromoteToTheChannelsOfTheForm) {
    EXPECT_EQ(color("rgb 2"), make(2, 2, 2, 0, 0));
    EXPECT_EQ(color("rgbf 2"), make(2, 2, 2, 2, 0));
    EXPECT_EQ(color("rgbt 2"), make(2, 2, 2, 0, 2));
    EXPECT_EQ(color("rgbft 2"), make(2, 2, 2, 2, 2));
    EXPECT_EQ(color("color 2"), make(2, 2, 2, 2, 2));
}

TEST(Colour, ComparisonsAndChoicesNeedNoParentheses) {
    EXPECT_EQ(color("rgb 1|0"), make(1, 1, 1, 0, 0));
    EXPECT_EQ(color("rgb <1,0,3>&<0,1,1>"), make(0, 0, 1, 0, 0));
    EXPECT_EQ(color("rgb .5<1<2"), make(1, 1, 1, 0, 0));
    EXPECT_EQ(color("rgb <1,2,3> < 2"), make(1, 0, 0, 0, 0));
    EXPECT_EQ(color("rgb <1,2,3> = <1,2,4>"), make(1, 1, 0, 0, 0));
    EXPECT_EQ(color("rgb 0 ? <2,3,4> : <5,6,7>"), make(5, 6, 7, 0, 0));
    EXPECT_EQ(color("rgb \"a\"=\"a\""), make(1, 1, 1, 0, 0));
    EXPECT_EQ(color("rgbft .5 > .2"), make(1, 1, 1, 1, 1));
    EXPECT_EQ(color("color 1|0"), make(1, 1, 1, 1, 1));
    for (const char* refused : {"sphere { 0, 1|0 }", "sphere { 0, 1 pigment { color red 1|0 } }", "sphere { 0, 1 scale 1|0 }",
                                "sphere { 0, 1 finish { diffuse 1|0 } }", "sphere { 0, 1 pigment { rgb 1 <1,0,0> } }", "#declare A=1|0;"})
        EXPECT_NE(parse_block(refused).error, "") << refused;
    for (const char* taken : {"background { 1|0 }", "light_source { 0, 1|0 }", "sphere { 0, 1 finish { ambient .5>.1 reflection 1|0 } }"})
        EXPECT_EQ(parse_block(taken).error, "") << taken;
}

TEST(Colour, TrailingChannelsOverwrite) {
    EXPECT_EQ(color("rgb <1,2,3> red 9 transmit 0.5 filter 0.25"), make(9, 2, 3, 0.25, 0.5));
    EXPECT_EQ(color("red 1 green 2"), make(1, 2, 0, 0, 0));
    EXPECT_EQ(color("colour blue 4"), make(0, 0, 4, 0, 0));
    EXPECT_EQ(color("rgb 1 transmit 0.5 * 0.5"), make(1, 1, 1, 0, 0.25));
}

TEST(Colour, ExpressionsAndIdentifiers) {
    EXPECT_EQ(color("rgb <1,2,3> * 2"), make(2, 4, 6, 0, 0));
    EXPECT_EQ(color("color <1,2,3>"), make(1, 2, 3, 0, 0));
    const ParsedScene p = parse_block("#declare W = rgb <1,2,4>; sphere { 0, 1 pigment { W * 0.5 filter 1 } }");
    EXPECT_EQ(color_of(p.scene.objects.at(0)), make(0.5, 1, 2, 1, 0));
    EXPECT_EQ(color("color"), make(0, 0, 0, 0, 0));
}

TEST(Colour, WarnsOfTooManyComponents) {
    EXPECT_THAT(parse_block("sphere { 0, 1 pigment { rgb <1,1,1,0> } }").messages,
                ElementsAre(HasSubstr("Suspicious expression after rgb.")));
    EXPECT_THAT(parse_block("sphere { 0, 1 pigment { rgbt <1,1,1,0,0> } }").messages,
                ElementsAre(HasSubstr("Suspicious expression after rgbt.")));
    EXPECT_THAT(parse_block("sphere { 0, 1 pigment { rgbft <1,1,1,0,0> } }").messages, IsEmpty());
}

TEST(Colour, BareVectorsAreNoPigment) {
    EXPECT_EQ(parse_block("sphere { 0, 1 pigment { <1,0,0> } }").error, "No matching } in 'pigment', < found instead");
}

double decoded(double v) { return v < 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

PigmentColor srgb_under(const std::string& gamma) {
    return parse_block("background { srgbft <0.5, 0.02, 1, 0.3, 0.6> }", {}, "global_settings { assumed_gamma " + gamma + " } ")
        .scene.background;
}

TEST(Colour, SrgbIsDecodedIntoTheWorkingSpace) {
    const PigmentColor linear = srgb_under("1");
    EXPECT_NEAR(linear.rgb.r, decoded(0.5), 1e-15);
    EXPECT_NEAR(linear.rgb.g, decoded(0.02), 1e-15);
    EXPECT_NEAR(linear.rgb.b, 1.0, 1e-15);
    EXPECT_EQ(linear.filter, 0.3);
    EXPECT_EQ(linear.transmit, 0.6);
    EXPECT_NEAR(srgb_under("2.2").rgb.r, std::pow(decoded(0.5), 1.0 / 2.2), 1e-15);
    EXPECT_EQ(srgb_under("srgb").rgb.r, 0.5);
    EXPECT_EQ(parse_block("background { srgb 1 }", {}, "#version 3.7; ").error,
              "Cannot parse sRGB colors before assumed_gamma has been set.");
}

TEST(Background, TakesAnyColourOrNone) {
    EXPECT_EQ(parse_block("background { rgbt <1,2,3,0.5> }").scene.background, make(1, 2, 3, 0, 0.5));
    EXPECT_EQ(parse_block("background { <1,2,3> }").scene.background, make(1, 2, 3, 0, 0));
    EXPECT_EQ(parse_block("background { rgb 1 } background { }").scene.background, make(0, 0, 0, 0, 0));
    EXPECT_EQ(parse_block("background { rgb 1 rgb 2 }").error, "No matching } in 'background', color keyword 'rgb' found instead");
}

}  // namespace
}  // namespace rt::blocks_color_test
