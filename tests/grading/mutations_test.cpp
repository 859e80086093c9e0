// Right answers made wrong in one way.
#include "grading/mutations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rt::mutations_test {
namespace {

using testing::ElementsAre;

/// Two rows of three pixels, grey with alpha.
const StoredImage right{3, 2, 2, 255, {10, 1, 20, 2, 30, 3, 40, 4, 50, 5, 200, 6}};

TEST(Mutations, ColoursAreScaledAndAlphaStays) {
    EXPECT_THAT(scaled(right, 1.5).values, ElementsAre(15, 1, 30, 2, 45, 3, 60, 4, 75, 5, 255, 6));
    EXPECT_THAT(scaled({1, 1, 4, 0, {2, 3, 4, 5}}, 2.5).values, ElementsAre(5, 7.5f, 10, 5));  // linear light has no largest value
}

TEST(Mutations, AMirrorExchangesLeftAndRight) {
    EXPECT_THAT(mirrored(right).values, ElementsAre(30, 3, 20, 2, 10, 1, 200, 6, 50, 5, 40, 4));
}

TEST(Mutations, WhatAShiftBringsIntoViewRepeatsTheBorder) {
    EXPECT_THAT(shifted(right, 1, 0).values, ElementsAre(10, 1, 10, 1, 20, 2, 40, 4, 40, 4, 50, 5));
    EXPECT_THAT(shifted(right, -2, 1).values, ElementsAre(30, 3, 30, 3, 30, 3, 30, 3, 30, 3, 30, 3));
    EXPECT_EQ(shifted(right, 0, 0).values, right.values);
}

TEST(Mutations, TheLastDigitBehindAPointChanges) {
    EXPECT_EQ(one_digit_changed("a 1.25, b 3.19 and 7\n"), "a 1.25, b 3.18 and 7\n");
    EXPECT_EQ(one_digit_changed("1.25 .5 6."), "1.26 .5 6.");
    EXPECT_EQ(one_digit_changed("12 pixels"), std::nullopt);
}

}  // namespace
}  // namespace rt::mutations_test
