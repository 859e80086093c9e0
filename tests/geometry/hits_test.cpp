// All hits of a ray with a solid, and its inside: each hit but those of a tube's inner side is where the ray enters or leaves.
#include "geometry/hits.h"

#include <gtest/gtest.h>

#include "geometry/shape.h"
#include "tests/geometry/check_hits.h"

namespace rt::test::hits_test {
namespace {

TEST(Hits, ParityIsTheInside) {
    check_inside(Sphere{{1, 2, 3}, 2.0}, 4.0, 1);
    check_inside(Plane{unit(Vec3(1, 2, 3)), 2.0}, 4.0, 2);
    check_inside(Box{{-1, -2, 0}, {1, 3, 0.5}}, 4.0, 3);
    check_inside(Cone{{0, 0, 0}, 1.0, {1, 2, 3}, 0.25, false}, 4.0, 4);
    check_inside(Cone{{0, -1, 0}, 1.0, {0, 2, 0}, 1.0, false}, 4.0, 5);
    check_inside(Cone{{0, -1, 0}, 1.0, {0, 2, 0}, -0.5, false}, 4.0, 6);
    check_inside(Torus{1.0, 0.25}, 1.5, 7);
    check_inside(Disc{{0, 0, 0}, {0, 1, 0}, 100.0, 0.0}, 4.0, 8);
}

TEST(Hits, EndWhereTheVisitorSaysSo) {
    int visits = 0;
    const auto first = [&](const ShapeHit&) { return ++visits == 1; };
    EXPECT_TRUE(visit_hits(Sphere{}, {{-3, 0, 0}, {1, 0, 0}}, {}, first));
    EXPECT_EQ(visits, 1);
    EXPECT_FALSE(visit_hits(Sphere{}, {{-3, 0, 0}, {1, 0, 0}}, {}, [](const ShapeHit&) { return false; }));
    EXPECT_EQ(all_hits(Sphere{}, {{-3, 0, 0}, {1, 0, 0}}), (std::vector<double>{2, 4}));
    EXPECT_EQ(all_hits(Torus{1.0, 0.25}, {{-3, 0, 0}, {1, 0, 0}}), (std::vector<double>{1.75, 2.25, 3.75, 4.25}));
}

TEST(Hits, SheetsHaveNoInside) {
    EXPECT_TRUE(is_sheet(Triangle{}));
    EXPECT_TRUE(is_sheet(SmoothTriangle{}));
    EXPECT_TRUE(is_sheet(Polygon{}));
    EXPECT_TRUE(is_sheet(Mesh{}));
    EXPECT_FALSE(is_sheet(Disc{}));
    EXPECT_FALSE(is_sheet(Plane{}));
    EXPECT_TRUE(contains(Disc{}, Vec3(50, -1, 0)));
    EXPECT_FALSE(contains(Disc{}, Vec3(0, 1, 0)));
}

}  // namespace
}  // namespace rt::test::hits_test
