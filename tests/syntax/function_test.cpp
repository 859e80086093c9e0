// function { } and spline { }, as measured on POV-Ray.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/syntax/read_scene.h"

namespace rt::function_test {
namespace {

using Cases = std::vector<std::pair<std::string, std::string>>;

const std::string show = "#macro Show(A) #debug concat(str(A,0,3),\" \") #end ";

/// What `#debug` writes, without the last line, which says that splines are experimental.
std::string shown(const std::string& scene) {
    const Outcome o = read_scene(show + scene);
    if (!o.error.empty()) return o.error;
    std::string text;
    for (const std::string& message : o.messages)
        if (!message.starts_with("Parse Warning: This rendering uses the following experimental feature(s): spline.")) text += message;
    return text;
}

TEST(DeclaredFunction, ComputesItsExpression) {
    const Cases cases{
        {"#declare F=function(x){x+1} Show(F(2)) Show(F(2)*3)", "3.000 9.000 "},
        {"#declare F=function{x+y*2+z*3} Show(F(1,2,3)) Show(F(1 2 3))", "14.000 14.000 "},
        {"#declare N=2; #declare F=function(x){x*N} #declare N=5; Show(F(1))", "2.000 "},
        {"#declare F=function(x){-x*x+2*-x} Show(F(3))", "-15.000 "},
        {"#declare F=function(x){x<2} Show(F(3)) Show(F(1))", "0.000 1.000 "},
        {"#declare F=function(a,b,c){a | b & c} Show(F(1,1,0)) Show(F(0,1,0)) Show(F(0,1,1))", "1.000 0.000 1.000 "},
        {"#declare F=function(x){int(x)} Show(F(3e9)) Show(F(-2.7))", "-2147483648.000 -2.000 "},
        {"#declare F=function(a,b){div(a,b)} Show(F(7e10,2)) Show(F(7,0))", "-2147483648.000 -2147483648.000 "},
        {"#declare F=function(a,a){a*10+1} Show(F(1,2))", "11.000 "},
        {"#declare F=function(i){sum(i,1,3,i)+i} Show(F(10))", "16.000 "},
        {"#declare T=function{transform{translate <1,2,3>}} #declare F=function(a){T(a,0,0).x+T(0,a,0).y*100} Show(F(1))", "302.000 "},
        {"#declare T=function{transform{scale 2}} #declare F=function(a){T(1,1,a).z} #declare G=function(a){F(a)+1} Show(G(3))", "7.000 "},
        {"#declare F=function(x){x<2 & x>1 | x=5} Show(F(1.5)) Show(F(5)) Show(F(0))", "1.000 1.000 0.000 "},
        {"#declare F=function(x){(x<=2)+(x>=2)+(x!=2)} Show(F(2)) Show(F(3))", "2.000 2.000 "},
        {"#declare F=function(x){x=1+1e-11} Show(F(1))", "0.000 "},
        {"#declare F=function(x){1/x} Show(F(0))", "inf "},
        {"#declare F=function(x){mod(x,3)+div(x,3)+int(x)} Show(F(-7.5))", "-10.500 "},
        {"#declare F=function(x){atan2(x,0)+pow(x,.5)+max(x,1,2)+min(x,7)+degrees(x)+radians(x)+abs(x)} Show(F(3))", "184.243 "},
        {"#declare "
         "F=function(x){floor(x)+ceil(x)+exp(x)+sin(x)+asin(x/10)+sinh(x)+cosh(x)+tanh(x)+tan(x)+log(x)+atan(x)+atanh(x/9)+acosh(x)"
         "+asinh(x)} Show(F(1.7))",
         "12.234 "},
        {"#declare F=function(x){select(x,1,2)+select(x,10,20,30)} Show(F(-1)) Show(F(0)) Show(F(1))", "11.000 22.000 32.000 "},
        {"#declare F=function(x){sum(i,1,x,i*i)+prod(i,1,x,i)} Show(F(4)) Show(F(0))", "54.000 1.000 "},
        {"#declare F=function(x){sum(i,1,2,sum(j,1,2,10*i+j+x))} Show(F(0))", "66.000 "},
        {"#declare F=function(a,b){a+b} #declare G=function(a){F(a,2)*3} Show(G(4))", "18.000 "},
        {"#declare F=function(u,v){u+v} Show(F(1,2))", "3.000 "},
        {"#declare F=function(x){x #if(1) +5 #end} Show(F(3))", "8.000 "},
        {"#declare A=array[2]{4,5}; #declare F=function(x){A[1]*x} Show(F(3))", "15.000 "},
        {"#macro P() #local F=function(a){a*2} F(4) #end Show(P()) Show(P())", "8.000 8.000 "},
        {"#macro M(F) F(3) #end #declare G=function(a){a*2} Show(M(G))", "6.000 "},
        {"#declare A=array[1] #declare A[0]=function(a){a*2} Show(A[0](3))", "6.000 "},
        {"#declare F=function(x){x} #undef F #declare F=function(x){2*x} Show(F(1))", "2.000 "},
        {"#declare F=function { transform { translate x rotate 90*z } } #debug vstr(3,F(1,2,3),\",\",0,2)", "-2.00,2.00,3.00"},
        {"#declare F=function { internal(61) } Show(F(1,2,2,1))", "2.000 "},
        {"#declare F=function(x){x} sphere{0,F(2)} #debug \"ok\"", "ok"},
    };
    for (const auto& [scene, text] : cases) EXPECT_EQ(shown(scene), text) << scene;
}

TEST(DeclaredFunction, MistakesAreNamed) {
    const Cases mistakes{
        {"#declare F=function(x){x} #declare F=function(x){x}", "Redeclaring functions is not allowed - #undef the function first!"},
        {"#declare F=function(x){x} #declare F=5;", "Redeclaring functions is not allowed - #undef the function first!"},
        {"#declare F=function{x+y} #debug str(F(1),0,0)", "Expected 'numeric expression', ) found instead"},
        {"#declare F=function{x} #debug str(F(<1,2,3>),0,0)", "Float expected but vector or color expression found."},
        {"#declare F=function{x} #debug str(F,0,0)", "Expected '(', , found instead"},
        {"#declare V=<1,2,3>; #declare F=function(x){x+V}", "Expected 'operand', vector function 'vector identifier' found instead"},
        {"#declare F=function(x){Nope+x}", "Expected 'operand', undeclared identifier 'Nope' found instead"},
        {"#declare F=function(x){F(x)}", "Expected 'operand', undeclared identifier 'F' found instead"},
        {"#declare F=function(x){x,1}", "No matching } in 'function', , found instead"},
        {"#declare F=function(){1}", "Expected 'parameter identifier', ) found instead"},
        {"#declare T=function{transform{scale 2}} #declare F=function(a){T(a,a,a)}", "Expected '.', } found instead"},
        {"#declare T=function{transform{scale 2}} #declare F=function(a){T(a,a,a).t}", "Expected 'x, y or z', t found instead"},
        {"#declare F=function(x){}", "Expected 'operand', } found instead"},
        {"#declare F=function(x){!x}", "Expected 'operand', ! found instead"},
        {"#declare F=function(x){\"a\"}", "Expected 'operand', string literal found instead"},
        {"#declare F=function(1){x}", "Expected 'parameter identifier', float function 'float constant' found instead"},
        {"#declare S=spline{0,1} #declare F=function(x){S(x)}", "A function of floats cannot call one whose values are vectors."},
        {"#declare F=function{internal(0)} #debug str(F(1),0,0)", "'function { internal(0) }' is not modelled."},
        {"#declare F=function{pattern{agate}} #debug str(F(1,2,3),0,0)", "'a pattern's value while reading' is not modelled."},
        {"#declare F=function{pigment{rgb 1}} #debug str(F(1,2,3).x,0,0)", "'a pattern's value while reading' is not modelled."},
        {"#declare F=function{pigment{rgb 1}} #declare G=function{F(x,y,z)}", "Expected '.', } found instead"},
        {"#declare F=function{pigment{rgb 1}} #declare G=function{F(x,y,z).pi}",
         "Expected 'x, y, z or color component', float function 'pi' found instead"},
        {"#declare F=function(a,b,c){pigment{rgb 1}}", "Function parameters for pigment functions are not allowed."},
        {"#declare F=function(a){pattern{wood}}", "Function parameters for pigment functions are not allowed."},
        {"#declare F=function{pattern{slope y}}", "No matching } in 'pattern', slope found instead"},
        {"#declare F=function{pattern{average}}", "No matching } in 'pattern', average found instead"},
        {"sphere{0,1 pigment{function{transform{scale 2}}}}", "A pattern's function is one of x, y and z with a number as value."},
        {"#declare F=function{pattern{rgb 1}}", "Expected 'pattern', color keyword 'rgb' found instead"},
        {"#declare F=function{internal(77)} #declare G=function{F(x,y,z)+1} #debug str(G(1,2,3),0,0)",
         "'function { internal(77) }' is not modelled."},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
}

/// In the place of every pattern: x and whole numbers.
class Counting final : public FunctionSource {
public:
    std::array<double, 6> values(const Vec3& point) const override { return {point.x, 2.0, 3.0, 4.0, 5.0, 6.0}; }
};

std::shared_ptr<const Function> counting(const std::shared_ptr<const Function>& stated) {
    Function function = *stated;
    for (auto& called : function.called) called = counting(called);
    for (auto& source : function.sources) source = std::make_shared<const Counting>();
    return std::make_shared<const Function>(std::move(function));
}

TEST(DeclaredFunction, PatternsAnswerWhileTheSceneIsReadIfSomebodyCompilesThem) {
    int compiled = 0;
    ParseOptions options;
    options.compile_function = [&compiled](const std::shared_ptr<const Function>& stated, const Scene&) {
        ++compiled;
        return counting(stated);
    };
    EXPECT_EQ(debug_text("#declare F=function{pattern{agate}} #for(I,1,3) #debug str(F(I,2,3)*10,0,0) #end", options), "102030");
    EXPECT_EQ(compiled, 1);
    EXPECT_EQ(debug_text("#declare F=function{pigment{agate}} #for(I,1,3) #debug vstr(5,F(I,2,3),\"\",0,0) #end", options),
              "123452234532345");
    EXPECT_EQ(compiled, 2);
    const Outcome o = read_scene("#declare F=function{pattern{agate}} height_field{function 3,2 {F(x/4,y,z)}}", options);
    ASSERT_EQ(o.error, "");
    const auto& field = std::get<HeightField>(std::get<FurtherShape>(o.scene->objects.at(0).shape));
    EXPECT_EQ(field.data->height(2, 0), 16383);
    const Outcome grey = read_scene("height_field{function 3,2 {pigment{agate}}}", options);
    EXPECT_EQ(std::get<HeightField>(std::get<FurtherShape>(grey.scene->objects.at(0).shape)).data->height(2, 0), 0xfffa) << "65535 * 6";
    EXPECT_EQ(error_text("height_field{function 3,2 {pattern{agate}}}"), "'a pattern's value while reading' is not modelled.");
    options.max_replayed_bytes = 10'000;
    EXPECT_TRUE(read_scene("#declare F=function{pigment{agate}} #for(I,1,300) #declare C=F(I,2,3); #end", options).limit);
}

TEST(DeclaredFunction, AsksPigmentsAndPatterns) {
    const Outcome o = read_scene(
        "#declare P=function{pigment{checker rgb 1, rgb 0}} #declare Q=function{pattern{wood scale 2}} "
        "sphere{0,1 pigment{function{P(x,y,z).grey+Q(x,y,z)*P(0,0,0).filter}}}");
    ASSERT_EQ(o.error, "");
    const Pigment& pigment = std::get<PlainTexture>((*o.scene->objects.at(0).texture)->at(0).content).pigment;
    const auto& function = *std::get<std::shared_ptr<const Function>>(std::get<Shared<PatternPigment>>(pigment.content)->pattern.source);
    EXPECT_EQ(function.sources.size(), 2u) << "the pattern is that of a function that is called";
    EXPECT_EQ(function.called.size(), 1u);
    EXPECT_GT(function.source_nodes, 2u);
    // Each asks the one before twice: too many pigments, not an endless picture.
    std::string scene = "#declare F0=function{pigment{rgb 1}}\n";
    for (int i = 1; i < 20; ++i)
        scene += fmt::format("#declare F{}=function{{pigment{{function{{F{}(x,y,z).x+F{}(y,x,z).x}}}}}}\n", i, i - 1, i - 1);
    EXPECT_TRUE(read_scene(scene).limit);
    scene = "#declare P=function{pigment{rgb 1}} #declare F0=function{P(x,y,z).x}\n";
    for (int i = 1; i < 20; ++i) scene += fmt::format("#declare F{}=function{{F{}(x,y,z)+F{}(y,x,z)}}\n", i, i - 1, i - 1);
    EXPECT_TRUE(read_scene(scene).limit);
}

TEST(DeclaredFunction, EndlessAndDoublingOnesEnd) {
    ParseOptions options;
    options.max_replayed_bytes = 1'000'000;
    EXPECT_TRUE(read_scene("#declare F=function(x){sum(i,1,1e300,i)} sphere { 0, F(1) }", options).limit);
    EXPECT_TRUE(read_scene("#declare F=function(x){sum(i,1,1/0,1)} sphere { 0, F(1) }", options).limit);
    std::string scene = "#declare F0=function(x){x}\n";
    for (int i = 1; i < 99; ++i) scene += fmt::format("#declare F{}=function(x){{F{}(x)+F{}(x)}}\n", i, i - 1, i - 1);
    EXPECT_TRUE(read_scene(scene + "sphere { 0, F98(1) }", options).limit);
    EXPECT_EQ(read_scene(scene, options).error, "");
    scene += "#declare F99=function(x){F98(x)} #declare F100=function(x){F99(x)}";
    EXPECT_THAT(read_scene(scene, options).error, testing::HasSubstr("Functions call each other more than 100 deep."));
    EXPECT_TRUE(read_scene("#declare F=function(x){" + std::string(100'000, '-') + "x}", options).limit);
    EXPECT_TRUE(read_scene("#declare F=function(x){" + std::string(100'000, '(') + "x", options).limit);
}

TEST(DeclaredSpline, IsCalledLikeAFunction) {
    const Cases cases{
        {"#declare S=spline{linear_spline 0,<1,2,3>,1,<4,5,6>} #debug vstr(3,S(.5),\",\",0,2) Show(S(.5).y)", "2.50,3.50,4.503.500 "},
        {"#declare S=spline{0,<1,2>,1,<4,5>} #debug vstr(5,S(.5),\",\",0,1)", "2.5,3.5,0.0,0.0,0.0"},
        {"#declare S=spline{0,<1,2,3>} #debug vstr(3,S(1.5),\",\",0,0)", "1,2,3"},
        {"#declare S=spline{cubic_spline 0,x,1,y} #declare T=spline{S 2,z} #debug vstr(3,T(1.5),\",\",0,0)", "0,1,0"},
        {"#declare S=spline{0,x,1,y} #debug vstr(3,S(.25,natural_spline),\",\",0,2)", "0.75,0.25,0.00"},
        {"#declare S=spline{0,x,0,y,1,z} #debug vstr(3,S(.25),\",\",0,2)", "0.00,0.75,0.25"},
        {"#declare S=spline{ #for(I,0,3) I,<I,I*I,0> #end } #debug vstr(3,S(1.5),\",\",0,1)", "1.5,2.5,0.0"},
        {"#declare F=function { spline { 0,<1,2,3>,1,<4,5,6> } } #debug vstr(3,F(.5),\",\",0,1)", "2.5,3.5,4.5"},
    };
    for (const auto& [scene, text] : cases) EXPECT_EQ(shown(scene), text) << scene;
    EXPECT_EQ(error_text("#declare S=spline{} "), "Spline must have at least one entry.");
    EXPECT_EQ(error_text("#declare S=spline{0,1,1,4} #debug str(S(.5),0,2)"), "Float expected but vector or color expression found.");
    EXPECT_EQ(error_text("#declare F=function(x){x} #declare S=spline{F 0,1}"),
              "Expected 'spline identifier', function identifier found instead");
}

}  // namespace
}  // namespace rt::function_test
