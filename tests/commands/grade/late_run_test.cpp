// What decides whether a late run is worth another one.
#include <gtest/gtest.h>
#include <unistd.h>

#include "commands/grade/grade_test.h"

namespace rt::late_run_test {
namespace {

TEST(GradeTest, ALateRunMayHaveWaitedUnlessItHadWhatItWanted) {
    EXPECT_FALSE(may_have_waited(0.1, 10.0, 0)) << "it slept";
    EXPECT_TRUE(may_have_waited(0.3, 10.0, 0));
    EXPECT_TRUE(may_have_waited(5.0, 10.0, 1));
    EXPECT_TRUE(may_have_waited(8.9, 10.0, 1));
    EXPECT_FALSE(may_have_waited(9.1, 10.0, 1)) << "it had a processor all the time";
    EXPECT_FALSE(may_have_waited(9.1, 10.0, 0));
}

TEST(GradeTest, ManyThreadsWantAsManyProcessorsAsThereAre) {
    const double processors = static_cast<double>(sysconf(_SC_NPROCESSORS_ONLN));
    EXPECT_TRUE(may_have_waited(8.9 * processors, 10.0, 1000));
    EXPECT_FALSE(may_have_waited(9.1 * processors, 10.0, 1000));
    if (processors >= 2) {
        EXPECT_TRUE(may_have_waited(9.1, 10.0, 2)) << "two threads on one processor";
        EXPECT_FALSE(may_have_waited(18.1, 10.0, 2));
    }
}

}  // namespace
}  // namespace rt::late_run_test
