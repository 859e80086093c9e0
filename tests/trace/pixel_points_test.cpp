#include "trace/pixel_points.h"

#include <gtest/gtest.h>

#include <set>

namespace rt::pixel_points_test {
namespace {

TEST(PixelPoints, TheFirstIsTheCentre) {
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{3, 1}, std::pair{1279, 719}}) {
        const Vec2 point = pixel_point(x, y, 0);
        EXPECT_EQ(point.x, x + 0.5);
        EXPECT_EQ(point.y, y + 0.5);
    }
}

/// 2^k points have one in each of 2^k equal boxes of 2^a columns and 2^(k-a) rows.
void expect_net(int x, int y, std::uint32_t first, int k) {
    for (int a = 0; a <= k; ++a) {
        const int columns = 1 << a, rows = 1 << (k - a);
        std::set<std::pair<int, int>> boxes;
        for (std::uint32_t n = first; n < first + (1u << k); ++n) {
            const Vec2 point = pixel_point(x, y, n);
            boxes.insert({static_cast<int>((point.x - x) * columns), static_cast<int>((point.y - y) * rows)});
        }
        EXPECT_EQ(boxes.size(), std::size_t{1} << k) << "pixel " << x << ", " << y << " from " << first << ", columns " << columns;
        EXPECT_LT(boxes.rbegin()->first, columns);
    }
}

TEST(PixelPoints, EveryRunOfAPowerOfTwoIsANet) {
    for (const int k : {1, 2, 3, 6, 10}) {
        for (const std::uint32_t run : {0u, 1u, 5u}) {
            expect_net(0, 0, run << k, k);
            expect_net(17, 4, run << k, k);
        }
    }
}

TEST(PixelPoints, NeighboursHaveOthers) {
    std::set<std::pair<double, double>> seconds;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) seconds.insert({pixel_point(x, y, 1).x - x, pixel_point(x, y, 1).y - y});
    EXPECT_EQ(seconds.size(), 16u);
}

}  // namespace
}  // namespace rt::pixel_points_test
