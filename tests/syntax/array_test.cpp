// Arrays, as measured on POV-Ray.
#include <gtest/gtest.h>

#include "tests/syntax/read_scene.h"

namespace rt::array_test {
namespace {

using Cases = std::vector<std::pair<std::string, std::string>>;

const std::string show = "#macro Show(A) #debug concat(str(A,0,0),\" \") #end ";

TEST(Array, HoldsValuesOfOneKind) {
    const Cases cases{
        {"#declare A=array[3]{1,2,5} Show(A[0]) Show(A[2])", "1 5 "},
        {"#declare A=array[3]{1 2 3,}; Show(A[2])", "3 "},
        {"#declare A=array[2][2]{{1,2},{3,4}} Show(A[1][0]) Show(dimensions(A))", "3 2 "},
        {"#declare A=array[2][3] Show(dimension_size(A,1)) Show(dimension_size(A,2)) Show(dimension_size(A,3))", "2 3 0 "},
        {"#declare A=array[3] #declare A[1.7]=1; Show(A[1])", "1 "},
        {"#declare A=array[2] #local A[0]=3; #local A[1]=4; Show(A[0]+A[1]*2)", "11 "},
        {"#declare A=array[3]{1,2,3} #declare B=A #declare B[0]=9; Show(A[0]) Show(B[0])", "1 9 "},
        {"#declare A=array[2]{array[2]{1,2},array[2]{3,4}} Show(A[1][0])", "3 "},
        {"#declare A=array[1] #declare A[0]=array[2]; #declare A[0][1]=5; Show(A[0][1])", "5 "},
        {"#declare A=array[1]{array[1]{1}} #declare B=A #declare B[0][0]=2; Show(A[0][0])", "1 "},
        {"#declare A=array[2]{<1,2,3>,x} Show(A[1].x) Show(-A[0].y*2)", "1 -4 "},
        {"#declare A=array[2]{\"a\",concat(\"b\",\"c\")} #debug concat(A[0],A[1]) Show(strlen(A[1]))", "abc2 "},
        {"#declare A=array[2]{rgb 1,rgb <.1,.25,.3>} Show(A[1].green*4)", "1 "},
        {"#declare A=array[3] #ifdef(A) Show(1) #end #ifdef(A[1]) Show(2) #else Show(3) #end Show(defined(A[1]))", "1 3 0 "},
        {"#declare A=array[2]{1,2} #undef A[1] #ifndef(A[1]) Show(7) #end", "7 "},
        {"#macro M(T) #local T[0]=5; #end #declare A=array[2]{1,2} M(A) Show(A[0])", "5 "},
        {"#macro M() #local A[0]=5; Show(A[0]) #end #declare A=array[2]{1,2} M() Show(A[0])", "5 1 "},
        {"#declare A=array[3]{0,2,1} Show(A[A[A[2]]])", "1 "},
        {"#declare A=array[2]{1,2} #for(I,0,dimension_size(A,1)-1) Show(A[I]) #end", "1 2 "},
        {"#macro M() #declare A=array[2]{5,6} #end M() Show(A[1])", "6 "},
        {"#declare A=array[1][1][1][1][1]{{{{{3}}}}} Show(A[0][0][0][0][0])", "3 "},
    };
    for (const auto& [scene, text] : cases) EXPECT_EQ(debug_text(show + scene), text) << scene;
}

TEST(Array, ElementsStandWhereValuesOfTheirKindDo) {
    const Outcome o = read_scene(
        "#declare S = array[2] { sphere { 0, 1 }, sphere { 0, 2 } }\n"
        "#declare T = array[1] { texture { pigment { rgb x } } } #declare P = array[1] { pigment { rgb y } }\n"
        "#declare F = array[1] { finish { ambient 1 } } #declare M = array[1] { transform { translate x } } #declare C = array[1] { rgb z "
        "}\n"
        "S[0] object { S[1] texture { T[0] } transform { M[0] } } sphere { 0, 3 pigment { P[0] } finish { F[0] } }\n"
        "sphere { 0, 4 pigment { C[0] } }");
    ASSERT_TRUE(o.scene) << o.error;
    ASSERT_EQ(o.scene->objects.size(), 4u);
    EXPECT_EQ(std::get<Sphere>(o.scene->objects[1].shape).radius, 2.0);
    const auto color = [&](int i) {
        return std::get<PigmentColor>(std::get<PlainTexture>((*o.scene->objects[i].texture)->front().content).pigment.content).rgb;
    };
    EXPECT_EQ(color(1), Rgb(1, 0, 0));
    EXPECT_EQ(color(2), Rgb(0, 1, 0));
    EXPECT_EQ(color(3), Rgb(0, 0, 1));
}

TEST(Array, WhatLiesCloseBelowAWholeNumberIsThatNumber) {
    EXPECT_EQ(debug_text("#declare A=array[11] #for(I,0,1,0.1) #declare A[I*10]=1; #end #for(I,0,10) #debug str(A[I],0,0) #end"),
              "11111111111");
    EXPECT_EQ(debug_text("#declare A=array[2.99999999999] #debug str(dimension_size(A,1),0,0)"), "3");
    EXPECT_EQ(debug_text("#declare A=array[2.999999999] #debug str(dimension_size(A,1),0,0)"), "2");
    EXPECT_EQ(error_text("#declare A=array[2]{1,2} #declare B=A[-0.5];"), "Negative subscript");
}

TEST(Array, MistakesAreNamedAsPovRayNamesThem) {
    const Cases mistakes{
        {"#declare A=array[3] #debug str(A[1],0,0)", "Attempt to access uninitialized array element."},
        {"#declare A=array[3] #declare A[3]=1;", "Array subscript out of range"},
        {"#declare A=array[3] #declare A[0/0]=1;", "Array subscript out of range"},
        {"#declare A=array[3] #declare A[-1]=1;", "Negative subscript"},
        {"#declare A=array[2]{1,2} sphere{0,A[2]}", "Array subscript out of range"},
        {"#declare A=array[3]{1,2}", "Expected 'RValue to declare', } found instead"},
        {"#declare A=array[3]{1,2,3,4}", "No matching } in '{', float function 'float constant' found instead"},
        {"#declare A=array[2][2]{{1,2},{3,4}} #debug str(A[1],0,0)", "Expected '[', , found instead"},
        {"#declare A=array[2]{1,<1,2,3>}", "Attempted to redefine float identifier as vector identifier."},
        {"#declare A=array[2] #declare A[0]=1; #declare A[1]=\"s\";", "Attempted to redefine float identifier as string identifier."},
        {"#declare A=array[2] #declare A[0]=sphere{0,1} #declare A[1]=texture{}",
         "Attempted to redefine object identifier as texture identifier."},
        {"#declare A=array{1,2,3}", "An array declaration must have at least one dimension"},
        {"#declare A=array[0]", "Invalid dimension size for an array"},
        {"#declare A=array[-2]", "Invalid dimension size for an array"},
        {"#declare A=array[0/0]", "Invalid dimension size for an array"},
        {"#declare A=array[1][1][1][1][1][1]", "Too many array dimensions"},
        {"#declare A=array[2]{1,2} #declare A=A*2;", "Expected 'object or directive', * found instead"},
        {"#declare A=array[2]{1,2} #debug str(A,0,0)", "Expected 'numeric expression', array identifier found instead"},
        {"#declare A=array[2]{1,Nope}", "Cannot assign uninitialized identifier."},
        {"#declare A=5; #debug str(A[0],0,0)", "Expected 'numeric expression', [ found instead"},
        {"#declare A=array[2] #macro M(P) #end M(A[1])", "Attempt to access uninitialized array element."},
        {"#declare A=array[2]{1,2} #declare B=A[ #declare A=array[1]{7} 1];", "Array subscript out of range"},
        {"#declare A=array[2]{1,2} #declare B=A[ #declare A=5; 1];", "Array subscript out of range"},
        {"#macro M() #declare A=array[1]; 3 #end #declare A=array[9] #declare A[5]=M();", "Array subscript out of range"},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
}

}  // namespace
}  // namespace rt::array_test
