// What is told of many things that are done one after the other.
#include <gtest/gtest.h>

#include "commands/base/task_progress.h"

namespace rt::task_progress_test {
namespace {

TEST(TaskProgress, TellsHowFarRateAndTimeLeft) {
    EXPECT_EQ(task_progress_text({18000, 0, 0, 0.1, 0.0}, "tests"), "      0/18000 tests");
    EXPECT_EQ(task_progress_text({18000, 40, 40, 0.1, 0.0}, "tests"), "     40/18000 tests (40 known)");
    EXPECT_EQ(task_progress_text({18000, 160, 40, 4.0, 571.2}, "tests"), "    160/18000 tests (40 known)  30.0 tests/s  0:09:31 left");
    EXPECT_EQ(task_progress_text({20, 3, 0, 90.0, 3661.0}, "builds"), "      3/20 builds  2.0 builds/min  1:01:01 left");
}

TEST(TaskProgress, WhatIsLeftTakesWhatItsKindTook) {
    TimeLeft left;
    for (const char* kind : {"a", "a", "b", "c"}) left.expect(kind);
    EXPECT_EQ(left.seconds(1), 0.0) << "nothing is known yet";
    left.add("a", 2.0);
    left.add("b", 4.0);
    EXPECT_EQ(left.seconds(1), 2.0 + 3.0) << "one a, and c as long as all took";
    EXPECT_EQ(left.seconds(2), 2.5);
}

}  // namespace
}  // namespace rt::task_progress_test
