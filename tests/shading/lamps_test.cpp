// Lamps by distance, and the one weight of the models that is cut.
#include "shading/lamps.h"

#include <gtest/gtest.h>

#include "shading/models.h"

namespace rt::lamps_test {
namespace {

TEST(Lamps, ThinOutByTheirLaw) {
    EXPECT_EQ(attenuation({}, 7.0), 1.0);
    EXPECT_DOUBLE_EQ(attenuation({.kind = Attenuation::one_d_d2}, 2.0), 1.0 / 7.0);
    const AttenuationLaw polynomial{.kind = Attenuation::polynomial, .constant = 2.0, .linear = 0.5, .quadratic = 0.25};
    EXPECT_DOUBLE_EQ(attenuation(polynomial, 4.0), 1.0 / 8.0);
    EXPECT_DOUBLE_EQ(attenuation({.kind = Attenuation::inverse_square}, 4.0), 1.0 / 16.0);
}

TEST(Lamps, AreNoBrighterThanAtTheLeastDistance) {
    const AttenuationLaw law{.kind = Attenuation::inverse_square, .least_distance = 0.5};
    EXPECT_DOUBLE_EQ(attenuation(law, 0.51), 1.0 / (0.51 * 0.51));
    for (const double distance : {0.5, 0.3, 1e-3, 1e-200}) EXPECT_EQ(attenuation(law, distance), 4.0) << distance;
}

TEST(Lamps, ReachToTheirRangeAndAreFiniteAtThePointItself) {
    for (const Attenuation kind : {Attenuation::none, Attenuation::one_d_d2, Attenuation::polynomial, Attenuation::inverse_square}) {
        const AttenuationLaw law{.kind = kind, .range = 3.0};
        EXPECT_GT(attenuation(law, 3.0), 0.0);
        EXPECT_EQ(attenuation(law, 3.0000001), 0.0);
        EXPECT_TRUE(attenuation(law, 0.0) >= 1.0 && attenuation(law, 0.0) <= brightest);
    }
}

TEST(Lecture, DiffuseLightIsWhatTheOtherWeightsLeaveAndNeverNegative) {
    EXPECT_DOUBLE_EQ(lecture_diffuse(0.25, 0.5), 0.25);
    EXPECT_EQ(lecture_diffuse(0.5, 0.5), 0.0);
    EXPECT_EQ(lecture_diffuse(0.75, 0.5), 0.0);
}

}  // namespace
}  // namespace rt::lamps_test
