#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/checkers.h"
#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_texture_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* red_over_grey = "#declare T = texture { pigment { rgb 0.5 } } texture { pigment { rgbt <1,0,0,0.5> } } ";

Object only(const std::string& text) { return parse_block(text).scene.objects.at(0); }
bool is_checker(const Pigment& pigment) {
    return !std::holds_alternative<PigmentColor>(pigment.content) && pattern_of(pigment).pattern.pattern.kind == PatternKind::checker;
}
std::vector<PigmentColor> colors(const Object& object) { return std::get<Shared<ColorMap>>(pattern_of(layer(object).pigment).map)->colors; }

TEST(TextureBlock, TilesAreACheckerOfTile2AndTheFirst) {
    const Object o =
        only("sphere { 0, 1 texture { tiles { texture { pigment { rgb 0.25 } } tile2 texture { pigment { rgb 1 } } } scale 2 } }");
    const PatternTexture& tiles = *std::get<Shared<PatternTexture>>((*o.texture)->at(0).content);
    EXPECT_EQ(tiles.pattern.pattern.kind, PatternKind::checker);
    EXPECT_EQ(moved(tiles.pattern.pattern, Vec3(1.0)), Vec3(2.0));
    const auto rgb = [&](std::size_t i) {
        return std::get<PigmentColor>(std::get<PlainTexture>(tiles.map->textures.at(i)->at(0).content).pigment.content).rgb;
    };
    EXPECT_EQ(rgb(0), Rgb(1.0));
    EXPECT_EQ(rgb(1), Rgb(0.25));
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { tiles { texture { pigment { rgb 1 } } } } }").error,
              "Expected 'tile2', } found instead");
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { tiles { pigment { rgb 1 } tile2 } } }").error,
              "Expected 'tile2', pigment found instead");
}

TEST(PigmentBlock, CheckerTakesColours) {
    const std::vector<PigmentColor> c = colors(sphere_with("pigment { checker rgb 1, rgb 0.25 }"));
    ASSERT_EQ(c.size(), 2u);
    EXPECT_EQ(c[0].rgb, Rgb(1.0));
    EXPECT_EQ(c[1].rgb, Rgb(0.25));
    EXPECT_EQ(colors(sphere_with("pigment { checker rgb 1 rgb 0.25 }")).at(1).rgb, Rgb(0.25));
}

TEST(PigmentBlock, CheckerDefaultsAreBlueAndGreen) {
    EXPECT_EQ(colors(sphere_with("pigment { checker }")).at(0).rgb, Rgb(0, 0, 1));
    EXPECT_EQ(colors(sphere_with("pigment { checker rgb 1 }")).at(1).rgb, Rgb(0, 1, 0));
}

TEST(PigmentBlock, CheckerTakesPigments) {
    const Object o = only("#default { pigment { rgb 0.3 } } sphere { 0, 1 pigment { checker pigment { checker scale 2 } } }");
    const std::vector<Pigment> cells = std::get<Shared<PigmentMap>>(pattern_of(layer(o).pigment).map)->pigments;
    EXPECT_TRUE(is_checker(cells.at(0)));
    EXPECT_EQ(moved(cells.at(0), Vec3(1.0)), Vec3(2.0));
    EXPECT_EQ(std::get<PigmentColor>(cells.at(1).content).rgb, Rgb(0.3));
    EXPECT_EQ(parse_block("sphere { 0, 1 pigment { checker rgb 1, pigment { rgb 1 } } }").error,
              "No matching } in 'pigment', pigment found instead");
}

TEST(PigmentBlock, TransformsAndQuickColour) {
    const Pigment p = layer(sphere_with("pigment { checker scale 2 translate x quick_color rgb 0.5 }")).pigment;
    EXPECT_EQ(moved(p, Vec3(1.0)), Vec3(3, 2, 2));
    EXPECT_EQ(p.quick_color->rgb, Rgb(0.5));
}

TEST(PigmentBlock, ASecondBlockEditsAndKeepsTheTransform) {
    const Object o = sphere_with("pigment { rgb 1 scale 2 } pigment { checker }");
    EXPECT_TRUE(is_checker(layer(o).pigment));
    EXPECT_EQ(moved(layer(o).pigment, Vec3(1.0)), Vec3(2.0));
}

TEST(PigmentBlock, ADeclaredPigmentReplaces) {
    const Object o =
        only("#declare P = pigment { checker rgb 1 rgb 0 scale 3 } sphere { 0, 1 pigment { rgb 1 scale 2 } pigment { P scale 5 } }");
    EXPECT_EQ(moved(layer(o).pigment, Vec3(1.0)), Vec3(15.0));
    const Object plain = only("#declare P = pigment { checker scale 3 } sphere { 0, 1 pigment { P rgb 0.5 } }");
    EXPECT_EQ(color_of(plain).rgb, Rgb(0.5));
}

TEST(PigmentBlock, ContentMustComeFirst) {
    EXPECT_THAT(parse_block("sphere { 0, 1 pigment { scale 2 } }").messages,
                ElementsAre(HasSubstr("Pigment type unspecified or not 1st item.")));
    EXPECT_EQ(parse_block("sphere { 0, 1 pigment { scale 2 checker } }").error, "No matching } in 'pigment', checker found instead");
    EXPECT_EQ(parse_block("sphere { 0, 1 pigment { rgb 1 rgb 0 } }").error,
              "No matching } in 'pigment', color keyword 'rgb' found instead");
}

TEST(PigmentBlock, PatternModifiersMeanNothingToAPlainColour) {
    EXPECT_EQ(color_of(sphere_with("pigment { rgb 0.5 turbulence 1 octaves 3 }")).rgb, Rgb(0.5));
}

TEST(TextureBlock, DefaultsToTheDefaultTexture) {
    const Object o = only("#default { pigment { rgb 0.3 } finish { ambient 0.9 } } sphere { 0, 1 texture { pigment { rgb 1 } } }");
    EXPECT_EQ(layer(o).finish.ambient, Rgb(0.9));
    EXPECT_EQ(color_of(o).rgb, Rgb(1.0));
    EXPECT_EQ(color_of(only("#default { pigment { rgb 0.3 } } sphere { 0, 1 }")).rgb, Rgb(0.3));
    EXPECT_EQ(color_of(only("sphere { 0, 1 texture { } }")).rgb, Rgb(0.0));
}

TEST(TextureBlock, LayersStack) {
    const Object o = sphere_with("texture { pigment { rgb 0.1 } } texture { pigment { rgbt 0.2 } } texture { pigment { rgbt 0.3 } }");
    ASSERT_EQ((*o.texture)->size(), 3u);
    EXPECT_EQ(color_of(o, 0).rgb, Rgb(0.1));
    EXPECT_EQ(color_of(o, 2).rgb, Rgb(0.3));
}

TEST(TextureBlock, EditsReachTheTopLayerOnly) {
    const Object o = only(std::string(red_over_grey) + "sphere { 0, 1 texture { T pigment { rgbt <0,0,1,0.5> } } finish { ambient 0.7 } }");
    EXPECT_EQ(color_of(o, 0).rgb, Rgb(0.5));
    EXPECT_EQ(color_of(o, 1).rgb, Rgb(0, 0, 1));
    EXPECT_EQ(layer(o, 0).finish.ambient, Rgb(0.1));
    EXPECT_EQ(layer(o, 1).finish.ambient, Rgb(0.7));
}

TEST(TextureBlock, TransformsReachAllLayers) {
    const Object o = only(std::string(red_over_grey) + "sphere { 0, 1 texture { T translate x } }");
    EXPECT_EQ(moved(layer(o, 0).pigment, Vec3(0.0)), Vec3(1, 0, 0));
    EXPECT_EQ(moved(layer(o, 1).pigment, Vec3(0.0)), Vec3(1, 0, 0));
}

TEST(TextureBlock, ADeclaredTextureOnADeclaredObjectStacks) {
    const ParsedScene p =
        parse_block(std::string(red_over_grey) + "#declare S = sphere { 0, 1 texture { pigment { rgb 1 } } } object { S texture { T } }");
    EXPECT_EQ((*p.scene.objects.at(0).texture)->size(), 3u);
}

TEST(TextureBlock, CheckerOfTextures) {
    const Object o =
        sphere_with("texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } finish { ambient 1 } } scale 2 }");
    const PatternTexture& c = pattern_of((*o.texture)->at(0));
    ASSERT_EQ(c.map->textures.size(), 2u);
    EXPECT_EQ(std::get<PlainTexture>(c.map->textures[1]->at(0).content).finish.ambient, Rgb(1.0));
    EXPECT_EQ(moved(c.pattern.pattern, Vec3(1.0)), Vec3(2.0));
    EXPECT_FALSE(std::get<PlainTexture>(c.map->textures[0]->at(0).content).pigment.transform);
    const Object one = sphere_with("texture { checker texture { pigment { rgb 1 } } }");
    EXPECT_EQ(pattern_of((*one.texture)->at(0)).map->textures.size(), 2u);
}

TEST(TextureBlock, PatternsOfTexturesTakeNoLayers) {
    const std::string pattern = "texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } ";
    EXPECT_EQ(parse_block("sphere { 0, 1 " + pattern + "texture { pigment { rgbt 1 } } }").error, "Cannot layer over a patterned texture.");
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { pigment { rgb 1 } } " + pattern + "}").error,
              "Cannot layer a patterned texture over another.");
    EXPECT_EQ(parse_block("sphere { 0, 1 " + pattern + "finish { ambient 1 } }").error, "Cannot layer over a patterned texture.");
    EXPECT_EQ(parse_block("#declare T = " + pattern + " sphere { 0, 1 texture { T pigment { rgb 1 } } }").error,
              "No matching } in 'texture', pigment found instead");
    EXPECT_EQ(parse_block("#default { " + pattern + "}").error, "Default texture cannot be material map or tiles.");
}

TEST(TextureBlock, ColoursBelongInAPigment) {
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { rgb 1 } }").error,
              "Keyword 'color' can only be used in a pigment or density statement.");
}

TEST(DefaultBlock, MayChangeWhileANormalIsReadThatBeganAsTheOldOne) {
    const Object o = only(
        "#default { texture { normal { wrinkles 1 } } } #declare N = normal #default { texture { pigment { rgb 1 } } } { bumps 2 } "
        "sphere { 0, 1 pigment { rgb 0.5 } normal { N } }");
    EXPECT_EQ(color_of(o).rgb, Rgb(0.5));
}

TEST(DefaultBlock, HasOneLayerTheLastOneStated) {
    const Object o = only("#default { texture { pigment { rgb 1 } } texture { pigment { rgbt <0,1,0,0.5> } } } sphere { 0, 1 }");
    ASSERT_EQ((*o.texture)->size(), 1u);
    EXPECT_EQ(color_of(o).rgb, Rgb(0, 1, 0));
    EXPECT_EQ(parse_block(std::string(red_over_grey) + "#default { texture { T } }").error, "Default texture cannot be layered.");
    EXPECT_EQ(parse_block("#default { interior { ior 1 } }").error, "No matching } in 'default', interior found instead");
}

TEST(DefaultBlock, EditsWhatIsThere) {
    const Object o = only("#default { pigment { rgb 0.3 } } #default { finish { ambient 0.9 } } sphere { 0, 1 }");
    EXPECT_EQ(color_of(o).rgb, Rgb(0.3));
    EXPECT_EQ(layer(o).finish.ambient, Rgb(0.9));
}

TEST(DefaultBlock, CountsWhereAnObjectIsPlaced) {
    EXPECT_EQ(color_of(only("#declare S = sphere { 0, 1 scale 2 } #default { pigment { rgb 0.3 } } object { S }")).rgb, Rgb(0.3));
    const Object touched = only("#declare S = sphere { 0, 1 finish { phong 1 } } #default { pigment { rgb 0.3 } } object { S }");
    EXPECT_EQ(color_of(touched).rgb, Rgb(0.0));
}

TEST(InteriorBlock, EveryKeyword) {
    const Object o =
        sphere_with("interior { ior 1.5 caustics 2 fade_distance 3 fade_power 4 fade_color rgb <1,2,3> dispersion_samples 7 }");
    const Interior& i = **o.interior;
    EXPECT_EQ(i.ior, 1.5);
    EXPECT_EQ(i.caustics, 90.0);
    EXPECT_EQ(i.fade_distance, 3.0);
    EXPECT_EQ(i.fade_power, 4.0);
    EXPECT_EQ(i.fade_color, Rgb(1, 2, 3));
    EXPECT_FALSE((*sphere_with("interior { caustics 1 }").interior)->ior);
    EXPECT_EQ((*sphere_with("interior { fade_colour <1,2,3> }").interior)->fade_color, Rgb(1, 2, 3));
}

TEST(InteriorBlock, EditsAndDeclaredOnes) {
    EXPECT_EQ((*sphere_with("interior { ior 1.5 } interior { caustics 1 }").interior)->ior, 1.5);
    const Object o = only("#declare I = interior { ior 1.5 } sphere { 0, 1 interior { I caustics 1 } }");
    EXPECT_EQ((*o.interior)->ior, 1.5);
    EXPECT_EQ((*o.interior)->caustics, 45.0);
    EXPECT_FALSE(sphere_with("").interior);
}

TEST(InteriorBlock, WhatIsNotModelled) {
    EXPECT_EQ(parse_block("sphere { 0, 1 interior { dispersion 1.1 } }").error, "'dispersion' is not modelled.");
    EXPECT_EQ(parse_block("sphere { 0, 1 interior { dispersion 1 } }").error, "");
    EXPECT_EQ(parse_block("sphere { 0, 1 interior { media { emission 1 } } }").error, "'media' is not modelled.");
    EXPECT_THAT(parse_block("sphere { 0, 1 interior { refraction 0.5 } }").messages,
                ElementsAre(HasSubstr("Refraction value unnecessary to turn on refraction.")));
}

TEST(MaterialBlock, BringsTexturesAndInterior) {
    const Object o = only(
        "#declare M = material { texture { pigment { rgb 0.2 } } interior_texture { pigment { rgb 0.4 } } interior { ior 2 } } "
        "sphere { 0, 1 material { M } }");
    EXPECT_EQ(color_of(o).rgb, Rgb(0.2));
    EXPECT_EQ(std::get<PigmentColor>(std::get<PlainTexture>((*o.interior_texture)->at(0).content).pigment.content).rgb, Rgb(0.4));
    EXPECT_EQ((*o.interior)->ior, 2.0);
}

TEST(MaterialBlock, StacksOnWhatIsThereAndMovesAllOfIt) {
    const Object o = sphere_with("texture { pigment { checker } } material { texture { pigment { rgbt 0.5 } } scale 2 }");
    ASSERT_EQ((*o.texture)->size(), 2u);
    EXPECT_EQ(moved(layer(o, 0).pigment, Vec3(1.0)), Vec3(2.0));
    EXPECT_EQ(parse_block("sphere { 0, 1 material { pigment { rgb 1 } } }").error, "No matching } in 'material', pigment found instead");
}

TEST(InteriorTexture, NeedsAnExteriorOne) {
    EXPECT_EQ(parse_block("sphere { 0, 1 interior_texture { pigment { rgb 1 } } }").error,
              "Interior texture requires an exterior texture.");
    EXPECT_EQ(parse_block("sphere { 0, 1 interior_texture { pigment { rgb 1 } } pigment { rgb 0 } }").error, "");
}

TEST(DeclaredTextures, AreKnownToTheDeclarationThatFollowsAtOnce) {
    const Object o =
        only("#declare A = texture { pigment { rgb 0.3 } }\n#declare B = texture { A finish { phong 1 } }\nsphere { 0, 1 texture { B } }");
    EXPECT_EQ(color_of(o).rgb, Rgb(0.3));
    EXPECT_EQ(layer(o).finish.phong, 1.0);
}

}  // namespace
}  // namespace rt::blocks_texture_test
