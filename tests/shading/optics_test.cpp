// Mirror, Snell, Fresnel and fading light against closed forms and independent formulas.
#include "shading/optics.h"

#include <gtest/gtest.h>

#include <limits>

namespace rt::optics_test {
namespace {

Vec3 incoming(double degrees) { return {std::sin(radians(degrees)), -std::cos(radians(degrees)), 0.0}; }
const Vec3 n(0, 1, 0);

TEST(Reflect, mirrors_the_component_along_the_normal) {
    const Vec3 r = reflect(Vec3(0.6, -0.8, 0.0), n);
    EXPECT_DOUBLE_EQ(r.x, 0.6);
    EXPECT_DOUBLE_EQ(r.y, 0.8);
    EXPECT_EQ(r.z, 0.0);
}

TEST(Refract, obeys_snell) {
    for (const double ratio : {1 / 1.5, 1.5, 0.9, 1 / 2.4}) {
        for (const double degrees : {0.0, 10.0, 30.0, 41.0}) {
            const Vec3 d = incoming(degrees);
            const Refraction r = refract(d, n, ratio);
            ASSERT_FALSE(r.total);
            EXPECT_NEAR(length(r.direction), 1.0, 1e-15);
            EXPECT_NEAR(r.direction.x, ratio * std::sin(radians(degrees)), 1e-15);
            EXPECT_LT(r.direction.y, 0.0);
        }
    }
}

TEST(Refract, total_reflection_begins_at_the_critical_angle) {
    const double critical = std::asin(1 / 1.5) * 180 / pi;
    EXPECT_FALSE(refract(incoming(critical - 1e-6), n, 1.5).total);
    EXPECT_TRUE(refract(incoming(critical + 1e-6), n, 1.5).total);
}

TEST(Refract, equal_indices_keep_the_very_direction) {
    const Vec3 d = incoming(33.0);
    const Refraction r = refract(d, n, 1.0 + 5e-11);
    EXPECT_TRUE(r.straight);
    EXPECT_EQ(r.direction, d);
}

/// Average of the squared amplitudes of the two polarisations, in long double.
double fresnel_by_polarisation(long double eta, long double cos) {
    const long double sin_t = std::sqrt(1 - cos * cos) / eta;
    if (sin_t >= 1) return 1.0;
    const long double cos_t = std::sqrt(1 - sin_t * sin_t);
    const long double s = (cos - eta * cos_t) / (cos + eta * cos_t), p = (eta * cos - cos_t) / (eta * cos + cos_t);
    return static_cast<double>((s * s + p * p) / 2);
}

TEST(FresnelReflectance, equals_the_mean_of_both_polarisations) {
    for (const double eta : {1.01, 1.33, 1.5, 2.42, 1 / 1.5, 0.75}) {
        for (double cos = 0.01; cos <= 1.0; cos += 0.01) {
            EXPECT_NEAR(fresnel_reflectance(eta, cos), fresnel_by_polarisation(eta, cos), 2e-13) << eta << " " << cos;
        }
    }
    EXPECT_NEAR(fresnel_reflectance(1.5, 1.0), 0.04, 1e-15);
}

TEST(FresnelReflectance, stays_in_0_to_1_for_any_index) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double eta : {0.0, -1.0, 1.0, 1e-200, 1e200, std::numeric_limits<double>::infinity(), nan}) {
        for (const double cos : {0.0, 0.5, 1.0}) {
            const double f = fresnel_reflectance(eta, cos);
            EXPECT_TRUE(f >= 0.0 && f <= 1.0) << eta << " " << cos << " " << f;
        }
    }
    EXPECT_EQ(fresnel_reflectance(1.0, 0.5), 0.0);
}

TEST(DistanceFade, halves_at_the_stated_distance_and_follows_beer_from_1000) {
    EXPECT_EQ(distance_fade(3.0, 3.0, 2.0, Rgb(0.0)), Rgb(0.5));
    EXPECT_EQ(distance_fade(3.0, 3.0, 0.0, Rgb(0.0)), Rgb(0.5));
    EXPECT_EQ(distance_fade(6.0, 3.0, 2.0, Rgb(0.0)), Rgb(0.2));
    EXPECT_DOUBLE_EQ(distance_fade(6.0, 3.0, 1.0, Rgb(0.4)).g, 0.4 + 0.6 / 3);
    EXPECT_DOUBLE_EQ(distance_fade(6.0, 3.0, 1000.0, Rgb(0.25)).b, std::exp(-1.5));
    EXPECT_EQ(distance_fade(6.0, 0.0, 1000.0, Rgb(0.25)), Rgb(1.0));
    EXPECT_EQ(distance_fade(0.0, 1.0, 0.0, Rgb(1.0)), Rgb(1.0));
}

}  // namespace
}  // namespace rt::optics_test
