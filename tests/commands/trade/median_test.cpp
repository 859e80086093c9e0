// When a time has been measured often enough.
#include "commands/trade/median.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rt::median_test {
namespace {

using List = std::vector<double>;

TEST(Median, StandsInTheMiddleWhateverTheOrder) {
    EXPECT_EQ(median(List{7.0}), 7.0);
    EXPECT_EQ(median(List{3.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median(List{4.0, 1.0, 3.0, 2.0}), 2.5);
}

/// n = 3: ranks 0 and 2; n = 5: (5 - 2.24) / 2 = 1.38, ranks 1 and 3; n = 9: (9 - 3) / 2 = 3, ranks 3 and 5.
TEST(MedianSpread, IsHalfTheDistanceOfRanksAroundTheMiddle) {
    EXPECT_TRUE(std::isinf(median_spread(List{1.0})));
    EXPECT_DOUBLE_EQ(median_spread(List{9.0, 10.0, 12.0}), 0.15);
    EXPECT_DOUBLE_EQ(median_spread(List{1.0, 9.0, 10.0, 12.0, 99.0}), 0.15);
    EXPECT_DOUBLE_EQ(median_spread(List{0.0, 0.0, 0.0, 9.0, 10.0, 12.0, 50.0, 60.0, 70.0}), 0.15);
    EXPECT_EQ(median_spread(List{0.0, 0.0, 0.0}), 0.0);
}

TEST(RepeatRule, TakesTheLeastRunsAndThenWhatTheSpreadAsksFor) {
    const RepeatRule rule{.least = 3, .most = 5, .spread = 0.03, .seconds = 100.0};
    EXPECT_FALSE(is_measured(List{}, rule));
    EXPECT_FALSE(is_measured(List{1.0, 1.0}, rule));
    EXPECT_TRUE(is_measured(List{1.0, 1.01, 0.99}, rule));
    EXPECT_FALSE(is_measured(List{1.0, 1.04, 0.96}, rule));
    EXPECT_FALSE(is_measured(List{1.0, 1.4, 0.6, 1.8}, rule));
    EXPECT_TRUE(is_measured(List{1.0, 1.4, 0.6, 1.8, 2.2}, rule)) << "no more runs than that";
    EXPECT_TRUE(is_measured(List{40.0, 50.0, 60.0}, rule)) << "no more time than that";
    EXPECT_FALSE(is_measured(List{500.0, 600.0}, rule)) << "the least runs are done all the same";
}

}  // namespace
}  // namespace rt::median_test
