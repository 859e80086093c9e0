// What a scene's values promise to the lists that hold them.
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "tests/scene/checkers.h"

namespace rt::scene_test {
namespace {

TEST(Scene, AListOfObjectsGrowsWithoutCopies) { EXPECT_TRUE(std::is_nothrow_move_constructible_v<Object>); }

TEST(Scene, PatternsAreSharedAndComparedByContent) {
    Pigment white, black;
    white.content = PigmentColor{Rgb(1.0), 0.0, 0.0};
    const Pigment checker = checker_of(black, white), copy = checker;
    EXPECT_EQ(&pattern_of(copy), &pattern_of(checker));
    EXPECT_EQ(checker, checker_of(black, white));
    EXPECT_FALSE(checker == checker_of(white, white));
    EXPECT_FALSE(checker == white);
}

}  // namespace
}  // namespace rt::scene_test
