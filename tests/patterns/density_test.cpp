// The format of .df3 files; the values between their numbers are compared in values_test.cpp.
#include "patterns/density.h"

#include <gtest/gtest.h>

#include <string>

namespace rt::density_test {
namespace {

std::string header(char x, char y, char z) { return {0, x, 0, y, 0, z}; }

TEST(Density, NumbersOfOneTwoAndFourBytes) {
    const std::string one = header(2, 1, 1) + std::string("\x33\xff", 2);
    const std::string two = header(2, 1, 1) + std::string("\x33\x33\xff\xff", 4);
    const std::string four = header(2, 1, 1) + std::string("\x33\x33\x33\x33\xff\xff\xff\xff", 8);
    for (const std::string& file : {one, two, four}) {
        const auto grid = read_df3(file);
        ASSERT_TRUE(grid) << file.size();
        EXPECT_EQ(grid->width, 2);
        EXPECT_EQ(grid->depth, 1);
        EXPECT_EQ(grid->values, (std::vector<float>{0.2F, 1.0F}));
    }
}

TEST(Density, OtherLengthsAreNoDensity) {
    EXPECT_FALSE(read_df3(""));
    EXPECT_FALSE(read_df3("abcde"));
    EXPECT_FALSE(read_df3(header(2, 2, 2) + "abc"));
    EXPECT_FALSE(read_df3(header(2, 2, 2) + std::string(24, 'x')));
    EXPECT_FALSE(read_df3(std::string(6, '\xff') + "much too short"));
}

TEST(Density, AGridOfNothingIsZero) {
    const auto grid = read_df3(header(0, 2, 2));
    ASSERT_TRUE(grid);
    EXPECT_EQ(density({*grid, 1}, {.5, .5, .5}), 0.0);
}

TEST(Density, OutsideTheCubeItIsZero) {
    const DensityNumbers numbers{*read_df3(header(1, 1, 1) + "\xff"), 1};
    EXPECT_EQ(density(numbers, {.5, 0, .99}), 1.0);
    for (const Vec3& p : {Vec3(-.01, .5, .5), Vec3(.5, 1, .5), Vec3(.5, .5, 2)}) EXPECT_EQ(density(numbers, p), 0.0);
}

}  // namespace
}  // namespace rt::density_test
