// Numeric expressions. The expected values are closed forms; every line was first shown to POV-Ray 3.7.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "syntax/reader.h"
#include "tests/syntax/read_scene.h"

namespace rt::expression_test {
namespace {

constexpr double inf = infinity;
const double root2 = std::sqrt(2.0);
const double e = std::exp(1.0);

struct Case {
    const char* expression;
    std::vector<double> value;
};

/// The names that the cases use.
constexpr const char* names =
    "#declare A = 5; #declare V = <1,2,3>; #declare W = <1,2,3,4>; #declare U = <7,8>; #declare C = rgbft <.25,.5,.75,.125,.0625>;\n"
    "#declare S = seed(1); #declare T = seed(42); #declare B = sphere { 0, 1 }\n";

const std::vector<Case> cases{
    // literals
    {"1", {1}},
    {".5", {.5}},
    {"1.", {1}},
    {"1e-3", {.001}},
    {".5e1", {5}},
    {"1.e2", {100}},
    {"1E+2", {100}},
    {"1e", {1}},
    {"0.50001", {.50001}},
    {"123456789012345", {123456789012345.0}},
    {"<1,2>", {1, 2}},
    {"<1,2,3>", {1, 2, 3}},
    {"<1,2,3,4>", {1, 2, 3, 4}},
    {"<1,2,3,4,5>", {1, 2, 3, 4, 5}},
    {"<1,2,3,>", {1, 2, 3}},
    {"<1 2 3>", {1, 2, 3}},
    {"<1 -2, 3>", {-1, 3}},
    {"<1,2,3 4>", {1, 2, 3, 4}},
    // operators
    {"1+2*3", {7}},
    {"(1+2)*3", {9}},
    {"2-3-4", {-5}},
    {"8/4/2", {1}},
    {"-2*-3-4/2*3+1", {1}},
    {"2--1", {3}},
    {"--1", {1}},
    {"-+1", {-1}},
    {"!1+1", {1}},
    {"!<1,0,2>", {0, 1, 0}},
    {"100*!0+1000*(!!5)", {1100}},
    {"-<1,2>+3", {2, 1}},
    {"-x.x", {-1}},
    // relations and junctions, inside parentheses only
    {"(<1,2,3> < 2)", {1, 0, 0}},
    {"(1 < <2,0,3>)", {1, 0, 1}},
    {"(<2,2,3> = <2,9,3>)", {1, 0, 1}},
    {"(1=1+1e-11)", {1}},
    {"(1e-10=0)", {1}},
    {"(1.1e-10=0)", {0}},
    {"(0<=-1e-10)", {1}},
    {"(1e-10 & 1)", {0}},
    {"(0.1+0.2=0.3)", {1}},
    {"(1=1+2e-10)", {0}},
    {"(1!=1)", {0}},
    {"(1!=1+1e-11)", {0}},
    {"(1<1+1e-11)", {1}},
    {"(1<=1-1e-11)", {1}},
    {"(1<=1-1e-9)", {0}},
    {"(1>=1+1e-11)", {1}},
    {"(1>=1+1e-9)", {0}},
    {"(1+1e-11>1)", {1}},
    {"(2<1)", {0}},
    {"(3>2>1)", {0}},
    {"(1<2<3)", {1}},
    {"(1 | 1 & 0)", {0}},
    {"(0 & 1 | 1)", {1}},
    {"(1=0 | 1 & 0)", {0}},
    {"(<1,1,0> & <1,0,0>)", {1, 0, 0}},
    {"(1e-11 & 1)", {0}},
    {"(1 ? 2 : 3)", {2}},
    {"(0 ? 2 : <1,2,3>)", {1, 2, 3}},
    {"(1e-11 ? 1 : 2)", {2}},
    {"(1=1 ? 2 : 3 ? 4 : 5)", {2}},
    {"(0 ? 1 : 0 ? 2 : 7)", {7}},
    {"(\"a\" = \"a\")", {1}},
    {"(\"a\" < \"b\")", {1}},
    {"(\"a\" != \"a\")", {0}},
    // promotion
    {"1-<1,2,3>", {0, -1, -2}},
    {"<1,2>+<0,0,5>", {1, 2, 5}},
    {"<1,2,3>*<4,5,6>/2-1", {1, 4, 8}},
    {"V*V", {1, 4, 9}},
    {"2*V+x", {3, 4, 6}},
    {"C+.5", {.75, 1, 1.25, .625, .5625}},
    {"C*2", {.5, 1, 1.5, .25, .125}},
    {"C*<2,3,4>", {.5, 1.5, 3, 0, 0}},
    // components
    {"V.x", {1}},
    {"V.y+V.z", {5}},
    {"W.t", {4}},
    {"W.filter", {4}},
    {"V.u+V.v", {3}},
    {"C.red", {.25}},
    {"C.green", {.5}},
    {"C.blue+C.filter+C.transmit", {.9375}},
    {"V.blue", {3}},
    {"V.gray", {.297 + 2 * .589 + 3 * .114}},
    {"A.x", {5}},
    {"(5).x", {5}},
    {"<1,2,3>.y", {2}},
    {"U.v", {8}},
    // constants
    {"x+2*y+3*z", {1, 2, 3}},
    {"1*t", {0, 0, 0, 1}},
    {"u+2*v", {1, 2}},
    {"pi", {3.14159265358979323846}},
    {"true+yes+on-false-no-off", {3}},
    {"version", {3.7}},
    {"clock+clock_on+clock_delta+final_clock+final_frame+frame_number+initial_clock+initial_frame", {0}},
    // functions of one float
    {"abs(-3)", {3}},
    {"acos(.5)", {std::acos(-1.0) / 3}},
    {"acosh(2)", {std::log(2 + std::sqrt(3.0))}},
    {"asin(.5)", {std::acos(-1.0) / 6}},
    {"asinh(1)", {std::log(1 + root2)}},
    {"atan(1)", {std::acos(-1.0) / 4}},
    {"atanh(.5)", {std::log(3.0) / 2}},
    {"ceil(1.2)", {2}},
    {"cos(pi/3)", {.5}},
    {"cosh(1)", {(e + 1 / e) / 2}},
    {"degrees(pi)", {180}},
    {"exp(1)", {e}},
    {"floor(-1.2)", {-2}},
    {"int(-2.5)", {-2}},
    {"int(1e10)", {-2147483648.0}},
    {"ln(2)", {std::log(2.0)}},
    {"log(100)", {2}},
    {"radians(180)", {std::acos(-1.0)}},
    {"sin(pi/6)", {.5}},
    {"sin(1<2)", {std::sin(1.0)}},
    {"sinh(1)", {(e - 1 / e) / 2}},
    {"sqrt(2)", {root2}},
    {"tan(pi/4)", {1}},
    {"tanh(1)", {(e - 1 / e) / (e + 1 / e)}},
    // functions of several floats
    {"atan2(1,-1)", {std::acos(-1.0) * .75}},
    {"div(-7,2)", {-3}},
    {"div(7,2.9)", {2}},
    {"mod(-7,3)", {-1}},
    {"mod(7.5,2)", {1.5}},
    {"pow(2,10)", {1024}},
    {"pow(2 3)", {8}},
    {"min(3,1,2)", {1}},
    {"max(1,5,2)", {5}},
    {"max(1)", {1}},
    {"select(-1,1,2)", {1}},
    {"select(0,1,2)", {2}},
    {"select(1,1,2)", {2}},
    {"select(-1e-11,1,2,3)", {1}},
    {"select(0,1,2,3)", {2}},
    {"select(1e-11,1,2,3)", {3}},
    {"bitwise_and(6,3,2)", {2}},
    {"bitwise_and(-1,5.9)", {5}},
    {"bitwise_or(4,1)", {5}},
    {"bitwise_or(1e10,3)", {-2147483645.0}},
    {"bitwise_xor(6,3)", {5}},
    // state' = (1812433253 state + 12345) mod 2^32; the number is state' / (2^32 - 1)
    {"rand(S)", {1812445598.0 / 4294967295.0}},
    {"rand(T)", {3107764939.0 / 4294967295.0}},
    // vectors
    {"vlength(<3,4,0>)", {5}},
    {"vlength(1)", {std::sqrt(3.0)}},
    {"vlength(<3,4>)", {5}},
    {"vdot(1,<1,2,3>)", {6}},
    {"vcross(x,y)", {0, 0, 1}},
    {"vnormalize(<3,0,4>)", {.6, 0, .8}},
    {"vrotate(x,<0,0,90>)", {0, 1, 0}},
    {"vrotate(y,<90,0,0>)", {0, 0, 1}},
    {"vrotate(z,<0,90,0>)", {1, 0, 0}},
    {"vrotate(<1,2,3>,<90,90,0>)", {2, -3, -1}},
    {"vaxis_rotate(x,<0,0,2>,30)", {std::sqrt(3.0) / 2, .5, 0}},
    {"vaxis_rotate(<1,2,3>,<1,1,1>,120)", {3, 1, 2}},
    // strings to numbers
    {"asc(\"abc\")+asc(\"\")", {97}},
    {"strlen(concat(\"ab\",\"cde\"))", {5}},
    {"strcmp(\"a\",\"c\")", {-2}},
    {"strcmp(\"abc\",\"ab\")", {99}},
    {"val(\"12.5\")+val(\" 7x\")+val(\"no\")", {19.5}},
    {"file_exists(\"there\")", {0}},
    {"file_exists(\"there.inc\")+10*file_exists(\"nowhere.inc\")", {1}},
    {"defined(A)+10*defined(Nobody)+100*defined(sphere)+1000*defined(B)", {1001}},
};

double absolute_error_allowed(double x) { return 4e-15 * std::fmax(1.0, std::fabs(x)); }

Number evaluate(const std::string& expression, const std::string& declarations, std::vector<std::string>* log = nullptr) {
    Scene scene;
    ParseOptions options;
    options.read_include = [](const std::string& path) -> std::optional<std::string> {
        if (path == "there.inc") return "";
        return std::nullopt;
    };
    const MessageSink sink = [&](std::string_view m) {
        if (log) log->emplace_back(m);
    };
    Reader reader(options, scene, sink);
    reader.open({"t.pov", declarations + expression + ";"});
    return reader.parse_condition();
}

TEST(Expression, ValuesOfEveryRule) {
    for (const Case& c : cases) {
        SCOPED_TRACE(c.expression);
        Number n;
        ASSERT_NO_THROW(n = evaluate(c.expression, names));
        ASSERT_EQ(n.size, static_cast<int>(c.value.size()));
        for (int i = 0; i < n.size; ++i) EXPECT_NEAR(n.v[i], c.value[i], absolute_error_allowed(c.value[i])) << "component " << i;
    }
}

TEST(Expression, DeclaredColorsAreSinglePrecision) {
    const Number n = evaluate("C*2", "#declare C = rgb <.1,.2,.3>;\n");
    EXPECT_TRUE(n.color);
    EXPECT_EQ(n.v[0], 2.0 * static_cast<double>(.1f));
    EXPECT_EQ(n.v[2], 2.0 * static_cast<double>(.3f));
}

TEST(Expression, PlainLiteralsReadLikeAnyOther) {
    // The first of each pair takes the fast path, the second does not.
    for (const auto& [plain, other] :
         {std::pair{"<-1.25, .5,3e2>", "<-1.25, .5,3e2,>"}, {"<1,2,3>", "(<1,2,3>)"}, {"< 1 , 2 , 3 >", "<1,2,3>*1"}}) {
        EXPECT_EQ(evaluate(plain, ""), evaluate(other, "")) << plain;
    }
    EXPECT_EQ(evaluate("<1,2,3>*2", "").v[2], 6);
    EXPECT_EQ(evaluate("<1,2,3>.z", "").v[0], 3);
    EXPECT_EQ(evaluate("<1,2,3>/* comment */*2", "").v[2], 6);
    EXPECT_EQ(evaluate("<1,2,3>#if(1)*2#end", "").v[2], 6);
}

TEST(Expression, DivisionByZeroWarnsAndGivesPlusInfinity) {
    for (const auto& [text, value, warnings] : {std::tuple{"1/0", "inf", 1}, {"-1/0", "inf", 1}, {"0/0", "inf", 1}}) {
        const Outcome o = read_scene(std::string("#declare A = ") + text + "; #debug str(A,0,3)");
        ASSERT_EQ(o.messages.size(), static_cast<std::size_t>(warnings + 1)) << text << o.error;
        EXPECT_THAT(o.messages[0], testing::HasSubstr("Parse Warning: Divide by zero.")) << text;
        EXPECT_EQ(o.messages.back(), value) << text;
    }
    const Outcome o = read_scene("#declare A = <1,2,3>/<1,2>; #debug vstr(3,A,\",\",0,1)");
    EXPECT_EQ(o.messages.back(), "1.0,1.0,inf");
    EXPECT_EQ(o.messages[0],
              "File 't.pov' line 1: Parse Warning: Divide by zero.\n"
              "   1 | #declare A = <1,2,3>/<1,2>; #debug vstr(3,A,\",\",0,1)\n"
              "     |              ^^^^^^^^^^^^^");
}

TEST(Expression, DomainsAreLeftWithAWarning) {
    EXPECT_THAT(read_scene("#declare A = acos(2);").log(), testing::HasSubstr("Parse Warning: Domain error in acos."));
    EXPECT_EQ(debug_text("#declare A = vnormalize(<0,0,0>); #debug vstr(3,A,\",\",0,1)").substr(0, 75),
              "File 't.pov' line 1: Possible Parse Error: Normalizing zero-length vector.\n");
}

TEST(Expression, NotFiniteNumbersMayBeDeclaredButNotUsed) {
    for (const char* value : {"1e999", "exp(1000)", "acosh(.5)", "mod(5,0)", "pow(-1,.5)", "1/0"}) {
        const std::string declaration = std::string("#declare A = ") + value + ";\n";
        EXPECT_EQ(read_scene(declaration).error, "") << value;
        EXPECT_THAT(read_scene(declaration + "sphere { 0, A }").error, testing::HasSubstr("line 2: Parse Error: ")) << value;
        EXPECT_THAT(read_scene(declaration + "sphere { <0,A,0>, 1 }").error, testing::HasSubstr("line 2: Parse Error: ")) << value;
    }
    EXPECT_EQ(read_scene("sphere { <0,\n1e999,0>, 1 }").error,
              "File 't.pov' line 1: Parse Error: Expected 'finite number', inf found instead\n"
              "   1 | sphere { <0,\n"
              "     |          ^^^");
}

struct Mistake {
    const char* expression;
    const char* text;
};

TEST(Expression, MistakesAreNamedAsPovRayNamesThem) {
    const std::vector<Mistake> mistakes{
        {"A=sin(<1,2,3>);", "Float expected but vector or color expression found."},
        {"A=max(x);", "Float expected but vector or color expression found."},
        {"A=vlength(<1,2,3,4>);", "Vector expected but color expression found."},
        {"A=<1,2,3,4,5,6>;", "Expected '>', , found instead"},
        {"A=<1,2,,3>;", "Expected '>', , found instead"},
        {"A=<1,2,foo>;", "Expected '>', undeclared identifier 'foo' found instead"},
        {"A=<1,foo,2>;", "Expected 'numeric expression', undeclared identifier 'foo' found instead"},
        {"A=<1>;", "Expected 'numeric expression', > found instead"},
        {"A=<>;", "Expected 'numeric expression', > found instead"},
        {"A=<1,2,3>.foo;", "Expected 'x, y, z or color component', undeclared identifier 'foo' found instead"},
        {"A=<1,2>.z;", "Bad operands for period operator."},
        {"A=<1,2,3>.t;", "Bad operands for period operator."},
        {"A=<1,2,3,4>.transmit;", "Bad operands for period operator."},
        {"A=(1,2);", "Expected ')', , found instead"},
        {"A=((1);", "Expected ')', ; found instead"},
        {"A=sin(1,2);", "Expected ')', , found instead"},
        {"A=sin 1;", "Expected '(', float function 'float constant' found instead"},
        {"A=sin(1;", "Expected ')', ; found instead"},
        {"A=sin();", "Expected 'numeric expression', ) found instead"},
        {"A=pow(1);", "Expected 'numeric expression', ) found instead"},
        {"A=max();", "Expected 'numeric expression', ) found instead"},
        {"A=max(1 2);", "Expected ')', float function 'float constant' found instead"},
        {"A=max(1<2,0);", "Expected ')', < found instead"},
        {"A=max(1,);", "Expected 'numeric expression', ) found instead"},
        {"A=-;", "Expected 'numeric expression', ; found instead"},
        {"A=-sphere;", "Expected 'numeric expression', sphere found instead"},
        {"A=1+\"a\";", "Expected 'numeric expression', string literal found instead"},
        {"A=1+foo;", "Expected 'numeric expression', undeclared identifier 'foo' found instead"},
        {"A=(1==1);", "Expected 'numeric expression', = found instead"},
        {"A=(1<>1);", "Expected 'numeric expression', > found instead"},
        {"A=(1?2);", "Expected ':', ) found instead"},
        {"A=(rgb .5)*2;", "Expected 'numeric expression', color keyword 'rgb' found instead"},
        {"A=1+rgb <1,1,1>;", "Expected 'numeric expression', color keyword 'rgb' found instead"},
        {"A=1..2;", "Unexpected additional '.' in floating-point number"},
        {"A=1.2.3;", "Unexpected additional '.' in floating-point number"},
        {"A=sqrt(-1);", "sqrt of negative number -1.000000"},
        {"A=ln(0);", "ln of negative number 0.000000"},
        {"A=log(-1);", "log of negative number -1.000000"},
        {"A=atan2(0,0);", "Domain error in atan2!"},
        {"A=rand(0);", "Illegal random number generator."},
        {"A=dimensions(B);", "Expected 'array identifier', undeclared identifier 'B' found instead"},
        {"A=inside(B,1);", "Object identifier expected."},
        {"A=trace(B,1,1);", "Object identifier expected."},
        {"A=strlen(1);", "Expected 'string expression', float function 'float constant' found instead"},
        {"A=strlen(B);", "Expected 'string expression', undeclared identifier 'B' found instead"},
        {"A=(\"a\");", "Expected 'string comparison operator', ) found instead"},
    };
    for (const Mistake& m : mistakes) EXPECT_EQ(error_text(std::string("#declare ") + m.expression), m.text) << m.expression;
}

TEST(Expression, ObjectsAreNoNumbers) {
    EXPECT_EQ(error_text("#declare A = sphere { 0, 1 } #declare B = 1+A;"),
              "Expected 'numeric expression', object identifier found instead");
    EXPECT_EQ(error_text("sphere { 1, <1,2,3> }"), "Float expected but vector or color expression found.");
    EXPECT_EQ(error_text("sphere { <1,2,3,4>, 1 }"), "Vector expected but color expression found.");
    EXPECT_EQ(error_text("#declare C = rgb 1; sphere { C, 1 }"), "Vector expected but color expression found.");
}

TEST(Expression, DeepNestingIsALimitNotACrash) {
    for (const char* unit : {"(", "-(", "<", "sin(", "(1?"}) {
        std::string text = "#declare A = ";
        for (int i = 0; i < 200'000; ++i) text += unit;
        const Outcome o = read_scene(text);
        EXPECT_TRUE(o.limit) << unit;
        EXPECT_THAT(o.error,
                    testing::HasSubstr(fmt::format("Blocks and parentheses are nested more than {} deep. --limit nesting=N allows more.",
                                                   nesting_that_fits())))
            << unit;
    }
    EXPECT_EQ(debug_text("#declare A = " + std::string(200'001, '-') + "7; #debug str(A,0,0)"), "-7");
    EXPECT_EQ(debug_text("#declare A = " + std::string(99, '(') + "7" + std::string(99, ')') + "; #debug str(A,0,0)"), "7");
}

}  // namespace
}  // namespace rt::expression_test
