// Terms of the finish against values worked out by hand.
#include "shading/povray_finish.h"

#include <gtest/gtest.h>

#include <limits>

namespace rt::povray_finish_test {
namespace {

TEST(Opacity, follows_the_language_version) {
    EXPECT_DOUBLE_EQ(opacity(Rgb(0.2, 0.5, 0.1), 0.4, 0.3, false), 0.3);
    EXPECT_DOUBLE_EQ(opacity(Rgb(0.2, 0.5, 0.1), 0.4, 0.3, true), 1 - (0.4 * 0.5 + 0.3));
    EXPECT_DOUBLE_EQ(opacity(Rgb(1.0), 1.2, 0.0, false), -0.2);
}

TEST(DiffuseCosine, takes_brilliance_as_exponent) {
    EXPECT_EQ(diffuse_cosine(0.3, 1.0), 0.3);
    EXPECT_DOUBLE_EQ(diffuse_cosine(0.5, 3.0), 0.125);
    EXPECT_EQ(diffuse_cosine(0.5, 0.0), 1.0);
}

TEST(PhongLobe, power_of_the_cosine_without_a_faint_tail) {
    EXPECT_DOUBLE_EQ(phong_lobe(0.5, 4.0), 0.0625);
    EXPECT_EQ(phong_lobe(-0.5, 2.0), 0.0);
    EXPECT_EQ(phong_lobe(0.0, 0.0), 0.0);
    EXPECT_EQ(phong_lobe(0.0008, 60.0), 0.0);
    EXPECT_GT(phong_lobe(0.0008, 59.0), 0.0);
    EXPECT_EQ(phong_lobe(1.0 + 1e-15, 1e30), 1.0);
    EXPECT_EQ(phong_lobe(std::numeric_limits<double>::quiet_NaN(), 2.0), 0.0);
}

TEST(SpecularLobe, power_of_the_half_vector_cosine) {
    EXPECT_DOUBLE_EQ(specular_lobe(0.9, 20.0), std::pow(0.9, 20.0));
    EXPECT_EQ(specular_lobe(0.9, 0.0), 1.0);
    EXPECT_EQ(specular_lobe(-0.9, 20.0), 0.0);
}

TEST(Metallic, tints_from_above_and_not_at_grazing) {
    EXPECT_EQ(metallic_fresnel(1.0), 0.0);  // the formula itself is -4e-10 there
    EXPECT_DOUBLE_EQ(metallic_fresnel(std::cos(0.25 * pi)), 0.014567225 / sqr(0.5 - 1.12) - 0.011612903);
    EXPECT_NEAR(metallic_fresnel(0.0), 1.0, 1e-6);
    EXPECT_DOUBLE_EQ(metallic_fresnel(-1.0), 0.014567225 / 0.7744 - 0.011612903);
    EXPECT_EQ(metallic_fresnel(2.0), metallic_fresnel(1.0));
    const Rgb tint = metallic_tint(Rgb(0.2, 1.0, 0.5), 1.0, 1.0);
    EXPECT_NEAR(tint.r, 0.2, 1e-4);
    EXPECT_EQ(tint.g, 1.0);
    EXPECT_EQ(metallic_tint(Rgb(0.2), 0.0, 1.0), Rgb(1.0));
}

TEST(AngularReflectivity, is_linear_in_one_minus_cosine_by_default) {
    EXPECT_DOUBLE_EQ(angular_reflectivity(Rgb(0.1), Rgb(0.8), 1.0, 0.75).r, 0.1 * 0.75 + 0.8 * 0.25);
    EXPECT_DOUBLE_EQ(angular_reflectivity(Rgb(0.1), Rgb(0.8), 3.0, 0.5).r, 0.1 * 0.875 + 0.8 * 0.125);
    EXPECT_EQ(angular_reflectivity(Rgb(0.4), Rgb(0.4), 2.0, 0.1).g, 0.4);
    EXPECT_DOUBLE_EQ(angular_reflectivity(Rgb(0.1), Rgb(0.8), 1.0, -0.5).r, 0.1 * -0.5 + 0.8 * 1.5) << "bumps that look away";
    EXPECT_TRUE(std::isfinite(angular_reflectivity(Rgb(0.1), Rgb(0.8), 0.5, 1.0 + 1e-15).r));
}

TEST(CubicStep, joins_0_to_1_and_is_hard_when_the_ends_are_exchanged) {
    EXPECT_EQ(cubic_step(1.0, 3.0, 0.5), 0.0);
    EXPECT_EQ(cubic_step(1.0, 3.0, 2.0), 0.5);
    EXPECT_DOUBLE_EQ(cubic_step(0.0, 1.0, 0.25), 0.15625);
    EXPECT_EQ(cubic_step(1.0, 3.0, 3.0), 1.0);
    EXPECT_EQ(cubic_step(3.0, 1.0, 2.0), 0.0);
    EXPECT_EQ(cubic_step(2.0, 2.0, 2.0), 1.0);
}

}  // namespace
}  // namespace rt::povray_finish_test
