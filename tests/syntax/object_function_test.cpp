// inside, trace, min_extent and max_extent. The boxes are those that POV-Ray 3.7 told of.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/syntax/read_scene.h"

namespace rt::object_function_test {
namespace {

struct Boxed {
    std::string object;
    Vec3 min, max;
};

/// What the last #debug says.
Vec3 numbers(const std::string& scene) {
    const Outcome outcome = read_scene(scene);
    Vec3 v(NAN);
    if (!outcome.messages.empty()) std::istringstream(outcome.messages.back()) >> v.x >> v.y >> v.z;
    return v;
}

void expect_boxes(const std::vector<Boxed>& cases) {
    for (const Boxed& c : cases) {
        const std::string declared = "#declare O = " + c.object + " #debug vstr(3, ";
        const Vec3 min = numbers(declared + "min_extent(O), \" \", 0, 9)");
        const Vec3 max = numbers(declared + "max_extent(O), \" \", 0, 9)");
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(min[i], c.min[i], 3e-7 * std::fmax(1.0, std::fabs(c.min[i]))) << c.object << " from, " << i;
            EXPECT_NEAR(max[i], c.max[i], 3e-7 * std::fmax(1.0, std::fabs(c.max[i]))) << c.object << " to, " << i;
        }
    }
}

const Vec3 far(1e10);
const std::string back = " rotate <10,20,30> rotate -30*z rotate -20*y rotate -10*x }";

TEST(Extent, IsInSinglePrecision) {
    EXPECT_EQ(debug_text("#declare O = sphere { <1,2,3>, 0.7 } #debug vstr(3, min_extent(O), \" \", 0, 10)"),
              "0.3000000119 1.2999999523 2.2999999523");
    EXPECT_EQ(debug_text("#declare O = sphere { <1,2,3>, 0.7 } #debug vstr(3, max_extent(O), \" \", 0, 10)"),
              "1.7000000477 2.6999998093 3.6999998093");
}

TEST(Extent, OfShapesIsThatOfTheShapeAsItStands) {
    expect_boxes({
        {"sphere { <1,2,3>, 0.7 rotate 30*y }", {1.6660254, 1.3, 1.3980762}, {3.0660253, 2.7, 2.7980762}},
        {"sphere { <1,0,0>, 0.5 scale <1,2,3> rotate 30*y }", {-0.3169873, -1, -2.0490382}, {2.0490382, 1, 1.0490379}},
        {"sphere { <1,0,0>, 0.5 scale 2 rotate 30*y }", {0.7320508, -1, -2}, {2.7320509, 1, 0}},
        {"sphere { <1,0,0>, 0.5 matrix <1,0.5,0,0,1,0,0,0,1,0,0,0> }", {0.5, -0.25, -0.5}, {1.5, 1.25, 0.5}},
        {"box { <1,2,3>, <-1,1.3,4> rotate 30*y }", {0.6339746, 1.3, 2.0980761}, {2.8660254, 2, 3.9641016}},
        {"box { <1,2,3>, <-1,1.3,4>" + back, {-1, 1.3, 3}, {1, 2, 4}},
        {"cylinder { <0,0,0>, <1,2,0>, 0.5 rotate 30*y }", {-0.5086153, -0.3, -0.9936492}, {1.3746407, 2.3, 0.4936492}},
        {"cylinder { <1,2,3>, 0, 0.3 }", {-0.3118930, -0.2762140, -0.2405351}, {1.3118930, 2.2762139, 3.2405353}},
        {"cone { 0, 0.3, <1,2,3>, 0.5 }", {-0.5198216, -0.4603566, -0.4008917}, {1.5198216, 2.4603567, 3.4008920}},
        {"cone { 0, 0.5, <1,2,3>, 0.3 }", {-0.6801785, -0.5810704, -0.4008921}, {1.6801784, 2.5810702, 3.4008918}},
        {"torus { 1, 0.3 scale <1,2,3> translate <0.1,0.2,0.3> }", {-1.1999999, -0.4, -3.5999999}, {1.4, 0.8, 4.1999998}},
        {"disc { <1,0,0>, <1,1,0.3>, 2, 0.4 }", {-1.0006918, -2.0006917, -2.7670653}, {3.0006914, 2.0006917, 2.7670653}},
        {"disc { 0, -z, 1 }", {-1, -1, -0.001}, {1, 1, 0.001}},
        {"triangle { <0,0,0>, <1,0,0>, <0,1,0.4> rotate 30*y }", {0, 0, -0.5}, {0.8660254, 1, 0.3464102}},
        {"polygon { 5, <0,0>, <1,0>, <1,1>, <0,1.2>, <0,0> scale <1,2,3> translate <0.1,0.2,0.3> }", {0.1, 0.2, 0.299}, {1.1, 2.6, 0.301}},
        {"superellipsoid { <0.3,0.4> rotate 30*y }", {-1.3661621, -1.0001, -1.3661621}, {1.3661621, 1.0001, 1.3661621}},
        {"prism { linear_spline 0, 1, 5, <0,0>, <1,0>, <1,1>, <0,1.2>, <0,0> }", {0, 0, 0}, {1, 1, 1.2}},
        {"sor { 4, <0.2,0>, <0.5,0.5>, <0.3,1.2>, <0.3,1.6> }", {-0.5016897, 0.5, -0.5016897}, {0.5016897, 1.2, 0.5016897}},
        {"sphere_sweep { linear_spline 2, <0,0,0>, 0.2, <1,2,0>, 0.4 rotate 30*y }", {-0.2, -0.2, -0.9}, {1.2660254, 2.4, 0.2}},
        {"plane { y, 0.3 }", -far, far},
        {"poly { 2, <1,0,0,0,1,0,0,1,0,-1> }", -far, far},
    });
}

TEST(Extent, OfSomeShapesGrowsWithEachTurn) {
    expect_boxes({
        {"quadric { 1, 0, 0, -1" + back, {-2.4623613, -2.3311868, -2.3790393}, {2.4623613, 2.3311868, 2.3790393}},
        {"quadric { <1,2,3>, 0, <1,2,3>, -4 }", {-2.8452079, -2.1583123, -1.8540064}, {1.8452079, 1.1583126, 0.8540064}},
        {"quadric { <-1,-2,-3>, 0, <1,2,3>, 4 }", {-1.8452079, -1.1583124, -0.8540064}, {2.8452079, 2.1583123, 1.8540064}},
        {"quadric { <1,2,3>, <0.1,0,0>, 0, -1 }", -far, far},
        {"quadric { <1,0,1>, 0, 0, -1 }", -far, far},
        {"blob { threshold 0.5 sphere { 0, 1, 1 } sphere { x, 1, 1 }" + back,
         {-2.4623613, -2.7877133, -2.7662077},
         {3.4623609, 2.7877133, 2.7662077}},
        {"blob { threshold 0.9 sphere { <1,2,3>, 2, 0.3 scale <1,2,3> rotate 30*y } }",
         {-0.8301268, -2.1961522, 1.0980765},
         {11.5621777, 10.1961517, 13.4903812}},
        {"blob { threshold 0.9 sphere { <1,2,3>, 2, 0.3 } sphere { <1,2,6>, 2, -0.3 scale 2 } }", {-1, 0, 1}, {3, 4, 5}},
        {"blob { threshold 0.5 cylinder { 0, <1,2,3>, 0.5, 1 } }", {-2.6052952, -2.1052952, -1.6052952}, {3.6052952, 4.1052952, 4.6052952}},
        {"blob { threshold 0.9 cylinder { 0, x, 2, 0.3 rotate 45*y } }",
         {-2.8284271, -2.9154758, -3.5355339},
         {3.5355337, 2.9154758, 2.8284268}},
        {"mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0.4> } triangle { <0,0,0>, <1,0,1>, <0,1.1,0.4> }" + back,
         {-0.7726476, -0.6678614, -0.7194837},
         {1.7726474, 1.7678616, 1.7194835}},
    });
}

TEST(Extent, OfUnionsIsAroundTheParts) {
    expect_boxes({
        {"union { sphere { 0, 1 } box { 1, <2,3,4> } }", Vec3(-1), {2, 3, 4}},
        {"union { sphere { 0, 1 } box { 1, <2,3,4> }" + back, {-4.2412333, -3.3922329, -3.3736210}, {5.2412343, 5.3922329, 6.3736219}},
        {"merge { sphere { 0, 1 } box { 1, <2,3,4> } rotate 30*y }", {-1.3660254, -1, -1.8660254}, {3.7320509, 3, 3.9641018}},
        {"union { sphere { 0, 1 } plane { y, 0 } }", -far, far},
        {"union { sphere { 0, 1 } light_source { 5, 1 } }", -far, far},
        {"light_source { 5, 1 }", -far, far},
    });
}

TEST(Extent, OfIntersectionsIsWhatThePartsHaveInCommon) {
    const std::string tube = "quadric { <1,0,1>, 0, 0, -1", box = "box { -1, 1 } ", large = "box { -2, 2 } ";
    expect_boxes({
        {"intersection { sphere { 0, 1 } box { 0, <2,3,4> } }", Vec3(0), Vec3(1)},
        {"intersection { sphere { 0, 1 } box { 3, 5 } }", -far, far},
        {"intersection { " + box + "plane { y, 0.3 } }", Vec3(-1), {1, 0.3, 1}},
        {"intersection { " + large + "plane { y, 1 rotate 90*x } }", Vec3(-2), {2, 2, 1}},
        {"intersection { " + large + "plane { y, 1 scale 0.5 translate 0.2*y } }", Vec3(-2), {2, 0.7, 2}},
        {"intersection { " + large + "plane { <1,1,0>, 1 } }", Vec3(-2), Vec3(2)},
        {"intersection { " + large + "plane { y, 1 inverse } }", {-2, 1, -2}, Vec3(2)},
        {"intersection { plane { y, 1 } plane { -y, 2 } plane { x, 1 } plane { -x, 1 } plane { z, 1 } plane { -z, 1.5 } }",
         {-1, -2, -1.5},
         Vec3(1)},
        {"intersection { plane { y, 1 } plane { -y, 2 } plane { x, 1 } plane { -x, 1 } }", -far, far},
        {"intersection { " + box + "sphere { 0, 0.5 inverse } }", Vec3(-1), Vec3(1)},
        {"difference { " + box + "box { <-2,0.2,-2>, 2 } }", Vec3(-1), Vec3(1)},
        {"difference { " + box + "plane { y, 0.2 } rotate 30*y }", {-1.3660254, 0.2, -1.3660254}, {1.3660254, 1, 1.3660254}},
        {"intersection { " + tube + " } plane { y, 1 } plane { -y, 1 } }", Vec3(-1), Vec3(1)},
        {"intersection { " + tube + " rotate 90*x } plane { z, 1 } plane { -z, 1 } }", Vec3(-1), Vec3(1)},
        {"intersection { " + tube + " rotate 45*x } plane { z, 1 } plane { -z, 1 } }", -far, far},
        {"intersection { " + tube + " scale 3 translate x } plane { y, 1 } plane { -y, 1 } }", {-2, -1, -3}, {4, 1, 3}},
        {"intersection { quadric { <1,-1,1>, 0, 0, 0 } plane { y, 1 } plane { -y, 0 } }", {-1, 0, -1}, Vec3(1)},
        {"intersection { quadric { <1,0,1>, 0, -y, 0 } plane { y, 1 } }", {-1, 0, -1}, Vec3(1)},
        {"intersection { quadric { <1,-1,1>, 0, 0, -1 } plane { y, 1 } plane { -y, 1 } }",
         {-1.4142135, -1, -1.4142135},
         {1.4142135, 1, 1.4142135}},
        {"intersection { quadric { <1,-1,1>, 0, 0, 1 } plane { y, 2 } plane { -y, 0 } }", -far, far},
    });
}

TEST(Extent, OfClippedAndBoundedObjects) {
    const std::string half = "box { -0.5, 0.5 } ";
    expect_boxes({
        {"sphere { 0, 1 clipped_by { box { 0, 2 } } }", Vec3(-1), Vec3(1)},
        {"plane { y, 0 clipped_by { " + half + "} rotate 30*y }", {-0.6830127, -0.5, -0.6830127}, {0.6830127, 0.5, 0.6830127}},
        {"plane { y, 0 clipped_by { " + half + "sphere { 0.2, 0.5 } } }", Vec3(-0.3), Vec3(0.5)},
        {"quadric { <1,0,1>, 0, 0, -1 clipped_by { plane { y, 1 } plane { -y, 2 } } }", {-1, -2, -1}, Vec3(1)},
        {"union { sphere { 0, 1 } plane { y, 2 } clipped_by { box { 0, 1 } } }", Vec3(0), Vec3(1)},
        {"sphere { 0, 1 bounded_by { box { -0.5, 5 } } }", Vec3(-1), Vec3(1)},
        {"sphere { 0, 1 clipped_by { box { 0, 0.5 } } }", Vec3(0), Vec3(0.5)},
        {"union { sphere { 0, 1 } box { 1, 2 } clipped_by { box { -3, 1.5 } } }", Vec3(-1), Vec3(2)},
        {"sphere { 0, 1 bounded_by { plane { y, 0.5 } } }", Vec3(-1), Vec3(1)},
        {"union { sphere { 0, 1 } box { 0, 1 } bounded_by { " + half + "} rotate 30*y rotate 20*x }",
         {-0.6830127, -0.7034504, -0.8128321},
         {0.6830127, 0.7034504, 0.8128321}},
        {"intersection { sphere { 0, 1 } plane { y, 0 } bounded_by { " + half + "}" + back, Vec3(-0.5), Vec3(0.5)},
    });
}

/// A probe that says what it was asked of.
class Echo final : public ObjectProbe {
public:
    explicit Echo(const Bodies& bodies) : count_(static_cast<double>(bodies.objects.size())) {}
    std::optional<Met> trace(const Vec3& from, const Vec3& direction) const override {
        if (direction == Vec3(0.0)) return std::nullopt;
        return Met{from, direction};
    }
    bool contains(const Vec3& point) const override { return point.x < count_; }

private:
    double count_;
};

ParseOptions with_probe(int& made) {
    ParseOptions options;
    options.make_probe = [&made](const Bodies& bodies) {
        ++made;
        return std::make_shared<const Echo>(bodies);
    };
    return options;
}

TEST(ObjectFunctions, AskOneProbeOfAnObject) {
    int made = 0;
    const std::string scene =
        "#declare A = union { sphere { 0, 1 } sphere { x, 1 } } #declare N = <7,7,7>; #local I = 0; #while (I < 5) "
        "#debug vstr(3, trace(A, <I,1,2>, y, N) + 10*N, \" \", 0, 0) #debug str(inside(A, I*x), 0, 0) #local I = I + 1; #end ";
    EXPECT_EQ(debug_text(scene, with_probe(made)),
              "0 11 21"
              "1 11 21"
              "2 11 20"
              "3 11 20"
              "4 11 20");
    EXPECT_EQ(made, 1);
    EXPECT_EQ(debug_text("#declare A = sphere { 0, 1 } #declare B = A; #debug str(inside(A 0) + inside(B 0), 0, 0) "
                         "#declare A = object { A scale 2 } #debug str(inside(A, 0), 0, 0)",
                         with_probe(made = 0)),
              "21");
    EXPECT_EQ(made, 3);
}

TEST(ObjectFunctions, TraceSetsItsNormal) {
    int made = 0;
    const std::string object = "#declare A = sphere { 0, 1 } ";
    EXPECT_EQ(debug_text(object + "#declare N = array[1] { <1,2,3> } #debug vstr(3, trace(A, 1, <4,5,6>, N[0]) + N[0], \" \", 0, 0)",
                         with_probe(made)),
              "5 6 7");
    EXPECT_EQ(debug_text(object + "#declare N = <1,2,3>; #debug vstr(3, trace(A, 1, 0, N) + N, \" \", 0, 0)", with_probe(made)), "0 0 0");
    for (const auto& [normal, found] : std::vector<std::pair<std::string, std::string>>{
             {"#declare N = 3;", "float function 'float identifier' found instead"},
             {"#declare N = <1,2>;", "uv vector identifier found instead"},
             {"#declare N = rgb 1;", "color identifier found instead"},
             {"", "undeclared identifier 'N' found instead"},
         })
        EXPECT_EQ(error_text(object + normal + " #declare P = trace(A, 0, x, N);", with_probe(made)), "Expected ')', " + found);
}

TEST(ObjectFunctions, OutliveTheObjectThatTheyAsk) {
    int made = 0;
    EXPECT_EQ(debug_text("#declare A = sphere { 0, 1 } #macro P() #declare A = 3; <0,0,0> #end #debug str(inside(A, P()) + A, 0, 0)",
                         with_probe(made)),
              "4");
}

TEST(ObjectFunctions, InsideTakesWhatHasOne) {
    int made = 0;
    const std::string triangle = "triangle { 0, x, y }", ask = " #declare B = inside(A, 0);";
    for (const std::string& object : {triangle, "mesh { " + triangle + " }", "union { sphere { 0, 1 } " + triangle + " }",
                                      std::string("light_source { 0, 1 }"), std::string("union { sphere { 0, 1 } light_source { 0, 1 } }")})
        EXPECT_EQ(error_text("#declare A = " + object + ask, with_probe(made)), "Solid object identifier expected.") << object;
    EXPECT_EQ(error_text("#declare A = polygon { 4, 0, x, y, 0 }" + ask, with_probe(made)), "");
    EXPECT_EQ(error_text("#declare A = 1;" + ask, with_probe(made)), "Object identifier expected.");
    EXPECT_EQ(error_text("#declare B = inside(sphere { 0, 1 }, 0);", with_probe(made)), "Object identifier expected.");
    EXPECT_EQ(error_text("#declare A = sphere { 0, 1 } #debug str(inside(A, 0), 0, 0)"), "'inside' is not modelled.");
}

TEST(ObjectFunctions, AreLimited) {
    int made = 0;
    ParseOptions options = with_probe(made);
    options.max_replayed_bytes = 10'000;
    EXPECT_TRUE(
        read_scene("#declare A = union { #for (I, 1, 50) sphere { 0, I } #end } #for (I, 1, 30) #declare B = inside(A, 0); #end", options)
            .limit);
    options.max_set_parts = 40;
    options.max_replayed_bytes = 1'000'000;
    EXPECT_TRUE(
        read_scene("#declare A = sphere { 0, 1 } #for (I, 1, 50) #declare B = object { A } #declare C = inside(B, 0); #end", options)
            .limit);
}

}  // namespace
}  // namespace rt::object_function_test
