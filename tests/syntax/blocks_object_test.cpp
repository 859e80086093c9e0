#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/checkers.h"
#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_object_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Object only(const std::string& text) { return parse_block(text).scene.objects.at(0); }
std::string error_of(const std::string& text) { return parse_block(text).error; }

TEST(ObjectFlags, AreOffUnlessStated) {
    const Object o = sphere_with("");
    EXPECT_FALSE(o.no_shadow || o.no_image || o.no_reflection || o.double_illuminate || o.inverse || o.hollow);
    EXPECT_FALSE(o.transform || o.interior || o.interior_texture);
    EXPECT_TRUE(o.texture);
}

TEST(ObjectFlags, TakeAnOptionalBool) {
    const Object on = sphere_with("no_shadow no_image no_reflection double_illuminate hollow");
    EXPECT_TRUE(on.no_shadow && on.no_image && on.no_reflection && on.double_illuminate && on.hollow);
    const Object off = sphere_with("no_image off no_reflection 0 double_illuminate no hollow false");
    EXPECT_FALSE(off.no_image || off.no_reflection || off.double_illuminate || off.hollow);
    EXPECT_EQ(error_of("sphere { 0, 1 no_shadow off }"), "No matching } in 'sphere', float function 'off' found instead");
    EXPECT_TRUE(sphere_with("hollow 1 + 0 scale 2").transform);
}

TEST(ObjectFlags, InverseTurnsRound) {
    EXPECT_TRUE(sphere_with("inverse").inverse);
    EXPECT_FALSE(sphere_with("inverse inverse").inverse);
    EXPECT_EQ(error_of("sphere { 0, 1 inverse off }"), "No matching } in 'sphere', float function 'off' found instead");
}

TEST(ObjectModifiers, HintsAreReadAndHaveNoEffect) {
    EXPECT_EQ(error_of("sphere { 0, 1 bounded_by { box { -1, 1 } } no_radiosity off photons { target } radiosity { importance 1 } }"), "");
    EXPECT_EQ(error_of("sphere { 0, 1 sturm }"), "Keyword 'sturm' cannot be used with this object.");
    EXPECT_EQ(error_of("sphere { 0, 1 hierarchy }"), "Keyword 'hierarchy' cannot be used with this object.");
    EXPECT_EQ(error_of("sphere { 0, 1 cutaway_textures }"), "cutaway_textures can only be used with intersection and difference.");
    EXPECT_EQ(error_of("sphere { 0, 1 light_source { 0 rgb 1 } }"), "Light source must be defined using new syntax.");
    EXPECT_THAT(parse_block("sphere { 0, 1 rgb 1 }").messages, ElementsAre(HasSubstr("Quick color belongs in texture. Color ignored.")));
}

TEST(ObjectTransforms, ComposeInOrder) {
    EXPECT_EQ(sphere_with("translate x scale 2 translate <0,0,1>").transform->point(Vec3(1, 1, 1)), Vec3(4, 2, 3));
}

TEST(ObjectTransforms, MoveTheTexturesThatAreThereAlready) {
    const Object o = sphere_with("pigment { checker } scale 2 translate x");
    EXPECT_EQ(moved(layer(o).pigment, Vec3(1.0)), Vec3(3, 2, 2));
    EXPECT_EQ(o.transform->point(Vec3(1.0)), Vec3(3, 2, 2));
    EXPECT_EQ(moved(layer(sphere_with("scale 2 pigment { checker }")).pigment, Vec3(1.0)), Vec3(1.0));
    const Object between = sphere_with("scale 2 pigment { checker } translate x pigment { scale 3 }");
    EXPECT_EQ(moved(layer(between).pigment, Vec3(1.0)), Vec3(6, 3, 3));
}

TEST(ObjectTransforms, DoNotMoveTheDefaultTexture) {
    EXPECT_EQ(moved(layer(only("#default { pigment { checker } } sphere { 0, 1 scale 2 }")).pigment, Vec3(1.0)), Vec3(1.0));
}

TEST(ObjectTransforms, APlainTextureIsSharedByObjectsHoweverTheyAreMoved) {
    const ParsedScene p = parse_block(
        "#declare T = texture { pigment { rgb 1 } } sphere { 0, 1 texture { T } translate x } sphere { 0, 1 texture { T } translate y }");
    EXPECT_EQ(p.scene.objects.at(0).texture->identity(), p.scene.objects.at(1).texture->identity());
}

TEST(ObjectTextures, AreSharedWhereTheyAreEqualAndPlain) {
    const auto shared = [](const std::string& first, const std::string& second) {
        const ParsedScene p = parse_block("sphere { 0, 1 " + first + " } sphere { 0, 1 " + second + " }");
        return p.scene.objects.at(0).texture->identity() == p.scene.objects.at(1).texture->identity();
    };
    const std::string red = "pigment { rgb <1, 0, 0> } finish { phong 1 }";
    EXPECT_TRUE(shared(red, red));
    EXPECT_TRUE(shared(red, "finish { phong 1 } pigment { rgb x }"));
    EXPECT_FALSE(shared(red, "pigment { rgb <1, 0, 0> } finish { phong 0.5 }"));
    EXPECT_FALSE(shared(red, "pigment { rgb <1, 0, 0.001> } finish { phong 1 }"));
    EXPECT_FALSE(shared("pigment { rgb <1, 0, 0> }", "pigment { rgb <1, -0, 0> }")) << "sceneinfo prints the sign";
    EXPECT_FALSE(shared("pigment { checker }", "pigment { checker }"));
    EXPECT_FALSE(shared("pigment { checker }", "pigment { rgb 1 }"));
    EXPECT_FALSE(shared("texture { " + red + " } texture { " + red + " }", "texture { " + red + " } texture { " + red + " }"));
}

TEST(ObjectTransforms, MatterToAPatternThatReplacesAPlainColour) {
    const Object o = sphere_with("pigment { rgb 1 } scale 2 pigment { checker }");
    EXPECT_EQ(moved(layer(o).pigment, Vec3(1.0)), Vec3(2.0));
}

TEST(ObjectTransforms, InteriorTexturesMoveToo) {
    const Object o = sphere_with("pigment { rgb 1 } interior_texture { pigment { checker } } translate x");
    const PlainTexture inner = std::get<PlainTexture>((*o.interior_texture)->at(0).content);
    EXPECT_EQ(moved(inner.pigment, Vec3(0.0)), Vec3(1, 0, 0));
}

TEST(ObjectBlock, PlacesDeclaredObjects) {
    const ParsedScene p =
        parse_block("#declare S = sphere { 0, 1 no_shadow } S object { S scale 2 pigment { rgb 1 } } object { object { S } }");
    ASSERT_EQ(p.error, "");
    ASSERT_EQ(p.scene.objects.size(), 3u);
    EXPECT_TRUE(p.scene.objects[1].no_shadow);
    EXPECT_EQ(color_of(p.scene.objects[1]).rgb, Rgb(1.0));
    EXPECT_EQ(p.scene.objects[1].transform->point(Vec3(1.0)), Vec3(2.0));
    EXPECT_FALSE(p.scene.objects[0].transform);
    EXPECT_TRUE(p.scene.objects[2].texture);
}

TEST(ObjectBlock, NeedsExactlyOneObject) {
    EXPECT_EQ(error_of("object { }"), "Expected 'object', } found instead");
    EXPECT_EQ(error_of("object { foo }"), "Expected 'object', undeclared identifier 'foo' found instead");
    EXPECT_EQ(error_of("object { 3 }"), "Expected 'object', float function 'float constant' found instead");
    EXPECT_EQ(error_of("object { sphere { 0, 1 } sphere { 0, 1 } }"), "No matching } in 'object', sphere found instead");
    EXPECT_EQ(error_of("object { camera { } }"), "Expected 'object', camera found instead");
}

TEST(Transforms, ZeroScalesBecomeOne) {
    const ParsedScene p = parse_block("sphere { 0, 1 scale <0,2> }");
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Illegal Value: Scale X by 0.0. Changed to 1.0."), HasSubstr("Scale Z by 0.0.")));
    EXPECT_EQ(p.scene.objects.at(0).transform->point(Vec3(3.0)), Vec3(3, 6, 3));
}

TEST(Transforms, Matrix) {
    const Object o = sphere_with("matrix <1, 0.3, 0, -0.2, 0.9, 0.1, 0, 0.2, 1.1, 4, 5, 6>");
    EXPECT_NEAR(length(o.transform->point(Vec3(1, 0, 0)) - Vec3(5, 5.3, 6)), 0.0, 1e-14);
    EXPECT_NEAR(length(o.transform->point(Vec3(0, 1, 0)) - Vec3(3.8, 5.9, 6.1)), 0.0, 1e-14);
    EXPECT_EQ(error_of("sphere { 0, 1 matrix <1,1,0, 1,1,0, 0,0,1, 0,0,0> }"), "Singular matrix in MInvers.");
    EXPECT_EQ(error_of("sphere { 0, 1 matrix <1,0,0,0,1,0,0,0,1,0,0> }"), "Expected 'numeric expression', > found instead");
    const ParsedScene p = parse_block("sphere { 0, 1 matrix <1,0,0, 0,1,0, 1,1,0, 0,0,0> }");
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Illegal matrix column: Scale by 0.0. Changed to 1.0.")));
    EXPECT_EQ(p.scene.objects.at(0).transform->point(Vec3(0, 0, 1)), Vec3(1, 1, 1));
}

TEST(Transforms, Groups) {
    EXPECT_EQ(sphere_with("transform { scale 2 translate x }").transform->point(Vec3(1.0)), Vec3(3, 2, 2));
    EXPECT_EQ(sphere_with("transform { translate x inverse scale 2 inverse }").transform->point(Vec3(0.0)), Vec3(-1, 0, 0));
    const std::string declared = "#declare T = transform { scale 2 } ";
    EXPECT_EQ(only(declared + "sphere { 0, 1 transform T }").transform->point(Vec3(1.0)), Vec3(2.0));
    EXPECT_EQ(only(declared + "sphere { 0, 1 transform { translate x T } }").transform->point(Vec3(0.0)), Vec3(2, 0, 0));
    EXPECT_EQ(only(declared + "sphere { 0, 1 transform { transform T inverse } }").transform->point(Vec3(1.0)), Vec3(0.5));
    EXPECT_EQ(error_of("sphere { 0, 1 transform { scale 2 foo } }"), "No matching } in '{', undeclared identifier 'foo' found instead");
    EXPECT_EQ(error_of("sphere { 0, 1 transform foo }"),
              "Missing { after 'undeclared identifier', undeclared identifier 'foo' found instead");
}

TEST(Transforms, MustStayFinite) {
    const std::string text = "This transform or its inverse has numbers that are not finite.";
    EXPECT_EQ(error_of("sphere { 0, 1 scale 1e200 scale 1e200 }"), text);
    EXPECT_EQ(error_of("sphere { 0, 1 pigment { checker scale 1e-200 scale 1e-200 } }"), text);
    EXPECT_EQ(error_of("sphere { 0, 1 scale 1e-310 }"), text);
    EXPECT_EQ(error_of("camera { translate 1e300 scale 1e10 }"), text);
    EXPECT_EQ(error_of("light_source { 1e200 rgb 1 scale 1e200 }"), "What this is moved to is not finite.");
    EXPECT_EQ(error_of("sphere { 0, 1 rotate 1e300 translate 1e300 }"), "");
}

TEST(Transforms, ReadTheRotationOfTheProfile) {
    ParseOptions course;
    course.rotation = Rotation::csc473;
    const Vec3 ours = parse_block("sphere { 0, 1 rotate <90,90,0> }").scene.objects.at(0).transform->point(Vec3(1, 0, 0));
    const Vec3 theirs = parse_block("sphere { 0, 1 rotate <90,90,0> }", course).scene.objects.at(0).transform->point(Vec3(1, 0, 0));
    EXPECT_NEAR(length(ours - Vec3(0, 0, -1)), 0.0, 1e-15);
    EXPECT_NEAR(length(theirs - Vec3(0, 1, 0)), 0.0, 1e-15);
}

TEST(Objects, ManyKeepTheirOrder) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += "sphere { " + std::to_string(i) + ", 1 }\n";
    const ParsedScene parsed = parse_block(text);
    ASSERT_EQ(parsed.scene.objects.size(), 5000u) << parsed.error;
    for (int i = 0; i < 5000; ++i) EXPECT_EQ(std::get<Sphere>(parsed.scene.objects[i].shape).center, Vec3(i));
}

}  // namespace
}  // namespace rt::blocks_object_test
