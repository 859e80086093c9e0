// Lights with objects: looks_like, projected_through, light_group.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_light_objects_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string error_of(const std::string& text) { return parse_block(text).error; }
Vec3 place_of(const Object& object) { return object.transform ? object.transform->offset : Vec3(0.0); }

TEST(LooksLike, StandsWhereTheLightIsAndCastsNoShadow) {
    const ParsedScene p = parse_block("light_source { y, rgb 1 translate 2*x looks_like { sphere { 0, 1 } translate z } translate 10*y }");
    ASSERT_EQ(p.error, "");
    EXPECT_THAT(p.messages, IsEmpty());
    ASSERT_EQ(p.scene.objects.size(), 1u);
    EXPECT_EQ(p.scene.lights.at(0).location, Vec3(2, 11, 0));
    EXPECT_EQ(place_of(p.scene.objects[0]), Vec3(2, 11, 1));
    EXPECT_TRUE(p.scene.objects[0].no_shadow);
    EXPECT_EQ(place_of(parse_block("light_source { x, rgb 1 looks_like { sphere { 0, 1 scale 3 } scale 2 } }").scene.objects.at(0)),
              Vec3(2, 0, 0))
        << "what modifies it comes after it was moved";
    EXPECT_THAT(p.scene.sets, IsEmpty());
}

TEST(LooksLike, MovesWithItsLight) {
    const ParsedScene p = parse_block(
        "#declare L = light_source { 0, rgb 1 looks_like { union { sphere { 0, 1 } box { 0, 1 } pigment { rgb 0.5 } } } } "
        "light_source { L translate x } object { L translate y } union { object { L } sphere { 0, 1 } translate z }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.lights.size(), 3u);
    ASSERT_EQ(p.scene.objects.size(), 7u);
    EXPECT_EQ(p.scene.lights[0].location, Vec3(1, 0, 0));
    EXPECT_EQ(place_of(p.scene.objects[1]), Vec3(1, 0, 0));
    EXPECT_EQ(color_of(p.scene.objects[1]).rgb, Rgb(0.5));
    EXPECT_EQ(place_of(p.scene.objects[2]), Vec3(0, 1, 0));
    EXPECT_EQ(p.scene.lights[2].location, Vec3(0, 0, 1));
    EXPECT_EQ(place_of(p.scene.objects[5]), Vec3(0, 0, 1));
    EXPECT_TRUE(p.scene.objects[5].no_shadow);
    EXPECT_FALSE(p.scene.objects[6].no_shadow);
}

TEST(LooksLike, IsTexturedByWhatItsLightIsIn) {
    const ParsedScene p = parse_block("union { light_source { 0, rgb 1 looks_like { sphere { 0, 1 } } } pigment { rgb 0.25 } }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(color_of(p.scene.objects.at(0)).rgb, Rgb(0.25));
}

TEST(LooksLike, IsLitByTheWholeSceneAndItsGroup) {
    const ParsedScene p = parse_block(
        "light_group { light_source { 0, rgb 1 looks_like { sphere { 0, 1 } } } box { 0, 1 } } light_group { sphere { 0, 1 } }");
    ASSERT_EQ(p.error, "");
    EXPECT_TRUE(p.scene.objects.at(0).light_group == 1 && !p.scene.objects[0].own_lights_only);
    EXPECT_TRUE(p.scene.objects.at(1).light_group == 1 && p.scene.objects[1].own_lights_only);
    EXPECT_EQ(p.scene.objects.at(2).light_group, 2u);
    EXPECT_EQ(p.scene.lights.at(0).group, 1u);
}

TEST(LooksLike, CanBeALightGroup) {
    const ParsedScene p =
        parse_block("light_source { 0, rgb 1 looks_like { light_group { light_source { x, rgb 0.5 } sphere { 0, 1 } } } }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.lights.size(), 2u);
    EXPECT_TRUE(p.scene.lights[0].group == 1 && p.scene.lights[1].group == 0);
    EXPECT_TRUE(p.scene.objects.at(0).light_group == 1 && p.scene.objects[0].own_lights_only);
}

TEST(LooksLike, ItsLightsNameStandsForBoth) {
    const ParsedScene p = parse_block(
        "#declare L = light_source { 0, rgb 1 looks_like { sphere { 0, 1 } } } light_source { L pigment { rgb 0.25 } } "
        "#declare S = sphere { 0, 1 pigment { rgb 0.5 } } light_source { S }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(p.scene.lights.size(), 1u);
    EXPECT_EQ(color_of(p.scene.objects.at(0)).rgb, Rgb(0.25));
    EXPECT_EQ(color_of(p.scene.objects.at(1)).rgb, Rgb(0.5));
}

TEST(LooksLike, Mistakes) {
    EXPECT_EQ(error_of("light_source { 0, rgb 1 looks_like { sphere { 0, 1 } } looks_like { sphere { 0, 1 } } }"),
              "Only one looks_like allowed per light_source.");
    EXPECT_EQ(error_of("light_source { 0, rgb 1 looks_like { } }"), "Expected 'object', } found instead");
    EXPECT_EQ(error_of("light_source { 0, rgb 1 looks_like { sphere { 0, 1 } sphere { 0, 1 } } }"),
              "No matching } in 'looks_like', sphere found instead");
}

TEST(ProjectedThrough, KeepsItsObjectsOutOfSight) {
    const ParsedScene p = parse_block(
        "sphere { 0, 1 } union { light_source { 0, rgb 1 projected_through { difference { box { -1, 1 } sphere { 0, 1 } } scale 2 } "
        "looks_like { sphere { 0, 0.1 } } } box { 0, 1 } }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(p.scene.objects.size(), 3u);
    EXPECT_THAT(p.scene.sets, IsEmpty());
    ASSERT_TRUE(p.scene.lights.at(0).mask);
    const Mask& mask = **p.scene.lights[0].mask;
    ASSERT_EQ(mask.surfaces.size(), 2u);
    for (const Solid& surface : mask.surfaces) EXPECT_EQ(surface.transform->linear[0][0], 2.0);
    EXPECT_TRUE(!mask.surfaces[0].inverse && mask.surfaces[1].inverse);
    ASSERT_EQ(mask.sets.size(), 1u);
    EXPECT_EQ(mask.sets[0].nodes.size(), 3u);
}

TEST(ProjectedThrough, MovesWithItsLight) {
    const ParsedScene p = parse_block(
        "#declare L = light_source { 0, rgb 1 projected_through { sphere { 0, 1 clipped_by { plane { y, 0 } } } } translate x } "
        "light_source { L } object { L translate y } union { object { L } sphere { 0, 1 } translate z }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.lights.size(), 3u);
    const Vec3 offsets[] = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(p.scene.lights[i].mask);
        const Mask& mask = **p.scene.lights[i].mask;
        EXPECT_EQ(mask.surfaces.at(0).transform->offset, offsets[i]);
        EXPECT_EQ(mask.sets.at(0).solids.at(0).transform->offset, offsets[i]) << "what clips it";
    }
}

TEST(ProjectedThrough, NothingLetsNoLightThrough) {
    const ParsedScene p = parse_block("light_source { 0, rgb 1 projected_through { light_source { 0, rgb 1 } } }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.lights.size(), 1u);
    EXPECT_EQ(p.scene.lights[0].mask, Mask{});
}

TEST(ProjectedThrough, TakesWhatTheObjectCannotHave) {
    EXPECT_THAT(
        parse_block("light_source { 0, rgb 1 projected_through { sphere { 0, 1 pigment { rgb 1 } } interior { ior 2 } } }").messages,
        ElementsAre(HasSubstr("Projected through objects can not have texture, texture removed."),
                    HasSubstr("Projected through objects can not have interior, interior removed.")));
    EXPECT_EQ(error_of("light_source { 0, rgb 1 projected_through { sphere { 0, 1 } } projected_through { sphere { 0, 1 } } }"),
              "Only one projected through allowed per light_source.");
}

TEST(ProjectedThrough, TakesNoPartInTheSetsOfItsLight) {
    for (const std::string set : {"union", "intersection", "difference", "merge"}) {
        const ParsedScene p =
            parse_block(set + " { sphere { 0, 1 } box { 0, 1 } light_source { 0, rgb 1 projected_through { sphere { 0, 1 } } } }");
        EXPECT_EQ(p.error, "") << set;
        EXPECT_EQ(p.scene.objects.size(), 2u) << set;
        EXPECT_EQ((*p.scene.lights.at(0).mask)->surfaces.size(), 1u) << set;
    }
}

TEST(ProjectedThrough, IsCountedWithTheSetsThatItsLightIsIn) {
    ParseOptions options;
    options.max_set_parts = 100;
    const std::string light =
        "#declare L = light_source { 0, rgb 1 projected_through { union { #for (I, 1, 30) sphere { I, 1 } #end } } } ";
    EXPECT_EQ(parse_block(light + "light_source { L }", options).error, "");
    EXPECT_THROW(
        parse_text({"t.pov", light + "union { light_source { L } light_source { L translate x } }"}, options, [](std::string_view) {}),
        LimitError);
}

TEST(LightGroup, KeepsLightsAndObjectsTogether) {
    const ParsedScene p = parse_block(
        "light_source { 0, rgb 1 } light_group { light_source { x, rgb 1 } sphere { 0, 1 } translate y global_lights on } "
        "light_group { light_source { x, rgb 1 } box { 0, 1 } } sphere { 0, 1 }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(p.scene.light_groups, 2u);
    ASSERT_EQ(p.scene.objects.size(), 3u);
    const auto group_of = [&](std::size_t i) { return p.scene.objects[i].light_group; };
    EXPECT_TRUE(group_of(0) == 1 && group_of(1) == 2 && group_of(2) == 0);
    EXPECT_TRUE(!p.scene.objects[0].own_lights_only && p.scene.objects[1].own_lights_only && !p.scene.objects[2].own_lights_only);
    EXPECT_TRUE(p.scene.lights[0].group == 0 && p.scene.lights[1].group == 1 && p.scene.lights[2].group == 2);
    EXPECT_EQ(p.scene.lights[1].location, Vec3(1, 1, 0));
    EXPECT_EQ(place_of(p.scene.objects[0]), Vec3(0, 1, 0));
}

TEST(LightGroup, LightsInItsUnionsShineOnTheWholeScene) {
    const ParsedScene p = parse_block(
        "light_group { light_source { 0, rgb 1 looks_like { sphere { 0, 1 } } } union { light_source { x, rgb 1 } box { 0, 1 } } "
        "object { light_source { y, rgb 1 } } }");
    ASSERT_EQ(p.error, "");
    EXPECT_TRUE(p.scene.lights.at(0).group == 1 && p.scene.lights.at(1).group == 0 && p.scene.lights.at(2).group == 1);
    EXPECT_EQ(p.scene.objects.at(1).light_group, 1u);
}

TEST(LightGroup, CopiesAreGroupsOfTheirOwn) {
    const ParsedScene p = parse_block(
        "#declare G = light_group { light_source { x, rgb 1 } sphere { 0, 1 } light_group { light_source { y, rgb 1 } box { 0, 1 } } } "
        "union { object { G } object { G translate x } } G");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(p.scene.light_groups, 6u);
    const auto group_of = [&](std::size_t i) { return p.scene.objects.at(i).light_group; };
    // The inner one comes first.
    EXPECT_TRUE(group_of(0) == 2 && group_of(1) == 1 && group_of(2) == 4 && group_of(3) == 3 && group_of(4) == 6 && group_of(5) == 5);
}

TEST(LightGroup, ManyInEachOtherAreOneSet) {
    const ParsedScene p = parse_block(
        "#declare G = sphere { 0, 1 } #for (I, 1, 3000) #declare G = light_group { object { G } light_source { 0, rgb 1 } } #end "
        "intersection { object { G } sphere { x, 1 } }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(p.scene.light_groups, 3000u);
    EXPECT_EQ(p.scene.objects.at(0).light_group, 1u);
    EXPECT_LT(p.scene.sets.size(), 4u);
}

TEST(LightGroup, TheOutermostDecidesAboutGlobalLights) {
    const auto own_only = [](const std::string& inner, const std::string& outer) {
        return parse_block("light_group { light_group { sphere { 0, 1 } " + inner + " } " + outer + " }")
            .scene.objects.at(0)
            .own_lights_only;
    };
    EXPECT_FALSE(own_only("", "global_lights on"));
    EXPECT_TRUE(own_only("global_lights on", ""));
    EXPECT_TRUE(own_only("global_lights on", "global_lights off"));
}

TEST(LightGroup, TakesNothingElse) {
    EXPECT_EQ(error_of("light_group { } light_group { sphere { 0, 1 } } light_group { light_source { 0, rgb 1 } }"), "");
    EXPECT_EQ(error_of("light_group { sphere { 0, 1 } texture { } }"), "No matching } in 'light_group', texture found instead");
    EXPECT_EQ(error_of("light_group { global_lights sphere { 0, 1 } }"), "No matching } in 'light_group', sphere found instead");
    EXPECT_EQ(error_of("light_group { sphere { 0, 1 } no_shadow }"), "No matching } in 'light_group', no_shadow found instead");
    EXPECT_EQ(error_of("sphere { 0, 1 global_lights on }"), "No matching } in 'sphere', global_lights found instead");
    EXPECT_EQ(error_of("light_source { 0, rgb 1 global_lights on }"), "No matching } in 'light_source', global_lights found instead");
}

}  // namespace
}  // namespace rt::blocks_light_objects_test
