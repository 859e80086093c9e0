#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_light_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ParsedScene with_light(const std::string& body) { return parse_block("light_source { " + body + " }"); }
Light light(const std::string& body) { return with_light(body).scene.lights.at(0); }

TEST(LightBlock, PointLightHasDefaults) {
    const Light l = light("<1,2,3>, rgb <0.9,0.8,0.7>");
    EXPECT_EQ(l.type, Light::Type::point);
    EXPECT_EQ(l.location, Vec3(1, 2, 3));
    EXPECT_EQ(l.color, Rgb(0.9, 0.8, 0.7));
    EXPECT_EQ(l.point_at, Vec3(0, 0, 1));
    EXPECT_FALSE(l.parallel || l.shadowless || l.area);
    EXPECT_EQ(l.fade_distance, 0.0);
    EXPECT_EQ(l.fade_power, 0.0);
}

TEST(LightBlock, ColourFormsAndNone) {
    EXPECT_EQ(light("0 <1,2,3>").color, Rgb(1, 2, 3));
    EXPECT_EQ(light("0, 0.5").color, Rgb(0.5));
    EXPECT_EQ(light("0 color red 0.5 blue 1").color, Rgb(0.5, 0, 1));
    EXPECT_EQ(light("0 -0.2").color, Rgb(0.0));  // a subtraction, as POV-Ray reads it
    EXPECT_EQ(light("0, -0.2").color, Rgb(-0.2));
    EXPECT_EQ(light("0,").color, Rgb(0.0));
}

TEST(LightBlock, WarnsOfFilterAndTransmit) {
    EXPECT_THAT(with_light("0 rgbf 1").messages, ElementsAre(HasSubstr("unexpected filter component will have no effect.")));
    EXPECT_THAT(with_light("0 rgbt 1").messages, ElementsAre(HasSubstr("unexpected transmit component will have no effect.")));
    EXPECT_THAT(with_light("0 rgbft 1").messages, ElementsAre(HasSubstr("unexpected filter and transmit components will")));
    EXPECT_THAT(with_light("0 <1,1,1,1>").messages, ElementsAre(HasSubstr("unexpected filter and transmit components will")));
    EXPECT_THAT(with_light("0 rgb 1 transmit 1").messages, ElementsAre(HasSubstr("unexpected transmit component will")));
    EXPECT_THAT(with_light("0 rgbf <1,1,1,0>").messages, IsEmpty());
}

TEST(LightBlock, SpotlightAndCylinderHaveTheirOwnDefaults) {
    const Light spot = light("0 rgb 1 spotlight");
    EXPECT_EQ(spot.type, Light::Type::spotlight);
    EXPECT_EQ(spot.radius, 30.0);
    EXPECT_EQ(spot.falloff, 45.0);
    EXPECT_EQ(spot.tightness, 0.0);
    const Light cylinder = light("0 rgb 1 cylinder");
    EXPECT_EQ(cylinder.type, Light::Type::cylinder);
    EXPECT_EQ(cylinder.radius, 0.75);
    EXPECT_EQ(cylinder.falloff, 1.0);
    EXPECT_EQ(cylinder.tightness, 0.0);
}

TEST(LightBlock, ConeKeywordsFollowTheirTypeAndTheTypeResetsThem) {
    const Light l = light("0 rgb 1 spotlight radius 8 falloff 20 tightness 3 point_at <1,0,0>");
    EXPECT_EQ(l.radius, 8.0);
    EXPECT_EQ(l.falloff, 20.0);
    EXPECT_EQ(l.tightness, 3.0);
    EXPECT_EQ(l.point_at, Vec3(1, 0, 0));
    EXPECT_EQ(light("0 rgb 1 spotlight radius 8 point_at x cylinder").radius, 0.75);
    EXPECT_EQ(light("0 rgb 1 spotlight radius 8 point_at x cylinder").point_at, Vec3(1, 0, 0));
    EXPECT_EQ(light("0 rgb 1 spotlight tightness 8 cylinder").tightness, 0.0);
}

TEST(LightBlock, ConeKeywordsNeedATypeThatHasThem) {
    for (const char* keyword : {"radius", "falloff", "tightness", "point_at"})
        EXPECT_EQ(with_light(std::string("0 rgb 1 ") + keyword + " 1").error,
                  std::string("Keyword '") + keyword + "' cannot be used with standard light source.");
    EXPECT_EQ(with_light("0 rgb 1 parallel point_at x").error, "");
    EXPECT_EQ(with_light("0 rgb 1 parallel radius 1").error, "Keyword 'radius' cannot be used with standard light source.");
}

TEST(LightBlock, ParallelShadowlessAndFade) {
    const Light l = light("x rgb 1 parallel point_at y shadowless fade_distance 3 fade_power 2");
    EXPECT_TRUE(l.parallel);
    EXPECT_TRUE(l.shadowless);
    EXPECT_EQ(l.point_at, Vec3(0, 1, 0));
    EXPECT_EQ(l.fade_distance, 3.0);
    EXPECT_EQ(l.fade_power, 2.0);
}

TEST(LightBlock, AreaLight) {
    const Light l = light("0 rgb 1 area_light <4,0,0>, <0,3,0>, 5, 4.7 adaptive 2 circular area_illumination on");
    ASSERT_TRUE(l.area);
    EXPECT_EQ(l.area->axis1, Vec3(4, 0, 0));
    EXPECT_EQ(l.area->axis2, Vec3(0, 3, 0));
    EXPECT_EQ(l.area->size1, 5);
    EXPECT_EQ(l.area->size2, 4);
    EXPECT_EQ(l.area->adaptive, 2);
    EXPECT_TRUE(l.area->circular);
    EXPECT_FALSE(l.area->orient);
    EXPECT_TRUE(l.area->area_illumination);
    EXPECT_FALSE(light("0 rgb 1 area_light x, y, 2, 2 area_illumination off").area->area_illumination);
    EXPECT_FALSE(light("0 rgb 1 area_light x y 2 2").area->adaptive);
}

TEST(LightBlock, AreaKeywordsMayComeBeforeAreaLightAndMeanNothingAlone) {
    EXPECT_EQ(light("0 rgb 1 adaptive 3 area_light x, y, 2, 2").area->adaptive, 3);
    EXPECT_FALSE(light("0 rgb 1 adaptive 3").area);
    EXPECT_THAT(with_light("0 rgb 1 area_illumination").messages, ElementsAre(HasSubstr("Area_illumination only affects area_light")));
}

TEST(LightBlock, AreaErrorsAndWarnings) {
    EXPECT_EQ(with_light("0 rgb 1 area_light x, y, 0, 4").error, "Area size must be greater than zero.");
    EXPECT_EQ(with_light("0 rgb 1 area_light x, y, 4, 0.5").error, "Area size must be greater than zero.");
    EXPECT_EQ(with_light("0 rgb 1 area_light x, y, 1e9, 1e9").error, "Area size must be at most 4096.");
    EXPECT_EQ(with_light("0 rgb 1 area_light x, y, 1, 4 circular").error, "Circular area light must have more than 1 point per axis");
    EXPECT_THAT(with_light("0 rgb 1 area_light x, y, 3, 3 circular orient").messages, IsEmpty());
    EXPECT_THAT(with_light("0 rgb 1 area_light x, 2*y, 3, 4 orient").messages,
                ElementsAre(HasSubstr("Orient can only be used with circular area lights."), HasSubstr("must be of equal length."),
                            HasSubstr("the two sample sizes for the area light should be equal.")));
    EXPECT_TRUE(light("0 rgb 1 area_light x, y, 3, 3 orient").area->circular);
    EXPECT_FALSE(light("0 rgb 1 area_light x, y, 1, 3 orient").area->circular);
    EXPECT_THAT(with_light("0 rgb 1 area_light x, y, 3, 3 jitter").messages,
                ElementsAre(HasSubstr("Jitter of area lights is not modelled")));
}

TEST(LightBlock, TransformsActAtOnce) {
    const Light l = light("<1,0,0> rgb 1 spotlight point_at <0,1,0> area_light x, y, 2, 2 scale 2 translate z rotate 90*z");
    EXPECT_NEAR(length(l.location - Vec3(0, 2, 1)), 0.0, 1e-14);
    EXPECT_NEAR(length(l.point_at - Vec3(-2, 0, 1)), 0.0, 1e-14);
    EXPECT_NEAR(length(l.area->axis1 - Vec3(0, 2, 0)), 0.0, 1e-14);
    EXPECT_NEAR(length(l.area->axis2 - Vec3(-2, 0, 0)), 0.0, 1e-14);
    EXPECT_EQ(light("0 rgb 1 spotlight translate x point_at y").point_at, Vec3(0, 1, 0));
    EXPECT_EQ(light("0 rgb 1 translate x").point_at, Vec3(1, 0, 1));
}

TEST(LightBlock, DeclaredLights) {
    const ParsedScene p = parse_block(
        "#declare L = light_source { x rgb 1 fade_power 2 } L light_source { L translate y } object { L translate z no_shadow } object { "
        "light_source { 0 rgb 2 } }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.lights.size(), 4u);
    EXPECT_EQ(p.scene.lights[0].location, Vec3(1, 0, 0));
    EXPECT_EQ(p.scene.lights[1].location, Vec3(1, 1, 0));
    EXPECT_EQ(p.scene.lights[1].fade_power, 2.0);
    EXPECT_EQ(p.scene.lights[2].location, Vec3(1, 0, 1));
    EXPECT_EQ(p.scene.lights[3].color, Rgb(2.0));
    EXPECT_EQ(parse_block("#declare L = light_source { 0 rgb 1 } light_source { L spotlight }").error,
              "No matching } in 'light_source', spotlight found instead");
}

TEST(LightBlock, WhatIsNotModelled) {
    EXPECT_EQ(with_light("0 rgb 1 media_interaction off media_attenuation photons { reflection on }").error, "");
    EXPECT_EQ(with_light("0 rgb 1 fade_color 1").error, "No matching } in 'light_source', fade_colour found instead");
}

}  // namespace
}  // namespace rt::blocks_light_test
