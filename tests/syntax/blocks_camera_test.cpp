#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_camera_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Camera camera(const std::string& body) { return parse_block("camera { " + body + " }").scene.camera; }
ParsedScene with_camera(const std::string& body) { return parse_block("camera { " + body + " }"); }

TEST(CameraBlock, DefaultsAreThoseOfNoCamera) {
    Camera empty = camera("");
    const Camera none = parse_block("").scene.camera;
    empty.span = none.span;
    EXPECT_EQ(empty, none);
    EXPECT_EQ(none.location, Vec3(0.0));
    EXPECT_EQ(none.direction, Vec3(0, 0, 1));
    EXPECT_EQ(none.up, Vec3(0, 1, 0));
    EXPECT_EQ(none.right, Vec3(1.33, 0, 0));
    EXPECT_EQ(none.sky, Vec3(0, 1, 0));
    EXPECT_FALSE(none.look_at || none.angle || none.up_or_right_stated);
}

TEST(CameraBlock, ReadsEveryVectorInAnyOrderAndTheLastOneCounts) {
    const Camera c = camera("look_at <9,8,7> right 2*x sky <1,2,3> direction 2*z location <1,2,-5> up 1.5*y right <1.6,0,0> angle 40");
    EXPECT_EQ(c.location, Vec3(1, 2, -5));
    EXPECT_EQ(c.direction, Vec3(0, 0, 2));
    EXPECT_EQ(c.up, Vec3(0, 1.5, 0));
    EXPECT_EQ(c.right, Vec3(1.6, 0, 0));
    EXPECT_EQ(c.sky, Vec3(1, 2, 3));
    EXPECT_EQ(c.look_at, Vec3(9, 8, 7));
    EXPECT_EQ(c.angle, 40.0);
    EXPECT_TRUE(c.up_or_right_stated);
}

TEST(CameraBlock, UpAloneAndRightAloneCountAsStated) {
    EXPECT_TRUE(camera("up y").up_or_right_stated);
    EXPECT_TRUE(camera("right x").up_or_right_stated);
    EXPECT_FALSE(camera("direction 2*z").up_or_right_stated);
}

TEST(CameraBlock, FloatsPromoteToVectors) { EXPECT_EQ(camera("location -5 look_at 0").location, Vec3(-5.0)); }

TEST(CameraBlock, CylindersAndSpheres) {
    for (const auto& [name, projection] : projection_names) EXPECT_EQ(camera(std::string(name)).projection, projection) << name;
    EXPECT_EQ(camera("cylinder 1.7").projection, Projection::cylinder_1);
    for (const char* number : {"0", "5", "-1"})
        EXPECT_EQ(with_camera(std::string("cylinder ") + number).error, "Invalid cylinder camera type, valid are types 1 to 4.") << number;
    const Camera both = camera("spherical angle 200 80"), comma = camera("spherical angle 200, 80"), one = camera("spherical angle 200");
    EXPECT_EQ(both.angle, 200.0);
    EXPECT_EQ(both.vertical_angle, 80.0);
    EXPECT_EQ(comma.vertical_angle, 80.0);
    EXPECT_FALSE(one.vertical_angle);
    EXPECT_EQ(with_camera("fisheye angle 200 80").error, "No matching } in 'camera', float function 'float constant' found instead");
    EXPECT_EQ(with_camera("fisheye angle -1").error, "Negative viewing angle.");
}

TEST(CameraBlock, TypesComeFirst) {
    EXPECT_EQ(camera("perspective angle 30").projection, Projection::perspective);
    EXPECT_EQ(camera("orthographic up y").projection, Projection::orthographic);
    EXPECT_EQ(camera("perspective orthographic").projection, Projection::orthographic);
    EXPECT_EQ(camera("orthographic orthographic perspective angle 30").projection, Projection::perspective);
    EXPECT_EQ(with_camera("fisheye cylinder 1 perspective location x").error, "");
    EXPECT_EQ(camera("perspective fisheye angle 400").projection, Projection::fisheye);
    EXPECT_EQ(with_camera("omnimax").error, "'omnimax camera' is not modelled.");
    EXPECT_EQ(with_camera("angle 40 perspective").error, "No matching } in 'camera', perspective found instead");
    EXPECT_EQ(with_camera("right x orthographic").error, "Expected 'perspective camera modifier', orthographic found instead");
    EXPECT_EQ(with_camera("orthographic angle 3 perspective").error, "Expected 'orthographic camera modifier', perspective found instead");
}

TEST(CameraBlock, AngleNeedsNoNumberWhereOrthographic) {
    EXPECT_EQ(camera("orthographic angle up y").angle, 0.0);
    EXPECT_EQ(camera("orthographic angle 25").angle, 25.0);
    EXPECT_EQ(with_camera("angle up y").error, "Expected 'numeric expression', up found instead");
}

TEST(CameraBlock, AnglesOutOfRangeAreErrors) {
    EXPECT_EQ(with_camera("angle 179.9 look_at z").error, "");
    EXPECT_EQ(with_camera("angle 180").error, "Viewing angle has to be smaller than 180 degrees.");
    EXPECT_EQ(with_camera("orthographic angle 200").error, "Viewing angle has to be smaller than 180 degrees.");
    EXPECT_EQ(with_camera("angle -1").error, "Negative viewing angle.");
}

TEST(CameraBlock, TransformsAreGatheredInOrder) {
    const Camera c = camera("translate x look_at <0,0,9> scale 2 location <0,0,-5>");
    EXPECT_EQ(c.transform.point(Vec3(1, 1, 1)), Vec3(4, 2, 2));
}

TEST(CameraBlock, ADeclaredCameraTakesOnlyTransforms) {
    const ParsedScene p = parse_block("#declare C = camera { location <1,2,3> translate x } camera { C translate y }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(p.scene.camera.location, Vec3(1, 2, 3));
    EXPECT_EQ(p.scene.camera.transform.point(Vec3(0.0)), Vec3(1, 1, 0));
    EXPECT_EQ(parse_block("#declare C = camera { } camera { C look_at 0 }").error, "No matching } in 'camera', look_at found instead");
    EXPECT_EQ(parse_block("#declare C = camera { } camera { location x C }").error,
              "No matching } in 'camera', camera identifier found instead");
}

TEST(CameraBlock, LookAtAtTheLocationIsAnError) {
    const std::string text = "Camera location and look_at point must be different.";
    EXPECT_EQ(with_camera("location <1,2,3> look_at <1,2,3>").error, text);
    EXPECT_EQ(with_camera("look_at 1e-11*x").error, text);
    EXPECT_EQ(with_camera("look_at 1e-5*x").error, "");
}

TEST(CameraBlock, WarnsOfSkyAlongTheView) {
    EXPECT_THAT(with_camera("location 5*y look_at 0").messages, ElementsAre(HasSubstr("sky direction should be different")));
    EXPECT_THAT(with_camera("sky 0 look_at z").messages, ElementsAre(HasSubstr("sky direction should be different")));
    EXPECT_THAT(with_camera("location <1,5,0> look_at 0").messages, IsEmpty());
}

TEST(CameraBlock, WarnsOfVectorsThatAreNotPerpendicular) {
    const auto warning = ElementsAre(HasSubstr("Camera vectors are not perpendicular."));
    EXPECT_THAT(with_camera("up <1e-9,1,0>").messages, warning);
    EXPECT_THAT(with_camera("right <1,0,1>").messages, warning);
    EXPECT_THAT(with_camera("scale <1,2,1> rotate 45*z scale <1,2,1>").messages, warning);
    EXPECT_THAT(with_camera("up <1,1,0> look_at 5*z").messages, IsEmpty());
    EXPECT_THAT(with_camera("location <1,2,3> look_at <-4,0.1,7> rotate <10,20,30>").messages, IsEmpty());
    EXPECT_THAT(with_camera("up 0 right 0").messages, IsEmpty());
}

TEST(CameraBlock, TheLastOfTwoCamerasCounts) {
    const ParsedScene p = parse_block("camera { location x } camera { location y }");
    EXPECT_EQ(p.scene.camera.location, Vec3(0, 1, 0));
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("More than one camera in scene. Ignoring previous camera(s).")));
}

TEST(CameraBlock, FocalBlurIsNotModelledUnlessItIsNone) {
    EXPECT_EQ(with_camera("aperture 0 blur_samples 4, 9 focal_point 0 confidence 0.9 variance 0.1").error, "");
    EXPECT_EQ(with_camera("aperture 0.4 blur_samples 10").error, "'aperture' is not modelled.");
    ParseOptions lenient;
    lenient.lenient = true;
    const ParsedScene p = parse_block("camera { fisheye angle 220 location x }", lenient);
    EXPECT_EQ(p.error, "");
    EXPECT_EQ(p.scene.camera.location, Vec3(1, 0, 0));
}

}  // namespace
}  // namespace rt::blocks_camera_test
