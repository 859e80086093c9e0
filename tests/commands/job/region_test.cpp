// +SC +EC +SR +ER: pixels from 1, or fractions.
#include <gtest/gtest.h>

#include "commands/job/render_job.h"
#include "core/source.h"

namespace rt::region_test {
namespace {

struct Case {
    RegionEdges edges;
    int width, height;
    int x0, x1, y0, y1;
};

class RegionOf : public testing::TestWithParam<Case> {};

TEST_P(RegionOf, Is) {
    const Case& c = GetParam();
    const std::optional<Region> r = resolve_region(c.edges, c.width, c.height);
    ASSERT_TRUE(r.has_value());
    EXPECT_EQ(r->x0, c.x0);
    EXPECT_EQ(r->x1, c.x1);
    EXPECT_EQ(r->y0, c.y0);
    EXPECT_EQ(r->y1, c.y1);
}

// Rows of a picture of 8: +SR3 +ER5 are rows 3 to 5; +SR0.5 +ER1.0 are rows 5 to 8, as POV-Ray renders them.
INSTANTIATE_TEST_SUITE_P(All, RegionOf,
                         testing::Values(Case{{{}, {}, 3.0, 5.0}, 16, 8, 0, 16, 2, 5},     //
                                         Case{{{}, {}, 0.5, 1.0}, 16, 8, 0, 16, 4, 8},     //
                                         Case{{0.25, 0.5, {}, {}}, 16, 8, 4, 8, 0, 8},     //
                                         Case{{0.3, 0.71, {}, {}}, 10, 8, 3, 7, 0, 8},     //
                                         Case{{1.0, 16.0, 1.0, 8.0}, 16, 8, 0, 16, 0, 8},  //
                                         Case{{16.0, {}, {}, {}}, 16, 8, 15, 16, 0, 8},    //
                                         Case{{0.0, {}, {}, {}}, 16, 8, 0, 16, 0, 8},      //
                                         Case{{{}, 2.0, {}, {}}, 16, 8, 0, 2, 0, 8}));

TEST(RegionOf, NoEdgesAreNoRegion) { EXPECT_FALSE(resolve_region({}, 16, 8).has_value()); }

TEST(RegionOf, RefusesWhatIsNoPartOfThePicture) {
    EXPECT_THROW(resolve_region({{}, 17.0, {}, {}}, 16, 8), OptionError);
    EXPECT_THROW(resolve_region({17.0, {}, {}, {}}, 16, 8), OptionError);
    EXPECT_THROW(resolve_region({10.0, 4.0, {}, {}}, 16, 8), OptionError);
    EXPECT_THROW(resolve_region({{}, {}, {}, 0.0}, 16, 8), OptionError);
    EXPECT_THROW(resolve_region({{}, {}, {}, 9.0}, 16, 8), OptionError);
}

}  // namespace
}  // namespace rt::region_test
