#include "grading/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/source.h"
#include "tests/grading/pictures.h"

namespace rt::difference_test {
namespace {

using test::picture;

TEST(Difference, EqualPicturesDifferInNothing) {
    std::mt19937 random(1);
    const StoredImage image = test::random_picture(40, 30, 4, 65535, random);
    const Difference result = compare(image, image, {});
    EXPECT_TRUE(result.same_size);
    EXPECT_EQ(result.pixels, 1200u);
    EXPECT_EQ(result.differing + result.differing_0 + result.differing_1, 0u);
    EXPECT_EQ(result.max, 0.0);
    EXPECT_EQ(result.rmse, 0.0);
    EXPECT_EQ(result.p99, 0.0);
    EXPECT_EQ(result.flip_max, 0.0);
    EXPECT_EQ(result.psnr, std::numeric_limits<double>::infinity());
}

TEST(Difference, FiguresOfTwoPixelsByHand) {
    const StoredImage a = picture(2, 1, 3, 255, {10, 20, 30, 40, 50, 60});
    const StoredImage b = picture(2, 1, 3, 255, {10, 20, 33, 40, 46, 60});
    const Difference result = compare(a, b, {});
    EXPECT_DOUBLE_EQ(result.max, 4.0 / 255.0);
    EXPECT_EQ(result.max_x, 1);
    EXPECT_EQ(result.max_y, 0);
    EXPECT_EQ(result.max_channel, 1);
    EXPECT_DOUBLE_EQ(result.max_a, 50.0 / 255.0);
    EXPECT_DOUBLE_EQ(result.max_b, 46.0 / 255.0);
    EXPECT_DOUBLE_EQ(result.mean_absolute, 7.0 / 255.0 / 6.0);
    EXPECT_DOUBLE_EQ(result.rmse, std::sqrt(25.0 / 6.0) / 255.0);
    EXPECT_DOUBLE_EQ(result.psnr, -20.0 * std::log10(std::sqrt(25.0 / 6.0) / 255.0));
    EXPECT_EQ(result.differing_0, 2u);
    EXPECT_EQ(result.differing_1, 2u);  // 3/255 is 1.18 %
    EXPECT_EQ(result.differing, 0u);
}

TEST(Difference, TheWorstPixelIsCountedFromTheTopLeft) {
    StoredImage a = picture(5, 4, 1, 255, std::vector<float>(20, 7.0f));
    StoredImage b = a;
    b.values[2 * 5 + 3] = 200.0f;
    b.values[3 * 5 + 1] = 200.0f;  // as large, later
    const Difference result = compare(a, b, {});
    EXPECT_EQ(result.max_x, 3);
    EXPECT_EQ(result.max_y, 2);
    EXPECT_EQ(result.max_channel, 0);
}

TEST(Difference, PercentileLeavesOutOnePixelInAHundred) {
    StoredImage a = picture(20, 10, 1, 255, std::vector<float>(200, 0.0f));
    StoredImage b = a;
    b.values[7] = 100.0f;
    b.values[8] = 90.0f;
    EXPECT_EQ(compare(a, b, {}).p99, 0.0);
    b.values[9] = 80.0f;
    EXPECT_DOUBLE_EQ(compare(a, b, {}).p99, 80.0 / 255.0);
}

TEST(Difference, BitDepthsAndChannelCountsAreBroughtTogether) {
    std::mt19937 random(2);
    const StoredImage grey = test::random_picture(16, 8, 1, 255, random);
    StoredImage rgb16 = picture(16, 8, 3, 65535, {});
    StoredImage rgba = picture(16, 8, 4, 255, {});
    for (float value : grey.values) {
        for (int i = 0; i < 3; ++i) rgb16.values.push_back(257.0f * value);
        for (int i = 0; i < 3; ++i) rgba.values.push_back(value);
        rgba.values.push_back(255.0f);
    }
    for (const StoredImage* other : {&rgb16, &rgba}) {
        const Difference result = compare(grey, *other, {});
        EXPECT_EQ(result.differing_0, 0u);
        EXPECT_EQ(result.max, 0.0);
        EXPECT_LT(result.flip_max, 1e-5);
    }
    rgba.values[3] = 0.0f;
    const Difference transparent = compare(grey, rgba, {});
    EXPECT_EQ(transparent.max, 1.0);
    EXPECT_EQ(transparent.max_channel, 3);
}

TEST(Difference, FuzzIsAShareOf65536AndReachedByEquality) {
    const StoredImage black = picture(1, 1, 1, 65535, {0}), white = picture(1, 1, 1, 65535, {65535}),
                      eighth = picture(1, 1, 1, 65535, {8192});
    EXPECT_EQ(compare(black, white, {100.0}).differing, 0u);
    EXPECT_EQ(compare(black, white, {99.99}).differing, 1u);
    EXPECT_EQ(compare(black, eighth, {12.5}).differing, 1u);
    EXPECT_EQ(compare(black, eighth, {12.51}).differing, 0u);
}

TEST(Difference, SizesThatDifferGiveNoOtherFigure) {
    const StoredImage a = picture(2, 3, 1, 255, std::vector<float>(6, 1.0f)), b = picture(3, 2, 1, 255, std::vector<float>(6, 9.0f));
    const Difference result = compare(a, b, {});
    EXPECT_FALSE(result.same_size);
    EXPECT_EQ(result.pixels, 0u);
    EXPECT_EQ(result.max, 0.0);
    EXPECT_THROW(difference_picture(a, b, 1.0), OptionError);
    EXPECT_FALSE(compare(StoredImage{}, StoredImage{}, {}).same_size);
}

TEST(Difference, FloatsAreLinearLightAndEncodedBesideIntegers) {
    // 0.5 encoded: 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357
    const StoredImage linear = picture(1, 1, 1, 0, {0.5f}), stored = picture(1, 1, 1, 255, {188.0f});
    EXPECT_NEAR(compare(linear, stored, {}).max, 188.0 / 255.0 - 0.7353569830524495, 1e-7);
    EXPECT_NEAR(compare(linear, picture(1, 1, 1, 0, {0.75f}), {}).max, 0.25, 1e-12);
}

TEST(Difference, NumbersThatAreNoneDifferByFullScale) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    const StoredImage a = picture(2, 1, 1, 0, {nan, infinite}), b = picture(2, 1, 1, 0, {0.5f, infinite});
    const Difference result = compare(a, b, {});
    EXPECT_EQ(result.max, 1.0);
    EXPECT_EQ(result.differing, 1u);
    EXPECT_TRUE(std::isfinite(result.rmse));
    EXPECT_TRUE(std::isfinite(result.flip_mean));
    EXPECT_EQ(compare(a, a, {}).differing_0, 0u);
    EXPECT_TRUE(std::isfinite(compare(a, picture(2, 1, 1, 0, {1.0f, -infinite}), {}).rmse));
}

TEST(DifferencePicture, ShowsScaledAbsoluteDifferences) {
    const StoredImage a = picture(1, 2, 3, 255, {10, 20, 30, 200, 0, 0}), b = picture(1, 2, 3, 255, {12, 17, 30, 0, 0, 1});
    const StoredImage result = difference_picture(a, b, 10.0);
    EXPECT_EQ(result.width, 1);
    EXPECT_EQ(result.height, 2);
    EXPECT_EQ(result.channels, 3);
    EXPECT_EQ(result.max_value, 255);
    EXPECT_EQ(result.values, (std::vector<float>{20, 30, 0, 255, 0, 10}));
}

}  // namespace
}  // namespace rt::difference_test
