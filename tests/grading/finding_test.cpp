#include "grading/finding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rt::finding_test {
namespace {

using testing::ElementsAre;

TEST(Finding, ShareLeftIsTheMeanOfPixelsAndSquares) {
    Misfit whole, left;
    whole.add(0.5f), whole.add(0.5f), whole.add(0.01f);  // the last is not visible, and has its square
    left.add(0.5f);
    EXPECT_EQ(whole.differing, 2.0);
    EXPECT_NEAR(share_left(left, whole), 0.5 * (0.5 + 0.25 / 0.5001), 1e-6);
    EXPECT_EQ(share_left(whole, whole), 1.0);
}

TEST(Finding, TheBestCauseIsChosen) {
    const Verdicts verdicts = choose({{"a", "of a", 0.1}, {"b", "of b", 0.02}, {"c", "of c", 0.9}});
    EXPECT_EQ(verdicts.cause, "b");
    EXPECT_THAT(verdicts.lines, ElementsAre("of b"));
}

TEST(Finding, AmongEqualsTheFirstIsChosenAndTheOthersAreTold) {
    const Verdicts verdicts = choose({{"a", "of a", 0.011}, {"b", "of b", 0.010}, {"a", "another of a", 0.3}});
    EXPECT_EQ(verdicts.cause, "a");
    EXPECT_THAT(verdicts.lines, ElementsAre("of a", "as well explained by b: of b"));
}

TEST(Finding, FreedomCosts) {
    EXPECT_EQ(choose({{"fitted", "", 0.01, 0.1}, {"plain", "", 0.05}}).cause, "plain");
    EXPECT_EQ(choose({{"fitted", "", 0.1, 0.1}}).cause, "fitted");  // nothing else comes near
    EXPECT_EQ(choose({{"fitted", "", 0.25, 0.1}}).cause, "");
}

TEST(Finding, WhatExplainsLessNeedsALead) {
    EXPECT_EQ(choose({{"a", "", 0.25}, {"b", "", 0.9}}).cause, "a");
    EXPECT_EQ(choose({{"a", "", 0.25}, {"b", "", 0.5}}).cause, "");
}

TEST(Finding, WithoutACauseTheNearestTwoAreTold) {
    const Verdicts verdicts = choose({{"a", "of a", 0.8}, {"b", "of b", 0.5}, {"c", "of c", 0.6}});
    EXPECT_EQ(verdicts.cause, "");
    EXPECT_THAT(verdicts.lines, ElementsAre("no common mistake explains the difference; nearest to it:", "  b? of b", "  c? of c"));
    EXPECT_THAT(choose({}).lines, ElementsAre("no common mistake explains the difference"));
}

}  // namespace
}  // namespace rt::finding_test
