// The rules that name a difference, one by one, and the order in which differences are found.
#include "grading/explain.h"

#include <gtest/gtest.h>

#include <limits>

#include "grading/explain_rules.h"

namespace rt::explain_test {
namespace {

constexpr double tolerance = 1e-4;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ExplainRules, NumbersAreTheSameWithinTheTolerance) {
    EXPECT_TRUE(rules::same(0.1234, 0.1235, tolerance));  // roundings of 0.12345 -+ nothing
    EXPECT_FALSE(rules::same(0.1234, 0.1236, tolerance));
    EXPECT_TRUE(rules::same(20000.0, 20001.0, tolerance));
    EXPECT_FALSE(rules::same(20000.0, 20003.0, tolerance));
    EXPECT_TRUE(rules::same(nan, nan, tolerance));
    EXPECT_FALSE(rules::same(nan, 0.0, tolerance));
    EXPECT_TRUE(rules::same(infinity, infinity, tolerance));
    EXPECT_FALSE(rules::same(infinity, -infinity, tolerance));
    EXPECT_FALSE(rules::same(infinity, 1e300, tolerance));
}

TEST(ExplainRules, NormalsAreScaledTurnedOrOthers) {
    const Vec3 n = unit(Vec3(1, 2, -2));
    EXPECT_EQ(rules::normal(n, 3.0 * n, tolerance), Cause::missing_normalisation);
    EXPECT_EQ(rules::normal(n, -n, tolerance), Cause::wrong_normal_side);
    EXPECT_EQ(rules::normal(n, -2.0 * n, tolerance), Cause::wrong_normal_side);
    EXPECT_EQ(rules::normal(n, Vec3(0, 1, 0), tolerance), Cause::wrong_normal);
    EXPECT_EQ(rules::normal(n, Vec3(0.0), tolerance), Cause::wrong_normal);
}

TEST(ExplainRules, CameraRaysWithoutACameraAreToldByTheirSigns) {
    const Vec3 d = unit(Vec3(0.3, 0.2, -1));
    EXPECT_EQ(rules::camera_direction(d, {-d.x, d.y, d.z}, nullptr, 1.0, tolerance), Cause::mirrored);
    EXPECT_EQ(rules::camera_direction(d, {d.x, d.y, -d.z}, nullptr, 1.0, tolerance), Cause::mirrored);
    EXPECT_EQ(rules::camera_direction(d, {d.x, -d.y, d.z}, nullptr, 1.0, tolerance), Cause::upside_down);
    EXPECT_EQ(rules::camera_direction(d, {d.y, d.x, d.z}, nullptr, 1.0, tolerance), Cause::camera);
    const ToldCamera flat{d, {0, 0, 0}, {0, 1, 0}, 8, 8};
    EXPECT_EQ(rules::camera_direction(d, {d.y, d.x, d.z}, &flat, 1.0, tolerance), Cause::camera);
}

TEST(ExplainRules, BentRaysStayInThePlaneOfIncidence) {
    const Vec3 n(0, 1, 0), d = unit(Vec3(1, -1, 0)), bent = unit(Vec3(0.5, -1, 0)), more = unit(Vec3(0.2, -1, 0));
    EXPECT_EQ(rules::direction(ToldRay::Kind::refraction, bent, more, d, n, tolerance), Cause::wrong_refraction_ratio);
    EXPECT_EQ(rules::direction(ToldRay::Kind::refraction, bent, unit(Vec3(0.5, -1, 1)), d, n, tolerance), Cause::other);
    EXPECT_EQ(rules::direction(ToldRay::Kind::refraction, bent, 2.0 * bent, d, n, tolerance), Cause::missing_normalisation);
    EXPECT_EQ(rules::direction(ToldRay::Kind::reflection, unit(Vec3(1, 1, 0)), d, d, n, tolerance), Cause::wrong_mirror_direction);
}

TEST(ExplainRules, SharesTellFilterFresnelAndMirror) {
    const ToldRay::Shares a{0.2, 0.1, 0.7};
    EXPECT_EQ(rules::shares(a, {0.9, 0.1, 0.0}, tolerance), Cause::missing_filter);
    EXPECT_EQ(rules::shares(a, {0.2, 0.05, 0.75}, tolerance), Cause::missing_fresnel);
    EXPECT_EQ(rules::shares(a, {0.2, 0.15, 0.65}, tolerance), Cause::missing_fresnel);
    EXPECT_EQ(rules::shares(a, {0.2, 0.8, 0.0}, tolerance), Cause::total_reflection);
    EXPECT_EQ(rules::shares(a, {0.3, 0.0, 0.7}, tolerance), Cause::missing_reflection);
    EXPECT_EQ(rules::shares(a, {1.0, 0.1, 0.7}, tolerance), Cause::wrong_share);
}

TEST(ExplainRules, FurtherRaysEndByDepthOrByTheSurface) {
    EXPECT_EQ(rules::further_ray(ToldRay::Kind::reflection, true, true), Cause::depth);
    EXPECT_EQ(rules::further_ray(ToldRay::Kind::reflection, true, false), Cause::missing_reflection);
    EXPECT_EQ(rules::further_ray(ToldRay::Kind::refraction, true, false), Cause::missing_filter);
    EXPECT_EQ(rules::further_ray(ToldRay::Kind::reflection, false, false), Cause::wrong_share);
}

TEST(ExplainRules, ShadowsAreMissingFalseOrWithoutTheFilter) {
    const ToldShadow lit, dark{0, 0, Rgb(0.0)}, tinted{0, 0, Rgb(0.5, 0.25, 1.0), true}, clear{0, 0, Rgb(1.0), true};
    EXPECT_EQ(rules::shadow(dark, lit), Cause::missing_shadow);
    EXPECT_EQ(rules::shadow(lit, dark), Cause::false_shadow);
    EXPECT_EQ(rules::shadow(tinted, lit), Cause::missing_shadow);
    EXPECT_EQ(rules::shadow(tinted, {0, 0, Rgb(0.5), true}), Cause::missing_filter);
    EXPECT_EQ(rules::shadow(tinted, dark), Cause::missing_filter);
    EXPECT_EQ(rules::shadow(clear, dark), Cause::missing_filter);
    EXPECT_EQ(rules::shadow(dark, tinted), Cause::missing_shadow);
}

TEST(ExplainRules, BytesTellGammaAndRounding) {
    EXPECT_EQ(rules::color({64, 128, 200}, {136, 186, 229}), Cause::gamma);  // 255 (c / 255)^(1 / 2.2)
    EXPECT_EQ(rules::color({136, 186, 229}, {64, 128, 200}), Cause::gamma);
    EXPECT_EQ(rules::color({64, 128, 200}, {63, 128, 199}), Cause::rounding);
    EXPECT_EQ(rules::color({64, 128, 200}, {200, 128, 64}), Cause::other);
}

ToldRay surface(const Vec3& point) {
    ToldRay ray;
    ray.ray = {{0, 0, 4}, {0, 0, -1}};
    ray.end = ToldRay::End::surface;
    ray.hit.emplace();
    ray.hit->object = 1;
    ray.hit->point = point;
    ray.hit->normal = Vec3(0, 0, 1);
    for (std::optional<Rgb>& part : ray.light) part = Rgb(0.25);
    return ray;
}

TEST(ExplainRules, HalfAPixelIsOfThePixelOrOfItsPart) {
    const ToldCamera camera{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 10, 10};
    const Vec3 d(0.2, 0.1, 1), half(0.25, 0.15, 1), quarter(0.225, 0.1, 1);
    EXPECT_EQ(rules::camera_direction(d, half, &camera, 1.0, tolerance), Cause::half_pixel);
    EXPECT_EQ(rules::camera_direction(d, half, &camera, 2.0, tolerance), Cause::half_pixel);
    EXPECT_EQ(rules::camera_direction(d, quarter, &camera, 2.0, tolerance), Cause::half_pixel);
    EXPECT_EQ(rules::camera_direction(d, quarter, &camera, 1.0, tolerance), Cause::camera);
}

TEST(ExplainRules, DistancesOfObjectSpaceMoveTheHitOrBringAnotherObjectToTheFront) {
    ToldRay a = surface({0, 0, 2}), b = a;
    a.hit->t = 2.0, a.hit->object_ray = Ray{{0, 0, 0}, {0, 0, -1.5}};
    b.hit->t = 3.0;
    EXPECT_EQ(rules::hit(a, b, nullptr, tolerance), Cause::object_space_distance);
    b.hit->t = 3.2, b.hit->point = {0, 0, 0.8};
    EXPECT_EQ(rules::hit(a, b, nullptr, tolerance), Cause::placement);
    b.hit->object = 2, b.hit->t = 2.5;  // farther than 2, nearer than 3
    EXPECT_EQ(rules::hit(a, b, nullptr, tolerance), Cause::object_space_distance);
    b.hit->t = 3.5;
    EXPECT_EQ(rules::hit(a, b, nullptr, tolerance), Cause::wrong_object);
}

TEST(ExplainRules, OnlyARatioThatCanReflectTotallyIsSuspectedOfIt) {
    ToldRay incident = surface({0, 0, 0}), passing;
    incident.ray.direction = {0.6, 0, -0.8};
    passing.ray.direction = {0.4, 0, -std::sqrt(0.84)};  // sines 0.6 to 0.4, inverse 0.6 to 0.9
    EXPECT_FALSE(rules::inverse_ratio_is_total(incident, passing, tolerance));
    passing.ray.direction = {0.3, 0, -std::sqrt(0.91)};  // inverse 0.6 to 1.2
    EXPECT_TRUE(rules::inverse_ratio_is_total(incident, passing, tolerance));
    incident.hit->normal.reset();
    EXPECT_TRUE(rules::inverse_ratio_is_total(incident, passing, tolerance));
}

TEST(ExplainRules, ASurfaceThatShadowsItselfHidesAllLamps) {
    const ToldShadow one, other{1, 0, Rgb(1.0), {}, {}}, no_one{0, 0, Rgb(0.0), {}, {}}, no_other{1, 0, Rgb(0.0), {}, {}};
    EXPECT_TRUE(rules::hides_all({one, other}, {no_one, no_other}));
    EXPECT_FALSE(rules::hides_all({one, other}, {no_one, other}));
    EXPECT_FALSE(rules::hides_all({one}, {no_one}));  // anything may do that
    EXPECT_FALSE(rules::hides_all({one, no_other}, {no_one, no_other}));
}

TEST(ExplainRules, AHighlightIsMissingWhereItIsNoneExactly) {
    ToldRay a = surface({0, 0, 0}), b = a;
    a.part(LightPart::specular) = Rgb(0.002), b.part(LightPart::specular) = Rgb(0.0);
    EXPECT_EQ(rules::local_light(LightPart::specular, a, b, false, tolerance), Cause::missing_highlight);
    EXPECT_EQ(rules::local_light(LightPart::specular, a, b, true, tolerance), Cause::wrong_exponent);
    a.part(LightPart::specular) = Rgb(0.2);
    EXPECT_EQ(rules::local_light(LightPart::specular, a, b, true, tolerance), Cause::missing_highlight);
}

TEST(ExplainRules, WhatOneTellsOfItsLampsBoundsWhatTheOtherCanHave) {
    const ToldShadow lit, hidden{1, 0, Rgb(0.0), {}, {}}, other{1, 0, Rgb(1.0), {}, {}};
    ToldRay a = surface({0, 0, 0}), b = a;
    const auto diffuse = [&](const std::vector<ToldShadow>& lamps, const Rgb& of_b) {
        a.hit->shadows = lamps;
        b.part(LightPart::diffuse) = of_b;
        return rules::local_light(LightPart::diffuse, a, b, true, tolerance);
    };
    const Rgb brighter(0.5, 0.3, 0.3), darker(0.1, 0.2, 0.2);
    EXPECT_EQ(diffuse({lit, hidden}, brighter), Cause::missing_shadow);
    EXPECT_EQ(diffuse({lit, other}, brighter), Cause::wrong_diffuse);
    EXPECT_EQ(diffuse({lit, other}, darker), Cause::missing_light);
    EXPECT_EQ(diffuse({lit, hidden}, darker), Cause::wrong_diffuse);
    EXPECT_EQ(diffuse({lit}, Rgb(0.0)), Cause::wrong_diffuse);  // the highlight is there
    b.part(LightPart::specular) = Rgb(0.0);
    EXPECT_EQ(diffuse({lit}, Rgb(0.0)), Cause::false_shadow);
    b.hit->shadows = std::vector<ToldShadow>{lit};
    EXPECT_EQ(diffuse({lit}, Rgb(0.0)), Cause::wrong_diffuse);
}

class Order : public testing::Test {
protected:
    Order() {
        ToldRay further = surface({0, 1, 0});
        further.parent = 0, further.kind = ToldRay::Kind::reflection;
        a.samples = {{surface({0, 0, 1}), further}};
        b = a;
    }
    std::string first() const {
        const std::optional<Divergence> found = first_divergence(a, b, tolerance);
        return found ? found->field + (found->ray_b == ToldRay::none ? "" : found->ray_b == 0 ? " 0" : " 1") : "";
    }
    ToldPixel a, b;
};

TEST_F(Order, OwnFieldsThenFurtherRaysThenSumsThenThePixel) {
    EXPECT_EQ(first(), "");
    b.color[0] = 9;
    EXPECT_EQ(first(), "colour of the pixel");
    std::vector<ToldRay>& rays = b.samples[0];
    rays[0].part(LightPart::radiance) = Rgb(0.5);
    EXPECT_EQ(first(), "radiance 0");
    rays[0].part(LightPart::reflection) = Rgb(0.5);
    EXPECT_EQ(first(), "reflection 0");
    rays[1].part(LightPart::radiance) = Rgb(0.5);
    EXPECT_EQ(first(), "radiance 1");
    rays[1].hit->normal = Vec3(0, 1, 0);
    EXPECT_EQ(first(), "normal 1");
    rays[0].part(LightPart::specular) = Rgb(0.5);
    EXPECT_EQ(first(), "specular 0");
    rays[0].part(LightPart::ambient) = Rgb(0.5);
    EXPECT_EQ(first(), "ambient 0");
    rays[0].hit->normal = Vec3(0, 1, 0);
    EXPECT_EQ(first(), "normal 0");
    rays[0].hit->object = 2;
    EXPECT_EQ(first(), "what it meets 0");
    rays[0].ray.origin = Vec3(1, 0, 0);
    EXPECT_EQ(first(), "origin 0");
}

TEST_F(Order, WhatOneLeavesOutIsNotCompared) {
    for (ToldRay& ray : b.samples[0]) {
        ray.light = {};
        ray.hit->normal.reset();
    }
    EXPECT_EQ(first(), "");
}

TEST_F(Order, LightOfALeavingRayThatIsNotToldOfIsTheBackgrounds) {
    for (ToldPixel* pixel : {&a, &b}) {
        ToldRay& leaving = pixel->samples[0][1];
        leaving.hit.reset(), leaving.light = {}, leaving.end = ToldRay::End::background;
    }
    b.samples[0][0].part(LightPart::reflection) = Rgb(0.125);
    EXPECT_EQ(first(), "reflection 0");
    EXPECT_EQ(first_divergence(a, b, tolerance)->cause, Cause::background);
}

TEST_F(Order, RowsCountedFromOtherEndsAreNotCompared) {
    b.y = 7;
    EXPECT_EQ(first(), "place of the pixel");
    b.from_top = true;
    EXPECT_EQ(first(), "");
}

TEST(Causes, AllHaveWords) {
    for (int i = 0; i <= static_cast<int>(Cause::rounding); ++i) {
        EXPECT_GE(name_of(static_cast<Cause>(i)).size(), 5u);
        EXPECT_TRUE(meaning_of(static_cast<Cause>(i)).ends_with('.')) << i;
    }
}

/// A record may be any number of rays deep, on any stack: each further ray is the only one of the ray before it.
TEST(Explain, RecordsOfManyRaysInARowAreWalked) {
    ToldPixel a;
    std::vector<ToldRay> rays(300'000);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].kind = i == 0 ? ToldRay::Kind::camera : ToldRay::Kind::refraction;
        rays[i].parent = i == 0 ? ToldRay::none : i - 1;
        rays[i].hit.emplace();
    }
    a.samples = {rays};
    ToldPixel b = a;
    EXPECT_EQ(first_divergence(a, b, tolerance), std::nullopt);
    b.samples[0].back().hit->object = 7;
    const std::optional<Divergence> found = first_divergence(a, b, tolerance);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->ray_a, rays.size() - 1);
}

}  // namespace
}  // namespace rt::explain_test
