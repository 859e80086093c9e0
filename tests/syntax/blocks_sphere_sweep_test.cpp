// sphere_sweep { }
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_sphere_sweep_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string error_of(const std::string& inside) { return parse_block("sphere_sweep { " + inside + " }").error; }
std::vector<SweepPiece> pieces_of(const std::string& inside) {
    return *std::get<SphereSweep>(only_shape<FurtherShape>("sphere_sweep { " + inside + " }")).pieces;
}

TEST(SphereSweepBlock, HasAPieceBetweenTwoSpheres) {
    const std::vector<SweepPiece> lines = pieces_of("linear_spline, 3, 0, 1, x 0.5 2*x, 0.25 tolerance 0.1 scale 2");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[1].center[0], Vec3(1, 0, 0));
    EXPECT_EQ(lines[1].radius[3], 0.25);
    const std::string five = "5, 0, 1, x, 2, 2*x, 3, 3*x, 4, 4*x, 5";
    ASSERT_EQ(pieces_of("cubic_spline " + five).size(), 2u);
    EXPECT_EQ(pieces_of("cubic_spline " + five)[0].radius[0], 2.0);
    EXPECT_EQ(pieces_of("b_spline " + five)[1].radius[0], 3.0) << "of equal steps";
}

TEST(SphereSweepBlock, Mistakes) {
    EXPECT_EQ(error_of("2 0, 1 x, 1"), "Invalid type of interpolation.");
    EXPECT_EQ(error_of("quadratic_spline 4 0, 1 x, 1 y, 1 z, 1"), "Invalid type of interpolation.");
    for (const char* const few : {"linear_spline 1 0, 1", "cubic_spline 3 0, 1 x, 1 y, 1", "b_spline 3 0, 1 x, 1 y, 1"})
        EXPECT_EQ(error_of(few), "Too few modeling spheres for interpolation type.");
    EXPECT_EQ(error_of("linear_spline 2, 0, 1, x, 1, tolerance 1"), "No matching } in 'sphere_sweep', , found instead");
    EXPECT_EQ(error_of("linear_spline 2, 0, 1, x, 1 pigment { rgb 1 } tolerance 1"),
              "No matching } in 'sphere_sweep', tolerance found instead");
    EXPECT_EQ(error_of("linear_spline 2, 0, 1, x, 1 sturm"), "Keyword 'sturm' cannot be used with this object.");
    EXPECT_THAT(parse_block("sphere_sweep { linear_spline 2, 0, 1, x, -1 }").messages,
                ElementsAre(HasSubstr("POV-Ray shows only a part of a sphere sweep with negative radii. It is drawn whole.")));
}

}  // namespace
}  // namespace rt::blocks_sphere_sweep_test
