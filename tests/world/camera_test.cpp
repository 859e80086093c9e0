// Camera bases against numbers worked out by hand or by the formulas in long double.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "world/compile.h"

namespace rt::camera_test {
namespace {

using testing::HasSubstr;

struct Basis {
    CameraBasis basis;
    std::vector<std::string> warnings;
};

Basis basis_of(const Camera& camera, Profile profile = Profile::povray) {
    Basis result;
    result.basis = camera_basis(camera, profile, Sources(), [&](std::string_view text) { result.warnings.emplace_back(text); });
    return result;
}

void expect_near(const Vec3& found, const Vec3& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-14 * std::fmax(1.0, length(expected))) << "component " << i;
}

TEST(Camera, WithoutAnyStatement) {
    const auto [basis, warnings] = basis_of(Camera{});
    expect_near(basis.origin, {0, 0, 0});
    expect_near(basis.direction, {0, 0, 1});
    expect_near(basis.right, {1.33, 0, 0});
    expect_near(basis.up, {0, 1, 0});
    EXPECT_EQ(basis.projection, Projection::perspective);
    EXPECT_TRUE(warnings.empty());
}

TEST(Camera, AngleSpansTheWidthOfRightAndOverridesTheLengthOfDirection) {
    Camera camera;
    camera.angle = 90.0;
    camera.right = {2.0, 0, 0};
    camera.direction = {0, 0, 17.0};
    expect_near(basis_of(camera).basis.direction, {0, 0, 1});  // half of the width, tan 45 = 1
    camera.angle = 0.0;
    expect_near(basis_of(camera).basis.direction, {0, 0, 17});
}

TEST(Camera, LookAtKeepsLengthsAndTurnsTheBasis) {
    Camera camera;
    camera.location = {0, 0, -5};
    camera.look_at = Vec3(5, 0, 0);
    camera.direction = {0, 0, 2.0};
    camera.up = {0, 1.5, 0};
    const CameraBasis basis = basis_of(camera).basis;
    const double h = std::sqrt(0.5);
    expect_near(basis.direction, {2 * h, 0, 2 * h});
    expect_near(basis.up, {0, 1.5, 0});
    expect_near(basis.right, {1.33 * h, 0, -1.33 * h});
}

TEST(Camera, ALeftwardRightStaysMirrored) {
    Camera camera;
    camera.location = {0, 0, -5};
    camera.look_at = Vec3(0, 0, 0);
    camera.right = {-4.0 / 3.0, 0, 0};
    expect_near(basis_of(camera).basis.right, {-4.0 / 3.0, 0, 0});
    camera.sky = {0, -1, 0};  // stands on its head: right goes the other way, up down
    expect_near(basis_of(camera).basis.right, {4.0 / 3.0, 0, 0});
    expect_near(basis_of(camera).basis.up, {0, -1, 0});
}

TEST(Camera, SkyAlongTheViewWarnsAndKeepsRight) {
    Camera camera;
    camera.location = {0, 5, 0};
    camera.look_at = Vec3(0, 0, 0);
    const auto [basis, warnings] = basis_of(camera);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("look_at direction and sky direction should be different"));
    expect_near(basis.direction, {0, -1, 0});
    expect_near(basis.right, {1.33, 0, 0});
    expect_near(basis.up, {0, 0, 1});
}

TEST(Camera, SkewedVectorsWarn) {
    Camera camera;
    camera.up = {0.1, 1, 0};
    camera.direction = {0, 0.2, 1.5};
    const auto [basis, warnings] = basis_of(camera);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("Camera vectors are not perpendicular. Making look_at the last statement may help."));
    expect_near(basis.up, {0.1, 1, 0});
}

TEST(Camera, TransformsComeLast) {
    Camera camera;
    camera.location = {0, 0, -5};
    camera.look_at = Vec3(0, 0, 0);
    camera.transform = Transform::rotate({0, 90, 0}, Rotation::povray).then(Transform::translate({1, 2, 3}));
    const CameraBasis basis = basis_of(camera).basis;
    expect_near(basis.origin, {-5 + 1, 2, 3});
    expect_near(basis.direction, {1, 0, 0});
    expect_near(basis.right, {0, 0, -1.33});
}

TEST(Camera, OrthographicIsSizedByTheDistanceUnlessStated) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.location = {0, 0, -5};
    camera.look_at = Vec3(0, 0, 0);
    camera.direction = {0, 0, 2};
    CameraBasis basis = basis_of(camera).basis;
    EXPECT_EQ(basis.projection, Projection::orthographic);
    expect_near(basis.right, {1.33 * 2.5, 0, 0});
    expect_near(basis.up, {0, 2.5, 0});

    camera.up_or_right_stated = true;
    basis = basis_of(camera).basis;
    expect_near(basis.right, {1.33, 0, 0});

    camera.angle = 60.0;  // stated with up and right: sized again, by the direction that the angle gives
    basis = basis_of(camera).basis;
    expect_near(basis.right, {2 * 5 * std::tan(pi / 6), 0, 0});

    camera.look_at.reset();  // then it is <0,0,1>
    camera.angle.reset();
    camera.up_or_right_stated = false;
    expect_near(basis_of(camera).basis.up, {0, 3, 0});
}

TEST(Camera, CourseTakesRightAndUpAsTheyAre) {
    Camera camera;
    camera.location = {1, 2, 3};
    camera.look_at = Vec3(1, 2, -7);
    camera.right = {1.3, 0.2, 0};
    camera.up = {0, 3, 1};
    const CameraBasis basis = basis_of(camera, Profile::csc473).basis;
    expect_near(basis.origin, {1, 2, 3});
    expect_near(basis.direction, {0, 0, -1});
    expect_near(basis.right, {1.3, 0.2, 0});
    expect_near(basis.up, {0, 3, 1});
}

TEST(Camera, RefusesWhatHasNoDirection) {
    Camera camera;
    camera.look_at = camera.location;
    for (const Profile profile : {Profile::povray, Profile::csc473}) {
        try {
            basis_of(camera, profile);
            FAIL();
        } catch (const SceneError& error) {
            EXPECT_STREQ(error.what(), "Parse Error: Camera location and look_at point must be different.");
        }
    }
    camera.look_at.reset();
    camera.angle = 180.0;
    EXPECT_THROW(basis_of(camera), SceneError);
    camera.angle = -1.0;
    EXPECT_THROW(basis_of(camera), SceneError);
}

}  // namespace
}  // namespace rt::camera_test
