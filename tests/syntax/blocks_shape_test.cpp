#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_shape_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string error_of(const std::string& text) { return parse_block(text).error; }
std::size_t objects_in(const std::string& text) { return parse_block(text).scene.objects.size(); }

TEST(Shapes, Sphere) {
    EXPECT_EQ(only_shape<Sphere>("sphere { <1,2,3>, 4 }"), (Sphere{Vec3(1, 2, 3), 4.0}));
    EXPECT_EQ(only_shape<Sphere>("sphere { <1 2 3> 4 }").radius, 4.0);
    EXPECT_EQ(only_shape<Sphere>("sphere { 0, -4 }").radius, 4.0);
}

TEST(Shapes, PlaneNormalIsMadeUnitAndTheDistanceIsKept) {
    const Plane p = only_shape<Plane>("plane { <0,3,-4>, 2 }");
    EXPECT_NEAR(length(p.normal - Vec3(0, 0.6, -0.8)), 0.0, 1e-15);
    EXPECT_EQ(p.distance, 2.0);
    EXPECT_EQ(error_of("plane { 0, 1 }"), "Degenerate plane normal.");
}

TEST(Shapes, BoxCornersInAnyOrder) { EXPECT_EQ(only_shape<Box>("box { <1,-1,3>, <-2,2,0> }"), (Box{Vec3(-2, -1, 0), Vec3(1, 2, 3)})); }

TEST(Shapes, ConeAndCylinder) {
    EXPECT_EQ(only_shape<Cone>("cone { <0,1,0>, 2, <0,3,0>, 0.5 open }"), (Cone{Vec3(0, 1, 0), 2.0, Vec3(0, 3, 0), 0.5, true}));
    EXPECT_EQ(only_shape<Cone>("cylinder { <0,1,0>, <0,3,0>, 2 }"), (Cone{Vec3(0, 1, 0), 2.0, Vec3(0, 3, 0), 2.0, false}));
    EXPECT_TRUE(only_shape<Cone>("cylinder { 0, y, 1 open pigment { rgb 1 } }").open);
    EXPECT_EQ(error_of("cylinder { 0, y, 1 pigment { rgb 1 } open }"), "No matching } in 'cylinder', open found instead");
    EXPECT_EQ(error_of("cone { x, 1, x, 2 }"), "Degenerate cone/cylinder.");
    EXPECT_EQ(error_of("cylinder { 0, 1e-12*y, 1 }"), "Degenerate cylinder, base point = apex point.");
}

TEST(Shapes, Torus) {
    EXPECT_EQ(only_shape<Torus>("torus { 2, 0.5 sturm }"), (Torus{2.0, 0.5}));
    EXPECT_EQ(only_shape<Torus>("torus { -2, 0.5 }"), (Torus{-2.0, 0.5}));
    EXPECT_EQ(objects_in("torus { 2, 0 } torus { -2, 0 }"), 0u);
    const ParsedScene invisible = parse_block("torus { 2, -0.5 }");
    EXPECT_TRUE(invisible.scene.objects.empty());
    EXPECT_THAT(invisible.messages, ElementsAre(HasSubstr("A torus with a negative minor radius is not visible.")));
    const ParsedScene both = parse_block("torus { -2, -0.5 }");
    EXPECT_EQ(both.scene.objects.size(), 1u);
    EXPECT_THAT(both.messages, ElementsAre(HasSubstr("It is drawn whole.")));
}

TEST(Shapes, TorusWithoutAMajorRadiusIsASphere) {
    EXPECT_EQ(only_shape<Sphere>("torus { 0, 0.8 }"), (Sphere{Vec3(0.0), 0.8}));
    EXPECT_EQ(only_shape<Sphere>("torus { -1e-12, 0.8 }").radius, 0.8);
    EXPECT_EQ(only_shape<Torus>("torus { 1e-6, 0.8 }").major_radius, 1e-6);
}

// As POV-Ray draws them: both negative is a cylinder of the smaller radius, one negative a pair of cones.
TEST(Shapes, ConesOfNegativeRadii) {
    EXPECT_EQ(only_shape<Cone>("cone { 0, -0.4, y, -0.2 }"), (Cone{Vec3(0.0), 0.2, Vec3(0, 1, 0), 0.2}));
    EXPECT_EQ(only_shape<Cone>("cone { 0, -0.2, y, -0.4 open }"), (Cone{Vec3(0.0), 0.2, Vec3(0, 1, 0), 0.2, true}));
    EXPECT_EQ(only_shape<Cone>("cone { 0, -0.4, y, 0 }").base_radius, 0.0);
    EXPECT_EQ(only_shape<Cone>("cone { 0, 0.4, y, -0.4 }"), (Cone{Vec3(0.0), 0.4, Vec3(0, 1, 0), -0.4}));
    EXPECT_THAT(parse_block("cone { 0, 0.4, y, -0.4 }").messages, IsEmpty());
    EXPECT_THAT(parse_block("cone { 0, 0.2, y, -0.4 }").messages, ElementsAre(HasSubstr("It is drawn whole.")));
}

TEST(Shapes, Disc) {
    EXPECT_EQ(only_shape<Disc>("disc { <1,2,3>, 2*y, 4 }"), (Disc{Vec3(1, 2, 3), Vec3(0, 1, 0), 4.0, 0.0}));
    EXPECT_EQ(only_shape<Disc>("disc { 0, y, 4, 1 }").hole_radius, 1.0);
    EXPECT_EQ(only_shape<Disc>("disc { 0, y, -4 1 }").radius, 4.0);
    EXPECT_EQ(objects_in("disc { 0, 0, 1 }"), 0u);
}

TEST(Shapes, Triangle) {
    EXPECT_EQ(only_shape<Triangle>("triangle { x, y, z }"), (Triangle{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}));
    EXPECT_EQ(objects_in("triangle { 0, 1e-20*x, 1e-20*y }"), 1u);
    const ParsedScene p = parse_block("triangle { 0, x, 2*x }");
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Degenerate triangle. Please remove.")));
    EXPECT_EQ(p.error, "");
    EXPECT_TRUE(p.scene.objects.empty());
}

TEST(Shapes, SmoothTriangleNormalsAreMadeUnit) {
    const SmoothTriangle t = only_shape<SmoothTriangle>("smooth_triangle { 0, 5*z, x, <0,1,1>, y, z }");
    EXPECT_EQ(t.b, Vec3(1, 0, 0));
    EXPECT_EQ(t.normal_a, Vec3(0, 0, 1));
    EXPECT_NEAR(length(t.normal_b), 1.0, 1e-15);
}

TEST(Shapes, SmoothTriangleNormalsMustBeStrictlyOnOneSide) {
    EXPECT_EQ(objects_in("smooth_triangle { 0, -z, x, -z, y, <1,0,-0.1> }"), 1u);
    for (const char* text : {"smooth_triangle { 0, z, x, z, y, -z }", "smooth_triangle { 0, z, x, z, y, x }",
                             "smooth_triangle { 0, 0, x, z, y, z }", "smooth_triangle { 0, z, x, z, 2*x, z }"}) {
        const ParsedScene p = parse_block(text);
        EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Degenerate triangle. Please remove."))) << text;
        EXPECT_TRUE(p.scene.objects.empty());
    }
}

TEST(Shapes, PolygonIsClosed) {
    const Polygon closed = only_shape<Polygon>("polygon { 4, <0,0>, <1,0>, <0,1>, <0,0> }");
    EXPECT_THAT(closed.points, ElementsAre(Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.0)));
    const ParsedScene open = parse_block("polygon { 3 <0,0> <1,0> <0,1> }");
    EXPECT_EQ(std::get<Polygon>(open.scene.objects.at(0).shape), closed);
    EXPECT_THAT(open.messages, ElementsAre(HasSubstr("Polygon not closed. Closing it.")));
    EXPECT_EQ(only_shape<Polygon>("polygon { 4, 0, x, y, 1e-11*x }").points.back(), Vec3(0.0));
}

TEST(Shapes, PolygonContours) {
    const ParsedScene p = parse_block("polygon { 9, <0,0>, <9,0>, <9,9>, <0,9>, <0,0>, <1,1>, <2,1>, <2,2>, <1,2> }");
    const Polygon polygon = std::get<Polygon>(p.scene.objects.at(0).shape);
    EXPECT_EQ(polygon.points.size(), 10u);
    EXPECT_EQ(polygon.points[9], Vec3(1, 1, 0));
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Polygon not closed.")));
}

TEST(Shapes, APointLeftOverBoundsNothing) {
    EXPECT_THAT(parse_block("polygon { 6, 0, x, x+y, y, 0, x }").messages,
                ElementsAre(HasSubstr("Polygon not closed."), HasSubstr("stands alone and bounds nothing.")));
}

TEST(Shapes, ADoubledFirstPointClosesNoContour) {
    EXPECT_THAT(parse_block("polygon { 6, <0,0>, <0,0>, <1,0>, <1,1>, <0,1>, <0,0> }").messages, IsEmpty());
}

TEST(Shapes, PolygonErrorsAndWhatIsNeverHit) {
    EXPECT_EQ(error_of("polygon { 2, 0, x }"), "Polygon needs at least three points.");
    EXPECT_EQ(error_of("polygon { 4, 0, x, y }"), "Expected 'numeric expression', } found instead");
    EXPECT_EQ(error_of("polygon { 4, 0, x, y, 0, }"), "No matching } in 'polygon', , found instead");
    EXPECT_EQ(objects_in("polygon { 4, 0, x, 2*x, 0 }"), 0u);
    EXPECT_EQ(objects_in("polygon { 5, <0,0,0>, <1,0,0>, <1,1,1e-9>, <0,1,0>, <0,0,0> }"), 0u);
    EXPECT_EQ(objects_in("polygon { 5, <0,0,0>, <1,0,0>, <1,1,1e-11>, <0,1,0>, <0,0,0> }"), 1u);
}

TEST(Shapes, CommasBetweenParametersAreOptionalButNotAtTheEnd) {
    EXPECT_EQ(error_of("box { 0 1 } cone { 0 1 y 0 } torus { 1 0.5 } triangle { x y z } plane { y 0 }"), "");
    for (const char* shape :
         {"sphere { 0, 1, }", "box { 0, 1, }", "plane { y, 0, }", "cone { 0, 1, y, 0, }", "torus { 1, 0.5, }", "triangle { x, y, z, }"}) {
        const std::string text = shape;
        EXPECT_EQ(error_of(text), "No matching } in '" + text.substr(0, text.find(' ')) + "', , found instead");
    }
}

TEST(Shapes, NumbersMustBeFinite) {
    for (const char* text : {"sphere { 0, 1e400 }", "sphere { <0,1e300*1e300,0>, 1 }", "box { 0, 1/0 }", "sphere { 0, 1e300*1e300*0 }",
                             "sphere { 0, 1 translate 1e308*10 }"})
        EXPECT_THAT(error_of(text), HasSubstr("Expected 'finite number'")) << text;
    EXPECT_EQ(error_of("sphere { 1e200, 1 } sphere { 0, 1e-300 }"), "");
}

TEST(Shapes, ABlockMayBeginWithADeclaredObject) {
    const ParsedScene p = parse_block("#declare S = sphere { 0, 2 } sphere { S scale 2 } box { S }");
    ASSERT_EQ(p.error, "");
    EXPECT_EQ(std::get<Sphere>(p.scene.objects.at(0).shape).radius, 2.0);
    EXPECT_EQ(p.scene.objects[0].transform->point(Vec3(1.0)), Vec3(2.0));
    EXPECT_TRUE(std::holds_alternative<Sphere>(p.scene.objects.at(1).shape));
}

TEST(Shapes, SpansNameTheWord) {
    const ParsedScene p = parse_block("\n\n  sphere { 0, 1 }");
    const LineColumn at = p.scene.sources.locate(p.scene.objects.at(0).span.file, p.scene.objects[0].span.begin);
    EXPECT_EQ(at.line, 3u);
    EXPECT_EQ(at.column, 3u);
}

}  // namespace
}  // namespace rt::blocks_shape_test
