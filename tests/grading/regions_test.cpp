// Groups of differing pixels, and what forgives one pixel.
#include <gtest/gtest.h>

#include "grading/neighbourhood.h"
#include "grading/regions.h"
#include "tests/grading/pictures.h"

namespace rt::regions_test {
namespace {

constexpr int width = 20, height = 12;

StoredImage black() { return test::picture(width, height, 3, 255, std::vector<float>(3 * width * height, 0.0f)); }
void fill(StoredImage& image, int x0, int y0, int x1, int y1, float value) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            for (int c = 0; c < 3; ++c) image.values[static_cast<std::size_t>(3 * (y * width + x) + c)] = value;
}

TEST(Regions, TheLargestGroupAndItsMiddle) {
    StoredImage actual = black();
    fill(actual, 1, 1, 3, 3, 255);
    fill(actual, 8, 2, 15, 9, 100);
    const auto region = largest_region(black(), actual, 5.0);
    ASSERT_TRUE(region);
    EXPECT_EQ(region->pixels, 49u);
    EXPECT_EQ(region->x0, 8);
    EXPECT_EQ(region->y0, 2);
    EXPECT_EQ(region->x1, 15);
    EXPECT_EQ(region->y1, 9);
    EXPECT_EQ(region->x, 11) << "the pixel farthest from the edge";
    EXPECT_EQ(region->y, 5);
}

TEST(Regions, DiagonalNeighboursBelongTogether) {
    StoredImage actual = black();
    for (int i = 0; i < 5; ++i) fill(actual, i, i, i + 1, i + 1, 200);
    EXPECT_EQ(largest_region(black(), actual, 5.0)->pixels, 5u);
}

TEST(Regions, NothingBelowTheFuzz) {
    StoredImage actual = black();
    fill(actual, 3, 3, 6, 6, 12);
    EXPECT_FALSE(largest_region(black(), actual, 5.0));
    EXPECT_TRUE(largest_region(black(), actual, 4.0));
    EXPECT_FALSE(largest_region(black(), black(), 0.0));
}

TEST(Regions, TheWholePictureIsOneGroup) {
    StoredImage actual = black();
    fill(actual, 0, 0, width, height, 255);
    const auto region = largest_region(black(), actual, 5.0);
    EXPECT_EQ(region->pixels, static_cast<std::uint64_t>(width * height));
    EXPECT_EQ(region->y, height / 2 - 1);
}

TEST(Neighbourhood, ForgivesAShiftByOnePixel) {
    StoredImage a = black(), shifted = black(), moved_far = black();
    fill(a, 5, 3, 10, 8, 255);
    fill(shifted, 6, 3, 11, 8, 255);
    fill(moved_far, 10, 3, 15, 8, 255);
    EXPECT_EQ(neighbourhood_difference(a, a), 0.0);
    EXPECT_EQ(neighbourhood_difference(a, shifted), 0.0);
    EXPECT_GT(neighbourhood_difference(a, moved_far), 0.05);
}

TEST(Neighbourhood, ASurfaceOfAnotherColourCostsItsDifference) {
    StoredImage a = black(), b = black();
    fill(b, 0, 0, width, height, 51);
    EXPECT_NEAR(neighbourhood_difference(a, b), 0.2, 1e-6);
    EXPECT_NEAR(neighbourhood_difference(b, a), 0.2, 1e-6);
}

TEST(Neighbourhood, IsTakenBothWays) {
    StoredImage a = black(), dot = black();
    fill(dot, 5, 5, 6, 6, 255);
    EXPECT_NEAR(neighbourhood_difference(a, dot), 1.0 / (width * height), 1e-9) << "the dot has no like in the other picture";
    EXPECT_EQ(neighbourhood_difference(a, dot), neighbourhood_difference(dot, a));
}

}  // namespace
}  // namespace rt::regions_test
