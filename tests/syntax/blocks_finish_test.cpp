#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_finish_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Finish finish(const std::string& body) { return layer(sphere_with("finish { " + body + " }")).finish; }
ParsedScene with_finish(const std::string& body) { return parse_block("sphere { 0, 1 finish { " + body + " } }"); }

TEST(FinishBlock, DefaultsArePovRays) {
    const Finish f = finish("");
    EXPECT_EQ(f, Finish{});
    EXPECT_EQ(f.ambient, Rgb(0.1));
    EXPECT_EQ(f.diffuse, 0.6);
    EXPECT_EQ(f.brilliance, 1.0);
    EXPECT_EQ(f.phong_size, 40.0);
    EXPECT_FALSE(f.roughness);
}

TEST(FinishBlock, EveryKeyword) {
    const Finish f = finish(
        "ambient 0.3 emission rgb <1,2,3> diffuse 0.5, 0.25 brilliance 2 phong 0.7 phong_size 30 specular 0.6 roughness 0.02 metallic 0.5 "
        "reflection 0.4 reflection_exponent 3 conserve_energy");
    EXPECT_EQ(f.ambient, Rgb(0.3));
    EXPECT_EQ(f.emission, Rgb(1, 2, 3));
    EXPECT_EQ(f.diffuse, 0.5);
    EXPECT_EQ(f.diffuse_back, 0.25);
    EXPECT_EQ(f.brilliance, 2.0);
    EXPECT_EQ(f.phong, 0.7);
    EXPECT_EQ(f.phong_size, 30.0);
    EXPECT_EQ(f.specular, 0.6);
    EXPECT_EQ(f.roughness, 0.02);
    EXPECT_EQ(f.metallic, 0.5);
    EXPECT_EQ(f.reflection.min, Rgb(0.4));
    EXPECT_EQ(f.reflection.max, Rgb(0.4));
    EXPECT_EQ(f.reflection.exponent, 3.0);
    EXPECT_TRUE(f.conserve_energy);
}

TEST(FinishBlock, ColourSlotsTakeFloatsColoursOrNothing) {
    EXPECT_EQ(finish("ambient rgb <1,2,3>").ambient, Rgb(1, 2, 3));
    EXPECT_EQ(finish("ambient red 1").ambient, Rgb(1, 0, 0));
    EXPECT_EQ(finish("ambient diffuse 0.2").ambient, Rgb(0.0));
    EXPECT_EQ(finish("reflection 0.5 reflection").reflection.max, Rgb(0.5));
    EXPECT_EQ(with_finish("diffuse rgb 1").error, "Expected 'numeric expression', color keyword 'rgb' found instead");
}

TEST(FinishBlock, MetallicAloneIsOne) {
    EXPECT_EQ(finish("metallic").metallic, 1.0);
    EXPECT_EQ(finish("metallic off").metallic, 0.0);
    EXPECT_EQ(finish("metallic metallic 2").metallic, 2.0);
}

TEST(FinishBlock, ReflectionBlock) {
    const Reflection r = finish("reflection { 0.1, 0.8 falloff 3 exponent 2 metallic fresnel }").reflection;
    EXPECT_EQ(r.min, Rgb(0.1));
    EXPECT_EQ(r.max, Rgb(0.8));
    EXPECT_EQ(r.falloff, 3.0);
    EXPECT_EQ(r.exponent, 2.0);
    EXPECT_EQ(r.metallic, 1.0);
    EXPECT_TRUE(r.fresnel);
    EXPECT_EQ(finish("reflection { 0.1 0.8 }").reflection.max, Rgb(0.8));
    EXPECT_EQ(finish("reflection { 0.4, }").reflection.min, Rgb(0.4));
    EXPECT_FALSE(finish("reflection { 0.1, 0.8 fresnel off }").reflection.fresnel);
    EXPECT_EQ(with_finish("reflection { 0.1, 0.5, fresnel }").error, "No matching } in '{', , found instead");
}

TEST(FinishBlock, OneReflectionColourWithFresnelStartsFromNone) {
    EXPECT_EQ(finish("reflection { 0.4 }").reflection.min, Rgb(0.4));
    EXPECT_EQ(finish("reflection { 0.4 fresnel }").reflection.min, Rgb(0.0));
    EXPECT_EQ(finish("reflection { 0.4 fresnel }").reflection.max, Rgb(0.4));
    EXPECT_EQ(finish("reflection { 0.4 fresnel off }").reflection.min, Rgb(0.4));
}

TEST(FinishBlock, ASecondReflectionKeepsTheExponentOnly) {
    const Reflection r = finish("reflection { 0.1, 0.8 fresnel exponent 2 } reflection { 0.5 }").reflection;
    EXPECT_EQ(r.min, Rgb(0.5));
    EXPECT_EQ(r.exponent, 2.0);
    EXPECT_FALSE(r.fresnel);
}

TEST(FinishBlock, AlbedosAreScaledByTheExponentsInForceAtTheEnd) {
    const Finish d = finish("diffuse albedo 0.5, 0.2 brilliance 3");
    EXPECT_DOUBLE_EQ(d.diffuse, 0.5 * 4 / 2);
    EXPECT_DOUBLE_EQ(d.diffuse_back, 0.2 * 4 / 2);
    EXPECT_DOUBLE_EQ(finish("phong albedo 0.2 phong_size 3").phong, 0.2 * 4 / 2);
    EXPECT_DOUBLE_EQ(finish("roughness 0.1 specular albedo 0.1").specular, 0.1 * 12 / (4 * (2 - std::pow(2.0, -5.0))));
    EXPECT_DOUBLE_EQ(finish("specular albedo 0.1").specular, 0.1 * 22 / (4 * (2 - std::pow(2.0, -10.0))));
}

TEST(FinishBlock, ADeclaredFinishIsCopiedAndASecondBlockEdits) {
    const std::string declared = "#declare F = finish { ambient 0.7 phong 1 } ";
    EXPECT_EQ(layer(parse_block(declared + "sphere { 0, 1 finish { F phong 2 } }").scene.objects.at(0)).finish.phong, 2.0);
    EXPECT_EQ(layer(parse_block(declared + "sphere { 0, 1 finish { F phong 2 } }").scene.objects.at(0)).finish.ambient, Rgb(0.7));
    EXPECT_EQ(layer(parse_block(declared + "sphere { 0, 1 finish { diffuse 1 } finish { F } }").scene.objects.at(0)).finish.diffuse, 0.6);
    const Finish edited = layer(sphere_with("finish { ambient 0.7 } finish { phong 2 }")).finish;
    EXPECT_EQ(edited.ambient, Rgb(0.7));
    EXPECT_EQ(edited.phong, 2.0);
    EXPECT_EQ(parse_block(declared + "sphere { 0, 1 finish { phong 2 F } }").error,
              "No matching } in 'finish', finish identifier found instead");
}

TEST(FinishBlock, LegacyKeywordsWarnAndAreKept) {
    const ParsedScene p = with_finish("ior 1.5 refraction 0.6 caustics 3");
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Index of refraction value should be specified in 'interior{...}' statement."),
                                        HasSubstr("Refraction value unnecessary to turn on refraction."),
                                        HasSubstr("Caustics value should be specified in 'interior{...}' statement.")));
    const Finish f = layer(p.scene.objects.at(0)).finish;
    EXPECT_EQ(f.ior, 1.5);
    EXPECT_EQ(f.refraction, 0.6);
    EXPECT_EQ(f.caustics, 3.0);
}

TEST(FinishBlock, ZeroRoughnessWarns) {
    EXPECT_THAT(with_finish("roughness 0").messages, ElementsAre(HasSubstr("Zero roughness used.")));
    EXPECT_THAT(with_finish("roughness 0.001").messages, IsEmpty());
}

TEST(FinishBlock, NothingIsClamped) {
    const Finish f = finish("specular 10 diffuse -1 phong_size -3 ambient -0.5");
    EXPECT_EQ(f.specular, 10.0);
    EXPECT_EQ(f.diffuse, -1.0);
    EXPECT_EQ(f.phong_size, -3.0);
    EXPECT_EQ(f.ambient, Rgb(-0.5));
}

TEST(FinishBlock, GrainAndFilm) {
    EXPECT_EQ(finish("crand 0.1").crand, 0.1);
    EXPECT_EQ(finish("irid { 0.3 thickness 1 turbulence 0.5 }").irid, (Irid{0.3, 1.0, 0.5}));
}

TEST(FinishBlock, WhatIsNotModelled) {
    EXPECT_EQ(with_finish("subsurface { translucency 1 }").error, "'subsurface' is not modelled.");
    EXPECT_EQ(with_finish("albedo 0.5").error, "No matching } in 'finish', albedo found instead");
    EXPECT_EQ(with_finish("conserve_energy on").error, "No matching } in 'finish', float function 'on' found instead");
}

TEST(Choices, BelongToTheFinishTheyStandIn) {
    const ParsedScene p = parse_block(
        "//! raytrace: shading=cook-torrance D=beckmann\n#declare F = finish { //! raytrace: G=smith alpha=direct\n ambient 1 }\n"
        "sphere { 0, 1 finish { F } }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.options.size(), 2u);
    EXPECT_EQ(p.scene.options[0].key, "shading");
    EXPECT_EQ(p.scene.options[0].value, "cook-torrance");
    EXPECT_EQ(p.scene.options[1].key, "D");
    const std::vector<SceneOption> in_finish = layer(p.scene.objects.at(0)).finish.options;
    ASSERT_EQ(in_finish.size(), 2u);
    EXPECT_EQ(in_finish[1].key, "alpha");
    EXPECT_EQ(in_finish[1].value, "direct");
    EXPECT_EQ(p.scene.sources.locate(in_finish[1].span.file, in_finish[1].span.begin).line, 2u);
}

TEST(Choices, UnknownKeysAndMalformedOnesAreErrors) {
    EXPECT_EQ(parse_block("//! raytrace: shadng=povray\n").error,
              "Unknown key 'shadng' after '//! raytrace:', known are shading, distances, precision, preset, material, diffuse, D, G, "
              "F, alpha, alpha-floor, env, env-clamp, s, eta, k, f0, exponent, sigma, fresnel-arg, half, norm, blinn-power, units, dw, "
              "denominator, raw, ambient, attenuate-ambient, clamp, phong-gate, gooch, att, att-coefficients, range, spot, edges, "
              "edge-width, edge-color, edge-angle");
    EXPECT_EQ(parse_block("//! raytrace: D\n").error, "Expected 'key=value' after '//! raytrace:', 'D' found instead");
    EXPECT_EQ(parse_block("//! raytrace: D=\n").error, "Expected 'key=value' after '//! raytrace:', 'D=' found instead");
    EXPECT_EQ(parse_block("//! raytrace: precision=fast distances=scaled F=schlick\n").error, "");
}

}  // namespace
}  // namespace rt::blocks_finish_test
