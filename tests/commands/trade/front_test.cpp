// Points of time and error that no other beats.
#include "commands/trade/front.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rt::front_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Points = std::vector<TradePoint>;

TEST(Front, IsWhatNoOtherBeatsFromQuickToExact) {
    EXPECT_THAT(front_of(Points{}), IsEmpty());
    EXPECT_THAT(front_of(Points{{1.0, 0.5}}), ElementsAre(0));
    EXPECT_THAT(front_of(Points{{4.0, 0.1}, {1.0, 0.5}, {2.0, 0.6}, {2.0, 0.3}, {9.0, 0.2}}), ElementsAre(1, 3, 0));
}

TEST(Front, ASmallerErrorHasToBeWorthItsTime) {
    EXPECT_THAT(front_of(Points{{1.0, 0.5}, {2.0, 0.495}, {3.0, 0.48}}), ElementsAre(0, 2));
    EXPECT_THAT(front_of(Points{{1.0, 0.5}, {2.0, 0.495}, {3.0, 0.48}}, {.worth = 0.0}), ElementsAre(0, 1, 2));
}

/// What was planned first has the simpler name.
TEST(Front, OfPointsThatAreAsGoodTheFirstStands) {
    EXPECT_THAT(front_of(Points{{1.0, 0.5}, {0.97, 0.5}, {3.0, 0.1}}), ElementsAre(0, 2));
    EXPECT_THAT(front_of(Points{{1.0, 0.5}, {0.97, 0.499}, {3.0, 0.1}}), ElementsAre(0, 2));
    EXPECT_THAT(front_of(Points{{1.0, 0.5}, {0.9, 0.5}, {3.0, 0.1}}), ElementsAre(1, 2)) << "too much quicker to be the same";
    EXPECT_THAT(front_of(Points{{1.0, 0.5}, {0.97, 0.45}, {3.0, 0.1}}), ElementsAre(1, 2)) << "too much better to be the same";
}

TEST(Front, AnExactPictureEndsIt) { EXPECT_THAT(front_of(Points{{1.0, 0.5}, {2.0, 0.0}, {3.0, 0.0}}), ElementsAre(0, 1)); }

TEST(BeatenBy, IsTheFactorInBothTimeAndError) {
    const Points front{{1.0, 0.5}, {4.0, 0.1}};
    EXPECT_DOUBLE_EQ(beaten_by(front, {2.0, 1.5}), std::log(2.0)) << "twice as slow and three times as wrong as the first";
    EXPECT_DOUBLE_EQ(beaten_by(front, {8.0, 0.2}), std::log(2.0)) << "by the second";
    EXPECT_DOUBLE_EQ(beaten_by(front, {2.0, 0.25}), std::log(0.5)) << "by none: between the two";
    EXPECT_DOUBLE_EQ(beaten_by(front, {4.0, 0.1}), 0.0);
    EXPECT_EQ(beaten_by({}, {1.0, 1.0}), -INFINITY);
    EXPECT_TRUE(std::isfinite(beaten_by(Points{{1.0, 0.0}}, {2.0, 0.0})));
}

}  // namespace
}  // namespace rt::front_test
