// Rays of every projection where a formula or a picture of POV-Ray's says what they are.
#include "trace/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "world/compile.h"

namespace rt::camera_test {
namespace {

CameraBasis basis_of(Projection projection, std::optional<double> angle = {}) {
    Camera camera;
    camera.projection = projection;
    camera.location = Vec3(1, 2, 3);
    camera.right = Vec3(1.5, 0, 0);
    camera.angle = angle;
    return camera_basis(camera, Profile::povray, Sources(), [](std::string_view) {});
}

/// Of a picture of 16 x 12 pixels.
Ray ray_of(const CameraBasis& basis, int i, int j) { return camera_ray(basis, i + 0.5, j + 0.5, 16, 12); }

void expect_near(const Vec3& found, const Vec3& expected, double by) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], by) << "component " << i;
}

Vec3 by_angles(double longitude, double latitude) {
    const double a = radians(longitude), b = radians(latitude);
    return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

TEST(WideCamera, AFisheyeSeesACircle) {
    const CameraBasis basis = basis_of(Projection::fisheye, 200.0);
    expect_near(camera_ray(basis, 8, 6, 16, 12).direction, {0, 0, 1}, 1e-15);
    expect_near(camera_ray(basis, 8, 0, 16, 12).direction, by_angles(0, 100), 1e-14);
    const double half = 16 * 0.5 / 1.5;  // the circle is as wide as it is high
    expect_near(camera_ray(basis, 8 + half / 2, 6, 16, 12).direction, by_angles(50, 0), 1e-14);
    EXPECT_FALSE(is_no_ray(camera_ray(basis, 8 + half - 1e-9, 6, 16, 12)));
    EXPECT_TRUE(is_no_ray(camera_ray(basis, 8 + half + 1e-9, 6, 16, 12)));
    EXPECT_TRUE(is_no_ray(ray_of(basis, 0, 0)));
}

TEST(WideCamera, ASphereSeesAllRoundIt) {
    const CameraBasis all = basis_of(Projection::spherical), part = basis_of(Projection::spherical, 100.0);
    expect_near(camera_ray(all, 12, 6, 16, 12).direction, by_angles(90, 0), 1e-15);
    expect_near(camera_ray(all, 2, 3, 16, 12).direction, by_angles(-135, 45), 1e-15);
    expect_near(camera_ray(part, 16, 0, 16, 12).direction, by_angles(50, 25), 1e-15);
    CameraBasis flipped = all;
    flipped.right = -flipped.right;  // POV-Ray turns about it
    expect_near(camera_ray(flipped, 2, 3, 16, 12).direction, by_angles(-135, -45), 1e-15);
}

TEST(WideCamera, CylindersAreStraightAlongTheirAxis) {
    const Vec3 origin(1, 2, 3);
    const auto at = [](Projection projection, double x, double y) { return camera_ray(basis_of(projection, 120.0), x, y, 16, 12); };
    expect_near(at(Projection::cylinder_1, 16, 0).direction, unit(by_angles(60, 0) + Vec3(0, 0.5, 0)), 1e-15);
    expect_near(at(Projection::cylinder_2, 16, 0).direction, unit(by_angles(0, 60) + Vec3(0.75, 0, 0)), 1e-15);
    expect_near(at(Projection::cylinder_3, 16, 0).direction, by_angles(60, 0), 1e-15);
    expect_near(at(Projection::cylinder_3, 16, 0).origin, origin + Vec3(0, 0.5, 0), 1e-15);
    expect_near(at(Projection::cylinder_4, 16, 0).direction, by_angles(0, 60), 1e-15);
    expect_near(at(Projection::cylinder_4, 16, 0).origin, origin + Vec3(0.75, 0, 0), 1e-15);
    expect_near(at(Projection::cylinder_1, 16, 0).origin, origin, 0.0);
}

TEST(WideCamera, AsInPicturesOfPovray) {
    // The pixels of 16-bit pictures whose colours are directions, right 4/3.
    Camera camera;
    camera.right = Vec3(4.0 / 3.0, 0, 0);
    const auto direction = [&](Projection projection, int i, int j) {
        camera.projection = projection;
        return ray_of(camera_basis(camera, Profile::povray, Sources(), [](std::string_view) {}), i, j).direction;
    };
    constexpr double by = 6e-5;
    expect_near(direction(Projection::fisheye, 6, 5), {-0.1950, 0.0650, 0.9787}, by);
    expect_near(direction(Projection::ultra_wide_angle, 0, 0), {-0.6348, 0.4860, 0.6007}, by);
    expect_near(direction(Projection::panoramic, 3, 5), {-0.8466, 0.1081, 0.5211}, by);
    expect_near(direction(Projection::spherical, 0, 0), {-0.0255, 0.9915 * 1.0, -0.1280}, 1e-4);
    expect_near(direction(Projection::cylinder_1, 15, 0), {0.6105, 0.4166, 0.6736}, by);
    expect_near(direction(Projection::cylinder_2, 15, 0), {0.5300, 0.5591, 0.6376}, by);
}

TEST(WideCamera, TheAngleOfAPixelIsThatOfItsMiddle) {
    EXPECT_NEAR(pixel_angle(basis_of(Projection::spherical), 360, 360), radians(1.0), 1e-14);
    EXPECT_NEAR(pixel_angle(basis_of(Projection::cylinder_3, 90.0), 90, 90), radians(1.0), 1e-14);
}

}  // namespace
}  // namespace rt::camera_test
