// Patterns with their maps and modifiers, normals, patterns of textures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/checkers.h"
#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_pattern_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Object only(const std::string& text) {
    const ParsedScene parsed = parse_block(text);
    if (!parsed.error.empty()) throw std::runtime_error(parsed.error);
    return parsed.scene.objects.at(0);
}
PatternPigment pigment(const std::string& body) { return pattern_of(layer(only("sphere { 0, 1 pigment { " + body + " } }")).pigment); }
Normal normal(const std::string& body) { return **layer(only("sphere { 0, 1 normal { " + body + " } }")).normal; }
std::string error_in_pigment(const std::string& body) { return parse_block("sphere { 0, 1 pigment { " + body + " } }").error; }
std::string error_in_normal(const std::string& body) { return parse_block("sphere { 0, 1 normal { " + body + " } }").error; }
const ColorMap& colors(const PatternPigment& p) { return *std::get<Shared<ColorMap>>(p.map); }

TEST(PatternBlock, ColorMapsHaveNewAndOldEntries) {
    const PatternPigment p = pigment("bozo color_map { [0, 0.4 color rgb 1, color rgb 0.5] [0.4 rgbt <1, 0, 0, 0.5>] }");
    EXPECT_EQ(p.pattern.pattern.kind, PatternKind::bozo);
    EXPECT_THAT(colors(p).values, ElementsAre(0.0, 0.4, 0.4));
    EXPECT_EQ(colors(p).colors.at(1).rgb, Rgb(0.5));
    EXPECT_EQ(colors(p).colors.at(2).transmit, 0.5);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(pigment("granite").map)) << "the kind's own";
}

TEST(PatternBlock, RoundsOfFractalsAreLimited) {
    EXPECT_EQ(error_in_pigment("mandel 1000000"), "");
    EXPECT_EQ(error_in_pigment("mandel 1000001"), "A fractal pattern has at most 1000000 iterations.");
    EXPECT_EQ(error_in_pigment("magnet 1 julia <1, 2>, 1000001"), "A fractal pattern has at most 1000000 iterations.");
}

TEST(PatternBlock, MapsThatDoNotFitAreRefused) {
    EXPECT_EQ(error_in_pigment("bozo color_map { }"), "Must have at least one color in color map.");
    EXPECT_EQ(error_in_pigment("bozo pigment_map { }"), "Must have at least one entry in map.");
    EXPECT_EQ(error_in_pigment("bozo color_map { [0 0.5 rgb 1 rgb 0] }"), "Expected 'color', color keyword 'rgb' found instead");
    EXPECT_EQ(error_in_pigment("bozo color_map { [0 <1, 0, 0>] }"), "Expected 'color', < found instead");
    EXPECT_EQ(error_in_pigment("checker color_map { [0 rgb 1] }"), "Cannot use color_map with this pattern type.");
    EXPECT_EQ(error_in_pigment("rgb 1 pigment_map { [0 rgb 1] }"), "Cannot use pigment_map with this pattern type.");
    EXPECT_EQ(error_in_pigment("average color_map { [0 rgb 1] }"), "Cannot use color_map with this pattern type.");
    EXPECT_EQ(error_in_pigment("average"), "Average must have map.");
    EXPECT_EQ(error_in_pigment("bozo texture_map { [0 pigment { rgb 1 }] }"),
              "Keyword 'texture_map' can only be used in a texture statement.");
    EXPECT_EQ(error_in_pigment("bozo slope_map { [0 <1, 1>] }"), "Keyword 'slope_map' can only be used in a normal statement.");
    EXPECT_EQ(error_in_normal("bozo color_map { [0 rgb 1] }"), "Keyword 'color_map' can only be used in a pigment statement.");
}

TEST(PatternBlock, WeightsOfAverageMayBeLeftOut) {
    const PatternPigment p = pigment("average pigment_map { [checker] [3 rgb 1] [, bozo] }");
    EXPECT_THAT((*std::get<Shared<PigmentMap>>(p.map)).values, ElementsAre(1.0, 3.0, 1.0));
    EXPECT_THAT((*normal("average normal_map { [bumps 2] [0.5, dents 2] }").map)->values, ElementsAre(1.0, 0.5));
    const Object o = only("sphere { 0, 1 texture { average texture_map { [pigment { rgb 1 }] [2 pigment { rgb 0 }] } } }");
    EXPECT_THAT((*pattern_of((*o.texture)->at(0)).map).values, ElementsAre(1.0, 2.0));
    EXPECT_EQ(error_in_pigment("average pigment_map { [rgb 1] }"), "Expected 'numeric expression', color keyword 'rgb' found instead");
    EXPECT_EQ(error_in_pigment("wood pigment_map { [checker] }"), "Expected 'numeric expression', checker found instead");
    EXPECT_EQ(parse_block("#declare M = pigment_map { [checker] }").error, "Expected 'numeric expression', checker found instead");
}

TEST(PatternBlock, ADeclaredPatternTakesAnotherMap) {
    const Object o = only(
        "#declare M = color_map { [0 rgb 0.25] } #declare P = pigment { wood turbulence 0.5 scale 2 color_map { [0 rgb 1] } } "
        "sphere { 0, 1 pigment { P color_map { M } rotate 90*z } }");
    const PatternPigment& p = pattern_of(layer(o).pigment);
    EXPECT_EQ(colors(p).colors.at(0).rgb, Rgb(0.25));
    EXPECT_EQ(p.pattern.pattern.turbulence->amount, Vec3(0.5));
    EXPECT_NEAR(std::get<Transform>(p.pattern.pattern.warps.at(0)).point({1, 0, 0}).y, 2.0, 1e-12);
    EXPECT_EQ(parse_block("#declare M = color_map { [0 rgb 1] } sphere { 0, 1 pigment { bozo color_map { M [1 rgb 0] } } }").error,
              "No matching } in 'color_map', [ found instead");
}

TEST(PatternBlock, NumbersOfThePattern) {
    const Pattern p = pigment(
                          "crackle form <1, 0, 0> metric 1 offset 0.5 solid turbulence <1, 2, 3> octaves 20 omega 0.3 lambda 3 "
                          "frequency 2 phase 0.5 poly_wave 3 noise_generator 1")
                          .pattern.pattern;
    EXPECT_EQ(std::get<CrackleNumbers>(p.numbers), (CrackleNumbers{1.0, 0.5, {1, 0, 0}, true}));
    EXPECT_EQ(p.turbulence, (Turbulence{{1, 2, 3}, 10, 0.3F, 3.0F}));
    EXPECT_EQ(p.frequency, 2.0F);
    EXPECT_EQ(p.phase, 0.5F);
    EXPECT_EQ(p.wave, WaveType::poly);
    EXPECT_EQ(p.wave_exponent, 3.0F);
    EXPECT_EQ(p.noise, NoiseGenerator::original);
    EXPECT_EQ(std::get<GradientNumbers>(pigment("gradient 2*y").pattern.pattern.numbers).direction, Vec3(0, 2, 0));
    EXPECT_EQ(std::get<SpiralNumbers>(pigment("spiral1 3").pattern.pattern.numbers).arms, 3);
    EXPECT_EQ(std::get<BrickNumbers>(pigment("brick rgb 1 rgb 0 brick_size 2 mortar 0.25").pattern.pattern.numbers),
              (BrickNumbers{Vec3(2.0), 0.25}));
}

TEST(PatternBlock, NumbersOfOtherPatternsAreRefused) {
    EXPECT_EQ(error_in_pigment("bozo agate_turb 1"), "Keyword 'agate_turb' cannot be used with non-agate.");
    EXPECT_EQ(error_in_pigment("bozo mortar 1"), "Keyword 'mortar' cannot be used with non-brick.");
    EXPECT_EQ(error_in_pigment("bozo metric 1"), "Keyword 'metric' can only be used in a facets or crackle statement.");
    EXPECT_EQ(error_in_pigment("bozo form 1"), "Keyword 'form' can only be used in a crackle or pavement statement.");
    EXPECT_EQ(error_in_pigment("bozo control0 1"), "Keyword 'control0' cannot be used with this pattern.");
    EXPECT_EQ(error_in_pigment("bozo exterior 1, 2"),
              "Keyword 'exterior' can only be used in a mandel, julia, magnet or pavement statement.");
    EXPECT_EQ(error_in_pigment("bozo noise_generator 4"), "Value for noise_generator must be 0, 1, 2, or 3.");
    EXPECT_EQ(error_in_pigment("magnet 3 mandel 5"), "Invalid magnet-mandel pattern type found. Valid types are 1 and 2.");
    EXPECT_EQ(error_in_pigment("facets"), "Keyword 'facets' can only be used in a normal statement.");
    EXPECT_EQ(error_in_pigment("bozo accuracy 1"), "accuracy can only be used with normal patterns.");
    EXPECT_EQ(error_in_pigment("tiling 3"), "'tiling' is not modelled.");
}

TEST(PatternBlock, WarpsKeepTheirPlaceInTheChain) {
    const std::vector<Warp> warps =
        pigment("bozo scale 2 warp { repeat 3*y offset x flip z } translate x rotate 10*y warp { turbulence 1 octaves 2 }")
            .pattern.pattern.warps;
    ASSERT_EQ(warps.size(), 4u);
    EXPECT_TRUE(std::holds_alternative<Transform>(warps[0]));
    EXPECT_EQ(std::get<RepeatWarp>(warps[1]), (RepeatWarp{1, 3.0F, {1, 0, 0}, {0, 0, 1}}));
    EXPECT_TRUE(std::holds_alternative<Transform>(warps[2])) << "two steps in one";
    EXPECT_EQ(std::get<Turbulence>(warps[3]).octaves, 2);
    EXPECT_EQ(error_in_pigment("bozo warp { repeat 0 }"), "No axis specified in repeat.");
    EXPECT_EQ(error_in_pigment("bozo warp { repeat <1, 1, 0> }"), "Can only repeat along 1 axis.");
    EXPECT_EQ(error_in_pigment("bozo warp { }"), "Expected 'warp type', } found instead");
}

TEST(NormalBlock, AmountAccuracyAndSlopes) {
    EXPECT_EQ(normal("bumps").bump.amount, 0.5F);
    EXPECT_EQ(normal("bumps, -0.25").bump.amount, -0.25F);
    EXPECT_EQ(normal("bumps 2 bump_size 3").bump.amount, 3.0F);
    const Normal n = normal("bozo 1 accuracy 0.1 no_bump_scale slope_map { [0 <0, 1>] [1 <1, 2>] }");
    EXPECT_EQ(n.bump.accuracy, 0.1F);
    EXPECT_FALSE(n.bump.scale);
    EXPECT_EQ(n.bump.slopes, (std::vector<SlopeEntry>{{0, 0, 1}, {1, 1, 2}}));
    EXPECT_EQ(error_in_normal(""), "No normal type given.");
    EXPECT_EQ(error_in_normal("rgb 1"), "Keyword 'color' can only be used in a pigment or density statement.");
    EXPECT_EQ(error_in_normal("average"), "Average must have map.");
}

TEST(NormalBlock, ASecondBlockEditsAndDeclaredOnesAreCopied) {
    const Object o = only("sphere { 0, 1 normal { bumps 2 } normal { bump_size 1 scale 3 } }");
    EXPECT_EQ((*layer(o).normal)->pattern.pattern.kind, PatternKind::bumps);
    EXPECT_EQ((*layer(o).normal)->bump.amount, 1.0F);
    const Object declared = only("#declare N = normal { dents 2 } sphere { 0, 1 normal { N scale 2 } }");
    EXPECT_EQ((*layer(declared).normal)->pattern.pattern.kind, PatternKind::dents);
    EXPECT_EQ(moved((*layer(declared).normal)->pattern.pattern, Vec3(1.0)), Vec3(2.0));
    const Normal mapped = normal("gradient x normal_map { [0 bumps 1] [1 average normal_map { [1 dents] [2 waves] }] }");
    EXPECT_EQ((*mapped.map)->normals.at(1).pattern.pattern.kind, PatternKind::average);
}

TEST(PatternBlock, ANewKindKeepsWhatWasDeclared) {
    const auto of = [](const std::string& body) {
        return pattern_of(layer(only("#declare P = pigment { gradient x sine_wave frequency 3 phase 0.5 color_map { [0 rgb 1] [1 rgb 0] } }"
                                     "#declare C = pigment { checker rgb 1, rgb 0 scale 2 } sphere { 0, 1 pigment { " +
                                     body + " } }"))
                              .pigment);
    };
    const PatternPigment bozo = of("P bozo");
    EXPECT_EQ(bozo.pattern.pattern.kind, PatternKind::bozo);
    EXPECT_EQ(bozo.pattern.pattern.wave, WaveType::sine);
    EXPECT_EQ(bozo.pattern.pattern.frequency, 3.0F);
    EXPECT_EQ(bozo.pattern.pattern.phase, 0.5F);
    EXPECT_EQ(colors(bozo).colors.at(0).rgb, Rgb(1.0));
    EXPECT_EQ(of("P marble").pattern.pattern.wave, WaveType::triangle) << "its own";
    EXPECT_EQ(of("P checker").pattern.pattern.frequency, 0.0F) << "that of cells";
    EXPECT_EQ(of("C gradient x").pattern.pattern.frequency, 0.0F) << "that of cells still";
    EXPECT_EQ(moved(of("C gradient x").pattern.pattern, Vec3(1.0)), Vec3(2.0));
    EXPECT_THAT(colors(of("C gradient x")).values, ElementsAre(0.0, 1.0));
}

TEST(PatternBlock, CellsTakeVectorsAsColors) {
    const PatternPigment p = pigment("hexagon <1, 0, 0>, 0.5, <0, 1, 0, 0, 0.25>");
    EXPECT_EQ(colors(p).colors.at(0).rgb, Rgb(1, 0, 0));
    EXPECT_EQ(colors(p).colors.at(2).transmit, 0.25);
    EXPECT_EQ(error_in_pigment("checker <1, 0, 0> <0, 1, 0>"), "No matching } in 'pigment', float function 'float constant' found instead")
        << "a comparison, as POV-Ray has it";
}

TEST(NormalBlock, AmountsAndPatternsFollowADeclaredOne) {
    const auto of = [](const std::string& body) {
        return **layer(only("#declare N = normal { dents 2 scale 3 } #declare M = normal { gradient x normal_map { [0 bumps] [1 dents] } } "
                            "sphere { 0, 1 normal { " +
                            body + " } }"))
                     .normal;
    };
    EXPECT_EQ(of("N 2.5").bump.amount, 2.5F);
    EXPECT_EQ(of("N, 2.5 scale 2").bump.amount, 2.5F);
    EXPECT_EQ(of("N bumps").bump.amount, 2.0F);
    EXPECT_EQ(of("N bumps 1").pattern.pattern.kind, PatternKind::bumps);
    EXPECT_EQ(moved(of("N bumps").pattern.pattern, Vec3(1.0)), Vec3(3.0));
    EXPECT_TRUE(of("M onion").map);
    EXPECT_FALSE(of("M checker").map) << "cells have normals of their own";
    EXPECT_TRUE(of("uv_mapping N bumps").pattern.uv_mapping);
}

TEST(TextureBlock, BeginsWithTheNamesOfDeclaredParts) {
    const auto of = [](const std::string& body) {
        return parse_block(
            "#declare P = pigment { bozo } #declare N = normal { bumps } #declare F = finish { phong 0.5 } "
            "sphere { 0, 1 texture { " +
            body + " } }");
    };
    for (const char* body : {"P N F", "F P N", "N F P scale 2"}) {
        const ParsedScene parsed = of(body);
        ASSERT_EQ(parsed.error, "") << body;
        const PlainTexture& top = layer(parsed.scene.objects.at(0));
        EXPECT_EQ(pattern_of(top.pigment).pattern.pattern.kind, PatternKind::bozo) << body;
        EXPECT_EQ((*top.normal)->pattern.pattern.kind, PatternKind::bumps) << body;
        EXPECT_EQ(top.finish.phong, 0.5) << body;
    }
    EXPECT_EQ(of("finish { ambient 1 } P").error, "No matching } in 'texture', pigment identifier found instead");
    EXPECT_EQ(of("scale 2 P").error, "No matching } in 'texture', pigment identifier found instead");
}

TEST(TextureBlock, PatternsOfTexturesNeedAMap) {
    const Object o = only("sphere { 0, 1 texture { gradient y texture_map { [0 pigment { rgb 1 }] [1 checker] } scale 2 } }");
    const PatternTexture& p = pattern_of((*o.texture)->at(0));
    EXPECT_EQ(p.pattern.pattern.kind, PatternKind::gradient);
    EXPECT_THAT(p.map->values, ElementsAre(0.0, 1.0));
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { bozo } }").error, "Patterned texture must have texture_map.");
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { bozo texture_map { [0 texture { }] } } }").error, "Expected ']', texture found instead");
    EXPECT_EQ(parse_block("sphere { 0, 1 texture { checker pigment { rgb 1 } } }").error,
              "No matching } in 'texture', pigment found instead");
}

TEST(TextureBlock, MotionReachesPatternsButNotThoseOnTheSurface) {
    const Object o = only("sphere { 0, 1 pigment { bozo } normal { bumps scale 2 } translate x }");
    EXPECT_EQ(moved(layer(o).pigment, Vec3(0.0)), Vec3(1, 0, 0));
    EXPECT_EQ(moved((*layer(o).normal)->pattern.pattern, Vec3(1.0)), Vec3(3, 2, 2));
    const Object uv = only("sphere { 0, 1 pigment { uv_mapping bozo scale 2 } normal { bumps } translate x }");
    EXPECT_EQ(moved(layer(uv).pigment, Vec3(1.0)), Vec3(2.0));
    EXPECT_EQ(moved((*layer(uv).normal)->pattern.pattern, Vec3(0.0)), Vec3(1, 0, 0));
}

TEST(Surroundings, AreReadAndRefused) {
    const ParsedScene p = parse_block(
        "sky_sphere { pigment { gradient y } pigment { rgbt 1 } emission 2 scale 2 } fog { distance 5 rgb 0.5 fog_type 2 fog_alt 2 } "
        "rainbow { direction z angle 20 width 5 distance 9 arc_angle 100 color_map { [0 rgb 1] } }");
    EXPECT_EQ(p.error, "");
    ASSERT_TRUE(p.scene.sky_sphere);
    EXPECT_EQ(p.scene.sky_sphere->pigments.size(), 2u);
    EXPECT_EQ(moved(p.scene.sky_sphere->pigments[0], Vec3(1.0)), Vec3(2.0));
    EXPECT_EQ(p.scene.fogs.at(0).type, Fog::Type::ground);
    EXPECT_EQ(p.scene.rainbows.at(0).arc_angle, 50.0) << "to each side";
    EXPECT_EQ(parse_block("sky_sphere { }").error, "Empty sky_sphere statement.");
    EXPECT_EQ(parse_block("rainbow { }").error, "Rainbow's direction vector is zero.");
    EXPECT_EQ(parse_block("rainbow { direction y }").error, "Rainbow's up and direction vector are co-linear.");
    EXPECT_THAT(parse_block("sky_sphere { pigment { rgb 1 } } sky_sphere { pigment { rgb 1 } }").messages,
                ElementsAre(HasSubstr("Only one sky-sphere allowed (last one will be used).")));
    EXPECT_THAT(parse_block("fog { fog_type 3 }").messages, ElementsAre(HasSubstr("Unknown fog type.")));
}

/// A picture of two texels, a red one and a half transparent grey one.
std::optional<PictureFile> two_texels(const std::string& path) {
    if (path != "two.png") return std::nullopt;
    return PictureFile{2, 1, 4, 255, {255, 0, 0, 255, 51, 51, 51, 51}, std::nullopt};
}

TEST(PictureBlock, ImageMapsHoldLinearColours) {
    ParseOptions options;
    options.read_picture = two_texels;
    const ParsedScene p = parse_block(
        "sphere { 0, 1 pigment { image_map { png \"two.png\" gamma 2 once interpolate 2 map_type 1 "
        "filter all 0.25 } } }",
        options);
    EXPECT_EQ(p.error, "");
    const auto map = std::get<Shared<ImageMap>>(pattern_of(layer(p.scene.objects.at(0)).pigment).map);
    EXPECT_EQ(map->image->texels.at(0), (std::array<float, 4>{1, 0, 0, 0}));
    EXPECT_FLOAT_EQ(map->image->texels.at(1)[0], 0.04F);
    EXPECT_FLOAT_EQ(map->image->texels.at(1)[3], 0.8F);
    EXPECT_EQ(map->filter, 0.25);
    EXPECT_EQ(map->mapping, (ImageMapping{1, 2, true, Vec2(0.0), Vec2(1.0)}));
    const auto error = [&](const std::string& inside) {
        return parse_block("sphere { 0, 1 pigment { image_map { " + inside + " } } }", options).error;
    };
    EXPECT_EQ(error("png \"two.png\" map_type 4"), "Invalid map_type value.");
    EXPECT_EQ(error("png \"two.png\" interpolate 1"), "Invalid interpolate value.");
    EXPECT_EQ(error("png \"none.png\""), "Cannot find image file.");
    EXPECT_EQ(error("png \"two\""), "") << "the type's endings are tried";
    EXPECT_EQ(error("\"two\""), "");
    EXPECT_EQ(error("tga \"two\""), "Cannot find image file.");
    EXPECT_EQ(error("function 10,10 { x }"), "'image_map { function }' is not modelled.");
}

TEST(PictureBlock, SomeFormatsAreReadInWaysOfTheirOwn) {
    using Kind = PictureFile::Kind;
    const auto grey = [](Kind kind, int max_value, float value, const std::string& stated) {
        ParseOptions options;
        options.read_picture = [&](const std::string&) {
            PictureFile picture{1, 1, 3, max_value, {value, 0.5F * value, 0.0F}, {}, kind};
            return std::optional<PictureFile>(picture);
        };
        const Scene p =
            parse_text({"t.pov", "#version 3.7; global_settings { assumed_gamma 2 } sphere { 0, 1 pigment { image_map { sys \"a\" " +
                                     stated + " } } }"},
                       options, [](std::string_view) {});
        return std::get<Shared<ImageMap>>(pattern_of(layer(p.objects.at(0)).pigment).map)->image->texels.at(0)[0];
    };
    for (const Kind kind : {Kind::pixmap, Kind::tiff}) {
        EXPECT_FLOAT_EQ(grey(kind, 255, 51.0F, ""), 0.2F) << "in the working space already";
        EXPECT_FLOAT_EQ(grey(kind, 255, 51.0F, "gamma 4"), 0.04F);
        EXPECT_GT(grey(kind, 255, 51.0F, "gamma srgb"), 0.18F);
        EXPECT_LT(grey(kind, 255, 51.0F, "gamma srgb"), 0.19F);
    }
    EXPECT_FLOAT_EQ(grey(Kind::tiff, 65535, 13311.0F, ""), 0.2F) << "eight of sixteen bits";
    EXPECT_FLOAT_EQ(grey(Kind::pixmap, 65535, 13107.0F, ""), 0.2F);
    EXPECT_FLOAT_EQ(grey(Kind::hdr, 0, 0.5F, ""), std::sqrt(0.5F + 0x1p-9F)) << "half a unit of the last place";
}

TEST(PictureBlock, BeforeVersion37NumbersOfUnknownGammaStayAsTheyAre) {
    const auto grey = [](const std::string& version, std::optional<double> of_file, const std::string& stated) {
        ParseOptions options;
        options.read_picture = [&](const std::string& path) {
            std::optional<PictureFile> picture = two_texels(path);
            if (picture) picture->gamma = of_file;
            return picture;
        };
        const Scene p =
            parse_text({"t.pov", version + " global_settings { assumed_gamma 1 } sphere { 0, 1 pigment { image_map { png \"two.png\" " +
                                     stated + " } } }"},
                       options, [](std::string_view) {});
        return std::get<Shared<ImageMap>>(pattern_of(layer(p.objects.at(0)).pigment).map)->image->texels.at(1)[0];
    };
    const auto decoded = static_cast<float>(std::pow((0.2 + 0.055) / 1.055, 2.4));
    EXPECT_FLOAT_EQ(grey("#version 3.7;", {}, ""), decoded);
    EXPECT_FLOAT_EQ(grey("#version 3.6;", {}, ""), 0.2F);
    EXPECT_FLOAT_EQ(grey("", {}, ""), 0.2F);
    EXPECT_FLOAT_EQ(grey("#version 3.6;", 2.0, ""), 0.04F);
    EXPECT_FLOAT_EQ(grey("#version 3.6;", {}, "gamma 2"), 0.04F);
}

const Bodies& bodies(const StatedPattern& pattern) { return *std::get<Shared<Bodies>>(pattern.source); }

TEST(ObjectPattern, ListsWhatIsOutsideAndInside) {
    const PatternPigment p = pigment("object { sphere { 0, 2 } translate x rgb 0.25, rgb 0.5 } scale 3");
    EXPECT_EQ(p.pattern.pattern.kind, PatternKind::object);
    EXPECT_EQ(bodies(p.pattern).objects.size(), 1U);
    EXPECT_EQ(bodies(p.pattern).objects[0].transform->offset, Vec3(1.0, 0.0, 0.0));
    EXPECT_EQ(p.pattern.pattern.warps.size(), 1U);
    EXPECT_THAT(colors(p).values, ElementsAre(0.0, 1.0));
    EXPECT_EQ(colors(p).colors[0].rgb, Rgb(0.25));
    EXPECT_EQ(colors(p).colors[1].rgb, Rgb(0.5));
    const PatternPigment own = pigment("object { sphere { 0, 2 } rgb 0.25 }");
    EXPECT_EQ(colors(own).colors[1].rgb, Rgb(0.0, 1.0, 0.0));
    EXPECT_TRUE(
        std::holds_alternative<Shared<PigmentMap>>(pigment("object { sphere { 0, 2 } pigment { rgb 0.2 } pigment { rgb 1 } }").map));
}

TEST(ObjectPattern, TakesSetsTexturesAndNormals) {
    const PatternPigment p =
        pigment("object { union { sphere { 0, 1 } difference { sphere { x, 1 } box { 0, 1 } } scale 2 } scale 2 rgb 0 rgb 1 }");
    EXPECT_EQ(bodies(p.pattern).objects.size(), 3U);
    EXPECT_EQ(bodies(p.pattern).sets.size(), 1U);
    EXPECT_EQ(bodies(p.pattern).objects[0].transform->linear[0][0], 4.0);
    const Normal n = normal("object { box { 0, 1 } } 0.3");
    EXPECT_EQ(n.bump.amount, 0.3F);
    EXPECT_EQ(normal("object { box { 0, 1 } normal { bumps } normal { bumps } }").map.value()->normals.size(), 2U);
    const ParsedScene textures =
        parse_block("sphere { 0, 1 texture { object { box { 0, 1 } texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } } }");
    EXPECT_EQ(textures.error, "");
}

TEST(ObjectPattern, Refusals) {
    EXPECT_EQ(error_in_pigment("object { rgb 1 }"), "Expected 'object', color keyword 'rgb' found instead");
    EXPECT_EQ(error_in_pigment("object { sphere { 0, 1 } rgb 1 rgb 1 rgb 1 }"),
              "No matching } in 'object', color keyword 'rgb' found instead");
    EXPECT_EQ(error_in_pigment("object { sphere { 0, 1 } rgb 1 rgb 1 } color_map { [0 rgb 1] }"),
              "Cannot use color_map with this pattern type.");
}

}  // namespace
}  // namespace rt::blocks_pattern_test
