// What a scene's values promise to the lists that hold them.
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace rt {
namespace {

TEST(Scene, AListOfObjectsGrowsWithoutCopies) { EXPECT_TRUE(std::is_nothrow_move_constructible_v<Object>); }

TEST(Scene, CellsAreSharedAndComparedByContent) {
    Pigment white;
    white.content = PigmentColor{Rgb(1.0), 0.0, 0.0};
    const Cells<Pigment> cells(Pigment{}, white);
    const Cells<Pigment> copy = cells;
    EXPECT_EQ(copy.begin(), cells.begin());
    EXPECT_EQ(cells.size(), 2u);
    EXPECT_EQ(cells[1], white);
    EXPECT_EQ(cells, Cells<Pigment>(Pigment{}, white));
    EXPECT_FALSE(cells == Cells<Pigment>(white, white));
    EXPECT_FALSE(cells == Cells<Pigment>());
    EXPECT_THROW(cells.at(2), std::out_of_range);
    EXPECT_EQ(Cells<Pigment>().size(), 0u);
}

}  // namespace
}  // namespace rt
