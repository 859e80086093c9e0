// How the time of a trade is shared.
#include "commands/trade/trade_clock.h"

#include <gtest/gtest.h>

namespace rt::trade_clock_test {
namespace {

TEST(TradeClock, GivesEveryPartAnEndAndTheLastOneTheWhole) {
    const TradeClock clock(1e6);
    EXPECT_NEAR(clock.left_for(TradePart::alone), 4e5, 1e3);
    EXPECT_NEAR(clock.left_for(TradePart::settings), 7.5e5, 1e3);
    EXPECT_NEAR(clock.left_for(TradePart::further), 9e5, 1e3);
    EXPECT_NEAR(clock.left(), 1e6, 1e3);
}

TEST(TradeClock, RunsOut) {
    const TradeClock clock(0.0);
    EXPECT_LE(clock.left(), 0.0);
    EXPECT_LE(clock.left_for(TradePart::alone), 0.0);
}

}  // namespace
}  // namespace rt::trade_clock_test
