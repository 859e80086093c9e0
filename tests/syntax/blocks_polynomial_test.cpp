#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_polynomial_test {
namespace {

using testing::ElementsAre;

std::string error_of(const std::string& text) { return parse_block(text).error; }

template <typename S>
S only_further(const std::string& text) {
    return std::get<S>(only_shape<FurtherShape>(text));
}

TEST(Polynomials, Quadric) {
    const Quadric expected{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), 10.0};
    EXPECT_EQ(only_further<Quadric>("quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 }"), expected);
    EXPECT_EQ(only_further<Quadric>("quadric { <1,2,3> <4,5,6> <7,8,9> 10 inverse }"), expected);
    EXPECT_EQ(only_further<Quadric>("quadric { 1, 0, 0, -1 }"), Quadric{});
    EXPECT_EQ(error_of("quadric { 1, 0, 0 }"), "Expected 'numeric expression', } found instead");
    EXPECT_EQ(error_of("quadric { 1, 0, 0, -1 sturm }"), "Keyword 'sturm' cannot be used with this object.");
}

TEST(Polynomials, Poly) {
    EXPECT_EQ(only_further<Poly>("poly { 2, <1,2,3,4,5,6,7,8,9,10> sturm }"), make_poly(2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
    EXPECT_EQ(only_further<Poly>("poly { 2.9 <1 2 3 4 5 6 7 8 9 10> sturm on }").data->degree, 2);
    EXPECT_EQ(only_further<Poly>("cubic { <1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20> }").data->degree, 3);
    const Poly quartic = only_further<Poly>(
        "quartic { <1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35> sturm off }");
    EXPECT_EQ(quartic.data->coefficients.back(), 35.0);
    EXPECT_EQ(error_of("poly { 1, <1,2,3,4> }"), "Order of poly is out of range.");
    EXPECT_EQ(error_of("poly { 36, <1,2,3,4> }"), "Order of poly is out of range.");
    EXPECT_EQ(error_of("poly { 2, 1 }"), "Expected '<', float function 'float constant' found instead");
    EXPECT_EQ(error_of("cubic { <1,2,3> }"), "Expected 'numeric expression', > found instead");
    EXPECT_EQ(error_of("poly { 2, <1,2,3,4,5,6,7,8,9,10,11> }"), "Expected '>', , found instead");
}

TEST(Polynomials, SingleTerms) {
    const Poly sphere = only_further<Poly>("polynomial { 2, xyz(2,0,0): 1, xyz(0,2,0): 1, xyz(0,0,2): 1 xyz(0,0,0): -1 sturm }");
    EXPECT_EQ(sphere, make_poly(2, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}));
    EXPECT_EQ(only_further<Poly>("polynomial { 2, xyz(1,1,0): 3, xyz(1,1,0): 4 }").data->coefficients[1], 4.0);
    EXPECT_THAT(only_further<Poly>("polynomial { 2 }").data->coefficients, testing::Each(0.0));
    EXPECT_EQ(error_of("polynomial { 40, xyz(2,0,0): 1 }"), "Order of polynom is out of range.");
    EXPECT_EQ(error_of("polynomial { 2, xyz(3,0,0): 1 }"), "Coefficient of polynom is out of range.");
    EXPECT_EQ(error_of("polynomial { 2, xyz(1,1,1): 1 }"), "Coefficient of polynom is out of range.");
    EXPECT_EQ(error_of("polynomial { 2, xyz(0,0,-1): 1 }"), "Coefficient of polynom is out of range.");
    EXPECT_EQ(error_of("polynomial { 2, xyz(2,0,0) 1 }"), "Expected ':', float function 'float constant' found instead");
    EXPECT_EQ(error_of("polynomial { 2, xyz(2,0,0): 1, abc(2,0,0): 1 }"),
              "No matching } in 'polynomial', undeclared identifier 'abc' found instead");
}

}  // namespace
}  // namespace rt::blocks_polynomial_test
