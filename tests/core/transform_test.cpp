// POV-Ray's transforms, each formula written out for a point.
#include "core/transform.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rt::transform_test {
namespace {

void expect_near(const Vec3& found, const Vec3& expected, double tolerance = 1e-14) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

const Vec3 p{1.5, -2.0, 0.75};

TEST(Transform, TranslateAndScale) {
    expect_near(Transform::translate({1, 2, 3}).point(p), {2.5, 0, 3.75}, 0.0);
    expect_near(Transform::translate({1, 2, 3}).direction(p), p, 0.0);
    expect_near(Transform::scale({2, -3, 4}).point(p), {3, 6, 3}, 0.0);
}

TEST(Transform, RotatesAboutOneAxisByTheLeftHandRule) {
    for (const double degrees : {0.0, 17.0, 90.0, -123.0, 180.0, 270.0, 360.0, 1e6 + 0.5}) {
        const long double a = static_cast<long double>(degrees) * 3.14159265358979323846264338327950288L / 180.0L;
        const double s = static_cast<double>(std::sin(a)), c = static_cast<double>(std::cos(a));
        const double tolerance = 1e-15 * std::fmax(4.0, std::fabs(degrees));
        for (const Rotation convention : {Rotation::povray, Rotation::csc473}) {
            expect_near(Transform::rotate({degrees, 0, 0}, convention).point(p), {p.x, p.y * c - p.z * s, p.y * s + p.z * c}, tolerance);
            expect_near(Transform::rotate({0, degrees, 0}, convention).point(p), {p.x * c + p.z * s, p.y, -p.x * s + p.z * c}, tolerance);
            expect_near(Transform::rotate({0, 0, degrees}, convention).point(p), {p.x * c - p.y * s, p.x * s + p.y * c, p.z}, tolerance);
        }
    }
}

TEST(Transform, QuarterTurnsAreExact) {
    expect_near(Transform::rotate({0, 0, 90}, Rotation::povray).point({1, 0, 0}), {0, 1, 0}, 0.0);
    expect_near(Transform::rotate({90, 0, 0}, Rotation::povray).point({0, 1, 0}), {0, 0, 1}, 0.0);
    expect_near(Transform::rotate({0, 90, 0}, Rotation::povray).point({0, 0, 1}), {1, 0, 0}, 0.0);
    expect_near(Transform::rotate({-90, 540, 0}, Rotation::povray).point({1, 2, 3}), {-1, 3, 2}, 0.0);
}

TEST(Transform, PovrayTurnsAboutXThenYThenZ) {
    // POV-Ray prints this for vrotate(<1,2,3>, <10,20,30>).
    expect_near(Transform::rotate({10, 20, 30}, Rotation::povray).point({1, 2, 3}), {1.06743, 2.28906, 2.76058}, 5e-6);
}

TEST(Transform, TheCourseTurnsAboutZThenYThenX) {
    const auto one = [](const Vec3& degrees) { return Transform::rotate(degrees, Rotation::csc473); };
    const Transform steps = one({0, 0, 30}).then(one({0, 20, 0})).then(one({10, 0, 0}));
    expect_near(one({10, 20, 30}).point(p), steps.point(p));
    EXPECT_GT(length(one({10, 20, 30}).point(p) - Transform::rotate({10, 20, 30}, Rotation::povray).point(p)), 0.1);
}

TEST(Transform, MatrixRowsAreTheImagesOfTheAxes) {
    const double m[12] = {1, .3, 0, -.2, .9, .1, 0, .2, 1.1, .1, .2, .3};
    const Transform t = Transform::matrix(m);
    expect_near(t.point(p), {p.x * 1 + p.y * -.2 + p.z * 0 + .1, p.x * .3 + p.y * .9 + p.z * .2 + .2, p.x * 0 + p.y * .1 + p.z * 1.1 + .3});
    expect_near(t.direction({0, 1, 0}), {-.2, .9, .1}, 0.0);
    expect_near(t.inverse_point(t.point(p)), p);
}

TEST(Transform, SingularMatricesAreRefusedAndTinyOnesAreNot) {
    const double flat[12] = {1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 0};
    EXPECT_THROW(Transform::matrix(flat), std::domain_error);
    const double zero[12] = {};
    EXPECT_THROW(Transform::matrix(zero), std::domain_error);
    const double tiny[12] = {1e-150, 0, 0, 0, 1e-150, 0, 0, 0, 2e-150, 0, 0, 0};
    expect_near(Transform::matrix(tiny).inverse_point({1e-150, 0, 4e-150}), {1, 0, 2});
}

TEST(Transform, StepsApplyInTheOrderWritten) {
    const Transform t =
        Transform::scale({2, 2, 2}).then(Transform::translate({1, 0, 0})).then(Transform::rotate({0, 0, 90}, Rotation::povray));
    expect_near(t.point({1, 0, 0}), {0, 3, 0});
    expect_near(t.inverse().point(t.point(p)), p);
    EXPECT_TRUE(Transform::translate({1, 2, 3}).then(Transform::translate({-1, -2, -3})).is_identity());
}

TEST(Transform, InverseOfAProductOfExtremeScalesStaysExact) {
    Transform t;
    for (int i = 0; i < 40; ++i) t = t.then(Transform::scale({1e6, 1e-6, 1e3})).then(Transform::scale({1e-6, 1e6, 1e-3}));
    expect_near(t.inverse_point(t.point(p)), p, 1e-13);
}

TEST(Transform, NormalsStayPerpendicularToTheSurface) {
    const double m[12] = {1, .3, 0, -.2, .9, .1, 0, .2, 1.1, .1, .2, .3};
    const Transform t = Transform::matrix(m).then(Transform::scale({1, -5, .2}));
    const Vec3 u{1, 2, -1}, v{0.5, -1, 3};
    const Vec3 n = t.normal(cross(u, v));
    EXPECT_NEAR(dot(n, t.direction(u)), 0.0, 1e-13);
    EXPECT_NEAR(dot(n, t.direction(v)), 0.0, 1e-13);
}

TEST(Transform, BoundsHoldTheImageOfTheBox) {
    const Transform t = Transform::rotate({20, 30, 40}, Rotation::povray).then(Transform::translate({5, 0, 0}));
    const Bounds image = t.bounds({Vec3(-1), Vec3(1)});
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 q = t.point({corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0});
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(q[i] >= image.min[i] && q[i] <= image.max[i]);
    }
    EXPECT_FALSE(t.bounds(Bounds::everything()).is_finite());
}

}  // namespace
}  // namespace rt::transform_test
