#include "patterns/checker.h"

#include <gtest/gtest.h>

#include <limits>

namespace rt::checker_test {
namespace {

TEST(Checker, ParityOfTheUnitCube) {
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) EXPECT_EQ(checker({x + 0.5, y + 0.25, z + 0.75}), (x + y + z) & 1) << x << ' ' << y << ' ' << z;
}

TEST(Checker, AFaceBelongsToTheCubeAboveItWithinTheOffset) {
    EXPECT_EQ(checker({0.0, 0.0, 0.0}), 0);
    EXPECT_EQ(checker({-1e-11, 0.0, 0.0}), 0);  // rounded below the face, still on it
    EXPECT_EQ(checker({-1e-9, 0.0, 0.0}), 1);
    EXPECT_EQ(checker({1.0 - 1e-11, 0.5, 0.5}), 1);
}

TEST(Checker, FarAwayItIsStillZeroOrOne) {
    for (const double far : {1e9, 1e15, 1e18, -1e18, 1e300, std::numeric_limits<double>::infinity()}) {
        const int parity = checker({far, far, -far});
        EXPECT_TRUE(parity == 0 || parity == 1);
    }
}

}  // namespace
}  // namespace rt::checker_test
