// idiff's limits.
#include "commands/base/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rt::verdict_test {
namespace {

StoredImage image(int width, int channels, std::vector<float> values, int max_value = 255) {
    return {width, 1, channels, max_value, std::move(values)};
}

TEST(Verdict, CountsPixelsBeyondTheLimits) {
    const StoredImage a = image(3, 3, {0, 0, 0, 10, 20, 30, 255, 255, 255});
    const StoredImage b = image(3, 3, {0, 0, 0, 10, 20, 33, 255, 200, 250});
    DifferenceLimits limits;
    limits.fail = 4.0 / 255.0;
    limits.warn = 2.0 / 255.0;
    const PixelCounts counts = count_pixels(a, b, limits);
    EXPECT_EQ(counts.failing, 1u);
    EXPECT_EQ(counts.warning, 2u);
    EXPECT_DOUBLE_EQ(counts.largest, 55.0 / 255.0);
}

TEST(Verdict, PicturesOfDifferentDepthAndKindCompare) {
    const DifferenceLimits limits;
    EXPECT_EQ(count_pixels(image(1, 1, {128}), image(1, 3, {128, 128, 128}), limits).largest, 0.0);
    EXPECT_EQ(count_pixels(image(1, 3, {255, 0, 51}), image(1, 4, {65535, 0, 13107, 0}, 65535), limits).largest, 0.0);
    EXPECT_EQ(count_pixels(image(1, 2, {7, 255}), image(1, 2, {7, 0}), limits).largest, 1.0);
    EXPECT_EQ(count_pixels(image(1, 1, {NAN}, 0), image(1, 1, {1}, 0), limits).largest, HUGE_VAL);
    EXPECT_EQ(count_pixels(image(1, 1, {NAN}, 0), image(1, 1, {NAN}, 0), limits).largest, 0.0);
}

TEST(Verdict, FailureBeforeWarning) {
    DifferenceLimits limits;
    limits.fail_percent = 10.0;
    limits.warn_percent = 5.0;
    EXPECT_EQ(verdict({0, 0, 0.0}, 100, limits), Verdict::same);
    EXPECT_EQ(verdict({5, 5, 0.1}, 100, limits), Verdict::same);
    EXPECT_EQ(verdict({6, 6, 0.1}, 100, limits), Verdict::warning);
    EXPECT_EQ(verdict({10, 10, 0.1}, 100, limits), Verdict::warning);
    EXPECT_EQ(verdict({11, 11, 0.1}, 100, limits), Verdict::failure);
    limits.hard_fail = 0.05;
    EXPECT_EQ(verdict({1, 1, 0.1}, 100, limits), Verdict::failure);
    limits.hard_fail = 0.2;
    limits.hard_warn = 0.05;
    EXPECT_EQ(verdict({1, 1, 0.1}, 100, limits), Verdict::warning);
}

}  // namespace
}  // namespace rt::verdict_test
