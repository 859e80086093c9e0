#include "core/spline.h"

#include <gtest/gtest.h>

namespace rt::spline_test {
namespace {

using Kind = Spline::Kind;

Spline spline_of(std::vector<Spline::Point> points) {
    Spline s{.size = 3, .points = std::move(points)};
    s.arrange();
    return s;
}

/// Unevenly spaced, out of order.
const Spline uneven = spline_of({{3.5, {0, 0, 0}}, {0, {1, 2, 3}}, {1, {4, 7, 6}}, {3, {-2, 0, 1}}});

void expect_values(Kind kind, double t, double x, double y, double z) {
    const std::array<double, 5> v = evaluate(uneven, t, kind);
    EXPECT_NEAR(v[0], x, 5e-7) << t;
    EXPECT_NEAR(v[1], y, 5e-7) << t;
    EXPECT_NEAR(v[2], z, 5e-7) << t;
}

/// Figures: measured on POV-Ray.
TEST(Spline, PassesThroughItsPointsAsItsKindSays) {
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::natural}) {
        expect_values(kind, -1, 1, 2, 3);
        expect_values(kind, 0, 1, 2, 3);
        expect_values(kind, 1, 4, 7, 6);
        expect_values(kind, 3, -2, 0, 1);
        expect_values(kind, 4, 0, 0, 0);
    }
    expect_values(Kind::linear, 0.25, 1.75, 3.25, 3.75);
    expect_values(Kind::natural, 0.5, 3.134615, 5.213942, 4.911058);
    expect_values(Kind::natural, 1.5, 2.774038, 6.378606, 5.683894);
    expect_values(Kind::natural, 2.5, -1.639423, 1.616587, 2.570913);
    expect_values(Kind::quadratic, 0.5, 3, 5.208333, 4.958333);
    expect_values(Kind::quadratic, 1.5, 4, 7.375, 6.125);
    expect_values(Kind::quadratic, 2.5, 1, 3.875, 3.625);
    expect_values(Kind::cubic, 0.5, 4, 7, 6);
    expect_values(Kind::cubic, 1.5, 3.015625, 6.281250, 5.5);
    expect_values(Kind::cubic, 2.5, -1.203125, 1.656250, 2.4375);
    expect_values(Kind::cubic, 3.25, -2, 0, 1);
}

TEST(Spline, OfFewPointsIsAsSmoothAsTheyAllow) {
    const Spline two = spline_of({{0, {1, 0, 0}}, {1, {0, 1, 0}}}), one = spline_of({{0, {7, 0, 0}}});
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::natural}) EXPECT_EQ(evaluate(two, 0.25, kind)[0], 0.75);
    for (const double t : {-1.0, 0.0, 0.25, 1.0, 2.0}) EXPECT_EQ(evaluate(two, t, Kind::cubic)[0], 0.5);
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::cubic, Kind::natural}) EXPECT_EQ(evaluate(one, 3, kind)[0], 7.0);
}

TEST(Spline, KeepsTheLastOfPointsAtTheSamePlace) {
    const Spline s = spline_of({{0, {1}}, {1, {5}}, {0, {2}}, {0, {3}}});
    ASSERT_EQ(s.points.size(), 2u);
    EXPECT_EQ(s.points[0].value[0], 3.0);
}

}  // namespace
}  // namespace rt::spline_test
