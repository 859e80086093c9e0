// The converged picture grows by grids, and its error is that of its halves.
#include "commands/trade/reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "commands/job/knobs.h"

namespace rt::reference_test {
namespace {

using testing::ElementsAre;

TEST(NextGrid, HasAboutAsManySamplesAsAllBefore) {
    std::vector<int> grids;
    while (grids.size() < 9) grids.push_back(next_grid(grids));
    EXPECT_THAT(grids, ElementsAre(5, 7, 11, 13, 19, 29, 41, 59, 83));
}

/// A grid of n x n has the points (2 i + 1) / 2 n on each side.
TEST(NextGrid, HasOnlyTheCentreInCommonWithAnyOtherAndWithASetting) {
    std::vector<int> grids;
    while (grids.size() < 9) grids.push_back(next_grid(grids));
    std::vector<int> others = grids;
    for (const KnobValue& value : find_knob("samples")->values)
        if (value.words.starts_with("--ss ")) others.push_back(std::stoi(std::string(value.words.substr(5))));
    ASSERT_GT(others.size(), grids.size() + 5);
    for (const int a : grids)
        for (const int b : others)
            for (int i = 0; i < a; ++i)
                for (int j = 0; j < b; ++j) {
                    const bool same = a != b && (2 * i + 1) * b == (2 * j + 1) * a;
                    EXPECT_TRUE(!same || 2 * i + 1 == a) << a << " and " << b;
                }
}

TEST(Joined, IsTheMeanBySamples) {
    Film a(2, 1), b(2, 1);
    a.pixels = {{1.0f, 2.0f, 3.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}};
    b.pixels = {{5.0f, 6.0f, 7.0f, 1.0f}, {4.0f, 8.0f, 12.0f, 0.0f}};
    const Film film = joined(a, 1.0, b, 3.0);
    EXPECT_EQ(film.pixels[0], (Pixel{4.0f, 5.0f, 6.0f, 0.75f}));
    EXPECT_EQ(film.pixels[1], (Pixel{3.0f, 6.0f, 9.0f, 0.25f}));
}

TEST(JoinedError, OfEqualHalvesIsHalfOfWhatTheyAreApart) {
    EXPECT_DOUBLE_EQ(joined_error(0.02, 50.0, 50.0), 0.01);
    EXPECT_DOUBLE_EQ(joined_error(0.02, 20.0, 80.0), 0.02 * 40.0 / 100.0);
}

/// Means of independent samples of a known distribution: the estimate is the true error, on average.
TEST(JoinedError, IsTheTrueErrorOfIndependentSamples) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> light(0.0, 1.0);
    const auto mean = [&](int samples) {
        double sum = 0.0;
        for (int i = 0; i < samples; ++i) sum += light(random);
        return sum / samples;
    };
    constexpr int pixels = 20000, a = 9, b = 16;
    double apart = 0.0, off = 0.0;
    for (int i = 0; i < pixels; ++i) {
        const double x = mean(a), y = mean(b);
        apart += (x - y) * (x - y);
        const double joint = (a * x + b * y) / (a + b);
        off += (joint - 0.5) * (joint - 0.5);
    }
    EXPECT_NEAR(joined_error(std::sqrt(apart / pixels), a, b) / std::sqrt(off / pixels), 1.0, 0.02);
}

}  // namespace
}  // namespace rt::reference_test
