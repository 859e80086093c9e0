#include "patterns/map.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace rt::map_test {
namespace {

constexpr std::array<double, 4> positions{0.2, 0.5, 0.5, 0.9};

void expect_place(double value, std::size_t lower, std::size_t upper, double weight) {
    const MapPlace place = find_in_map(positions, value);
    EXPECT_EQ(place.lower, lower) << value;
    EXPECT_EQ(place.upper, upper) << value;
    EXPECT_DOUBLE_EQ(place.weight, weight) << value;
}

TEST(Map, BetweenTwoEntries) {
    expect_place(0.35, 0, 1, 0.5);
    expect_place(0.6, 2, 3, 0.25);
}

TEST(Map, OutsideItIsTheFirstOrTheLast) {
    expect_place(-1.0, 0, 0, 0.0);
    expect_place(0.2, 0, 0, 0.0);
    expect_place(0.9, 3, 3, 0.0);
    expect_place(7.0, 3, 3, 0.0);
}

TEST(Map, AtAJumpTheLowerSideHasTheValue) {
    expect_place(0.5, 0, 1, 1.0);
    expect_place(0.5 + 1e-15, 2, 3, (0.5 + 1e-15 - 0.5) / 0.4);
}

TEST(Map, WhatIsNoNumberIsTheFirst) { expect_place(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0.0); }

TEST(Map, OneEntryIsEverywhere) {
    const std::array<double, 1> one{0.4};
    for (const double v : {-1.0, 0.4, 2.0}) EXPECT_EQ(find_in_map(one, v).upper, 0U);
}

TEST(Map, EntriesInTheWrongOrderAreNotLeft) {
    const std::array<double, 3> falling{0.9, 0.1, 0.5};
    for (double v = -0.5; v < 1.5; v += 0.1) EXPECT_LT(find_in_map(falling, v).upper, 3U);
}

TEST(Map, BuiltInMapsAscend) {
    for (int kind = 0; kind <= static_cast<int>(PatternKind::wrinkles); ++kind) {
        const auto map = default_color_map(static_cast<PatternKind>(kind));
        ASSERT_GE(map.size(), 2U);
        for (std::size_t i = 1; i < map.size(); ++i) EXPECT_LE(map[i - 1].value, map[i].value) << name(static_cast<PatternKind>(kind));
    }
    EXPECT_EQ(default_color_map(PatternKind::agate)[1].color, Rgb(0.95, 0.75, 0.5));
    EXPECT_EQ(default_color_map(PatternKind::granite)[1].color, Rgb(1.0));
}

TEST(Map, BuiltInColoursOfCells) {
    EXPECT_EQ(default_cell_colors(PatternKind::checker).size(), 2U);
    EXPECT_EQ(default_cell_colors(PatternKind::checker)[0], Rgb(0, 0, 1));
    EXPECT_EQ(default_cell_colors(PatternKind::hexagon)[2], Rgb(1, 0, 0));
    EXPECT_EQ(default_cell_colors(PatternKind::square)[3], Rgb(1, 1, 0));
    EXPECT_EQ(default_cell_colors(PatternKind::triangular)[5], Rgb(1, 0, 1));
    EXPECT_EQ(default_cell_colors(PatternKind::brick)[1], Rgb(0.6, 0.15, 0.15));
    EXPECT_TRUE(default_cell_colors(PatternKind::bozo).empty());
}

}  // namespace
}  // namespace rt::map_test
