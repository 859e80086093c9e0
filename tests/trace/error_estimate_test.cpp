// What a few samples tell of a pixel's error, by the formulas.
#include "trace/error_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace rt::error_estimate_test {
namespace {

Encoding plain(bool alpha = false) {
    Encoding encoding;
    encoding.raw = true;
    encoding.alpha = alpha;
    return encoding;
}

std::vector<Pixel> greys(const std::vector<float>& values) {
    std::vector<Pixel> pixels;
    for (const float v : values) pixels.push_back({v, v, v, 0.0f});
    return pixels;
}

double fall(int n) { return std::pow(n, -1.5); }

/// Of a picture of one pixel, whose neighbours are itself: 1.4^2 spread (1 + its share of what is unseen) n^-1.5.
double error_of(double spread, int n) {
    const double neighbours = 20.0 / (20.0 + n - 1);
    return 1.4 * std::sqrt(spread * (1.0 + 0.01 * neighbours) * fall(n));
}

SampledPicture picture_of(const std::vector<std::vector<float>>& batches) {
    SampledPicture picture(1, 1, plain());
    for (const std::vector<float>& batch : batches) picture.add(0, greys(batch));
    picture.estimate();
    return picture;
}

TEST(SampledPicture, TheVarianceCountsWhereHalvesAgree) {
    // Eight samples of mean 1/2 whose deviations are 1/4: their sum of squares is 7/16.
    const SampledPicture picture = picture_of({{0.5f}, {0.25f, 0.75f, 0.25f, 0.75f, 0.25f, 0.75f, 0.5f}});
    EXPECT_NEAR(picture.error(), error_of(6.0 / 16.0 / 7.0, 8), 1e-6);
}

TEST(SampledPicture, HalvesCountWhereTheyDiffer) {
    const std::vector<float> dark(8, 0.25f), bright(8, 0.75f);
    const SampledPicture picture = picture_of({{0.25f}, std::vector<float>(7, 0.25f), bright});
    const double constant = 4.0 * (2.0 - std::sqrt(0.5)) / std::sqrt(0.5);
    const double halves = 0.5 * 0.25 / (constant * fall(16)), variance = 16.0 / 16.0 / 15.0;
    EXPECT_GT(halves, variance);
    EXPECT_NEAR(picture.error(), error_of(halves, 16), 1e-6);
}

TEST(SampledPicture, TheSecondBatchIsSetAgainstTheFirstSample) {
    const SampledPicture picture = picture_of({{0.25f}, std::vector<float>(7, 0.75f)});
    EXPECT_NEAR(picture.error(), error_of(0.25 / (1.0 + fall(7)), 8), 1e-6);
}

TEST(SampledPicture, WhatIsShownIsWithinItsRange) {
    EXPECT_EQ(picture_of({{2.0f}, {3.0f, 4.0f, 5.0f, 2.0f, 3.0f, 4.0f, 5.0f}}).error(), 0.0);
}

TEST(SampledPicture, AlphaIsAFourthChannel) {
    for (const bool alpha : {false, true}) {
        SampledPicture picture(1, 1, plain(alpha));
        picture.add(0, std::vector<Pixel>{{0.5f, 0.5f, 0.5f, 0.25f}});
        picture.add(0, std::vector<Pixel>(7, Pixel{0.5f, 0.5f, 0.5f, 0.75f}));
        picture.estimate();
        EXPECT_NEAR(picture.error(), alpha ? error_of(0.25 / 4.0 / (1.0 + fall(7)), 8) : 0.0, 1e-6);
    }
}

TEST(SampledPicture, ASingleSampleIsAsFarOffAsItsNeighboursAre) {
    SampledPicture picture(2, 1, plain());
    picture.add(0, greys({0.25f})), picture.add(1, greys({0.75f}));
    picture.estimate();
    EXPECT_NEAR(picture.error(), 1.4 * std::sqrt(0.25 / 72.0 * 1.01), 1e-6);
    EXPECT_EQ(picture.next_batch(0), 7);
}

TEST(SampledPicture, WhatIsNotFiniteHasNoErrorAndIsNeverChosen) {
    SampledPicture picture(2, 1, plain());
    picture.add(0, greys({std::numeric_limits<float>::quiet_NaN()})), picture.add(1, greys({0.75f}));
    picture.estimate();
    EXPECT_TRUE(std::isfinite(picture.error()));
    EXPECT_GT(picture.error(), 0.0);
    EXPECT_EQ(picture.worst(1e-4, 4096), std::vector<std::uint32_t>{1});
    EXPECT_TRUE(picture.worst(1e-4, 7).empty());
}

/// A pixel of a highlight that no number of samples settles does not make every other one take as many.
TEST(SampledPicture, APixelBeyondHelpDoesNotCostTheOthersTheirSamples) {
    SampledPicture picture(64, 1, plain());
    const auto add = [&](std::size_t pixel, int count) {
        const float off = pixel == 0 ? 0.5f : 0.002f;
        std::vector<float> batch;
        for (int n = 0; n < count; ++n) batch.push_back(n % 2 == 0 ? 0.5f - off : 0.5f + off);
        picture.add(pixel, greys(batch));
    };
    for (std::size_t i = 0; i < picture.size(); ++i) picture.add(i, greys({0.5f})), add(i, 7);
    std::vector<std::uint32_t> chosen;
    do {
        picture.estimate();
        chosen = picture.worst(2.4e-4, 1024);
        for (const std::uint32_t i : chosen) add(i, picture.next_batch(i));
    } while (!chosen.empty());
    EXPECT_GT(picture.error(), 2.4e-4) << "out of reach by the first pixel alone";
    EXPECT_EQ(picture.samples(0), 1024);
    EXPECT_GE(picture.samples(40), 16) << "the others are brought to what is asked for,";
    EXPECT_LE(picture.samples(40), 128) << "and no further";
}

}  // namespace
}  // namespace rt::error_estimate_test
