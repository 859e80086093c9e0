#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/read_scene.h"

namespace rt::string_test {
namespace {

TEST(String, FunctionsOfEveryKind) {
    const std::vector<std::pair<const char*, const char*>> cases{
        {R"("plain")", "plain"},
        {R"("a\nb\tc\\d\"e\'f")", "a\nb\tc\\d\"e'f"},
        {R"("\a\b\f\r\v")", "\a\b\f\r\v"},
        {R"("\u0041\u00e9\u20AC4")",
         "A\xc3\xa9\xe2\x82\xac"
         "4"},
        {R"(concat("a","b" "c"))", "abc"},
        {R"(concat(concat("a"),strupr("bC"),strlwr("De")))", "aBCde"},
        {R"(substr("abcdef",2,3))", "bcd"},
        {R"(substr("abc",4,0))", ""},
        {R"(concat(chr(65),chr(0),chr(233)))", "A\xc3\xa9"},
        {R"(str(1.23456,8,3))", "   1.235"},
        {R"(str(5,-8,1))", "000005.0"},
        {R"(str(-1.5,-8,2))", "-0001.50"},
        {R"(str(2.5,0,-1))", "2.500000"},
        {R"(str(3.7,0,0))", "4"},
        {R"(str(1/3,0,20))", "0.33333333333333331483"},
        {R"(vstr(2,<1,2,3>,"; ",5,1))", "  1.0;   2.0"},
        {R"(vstr(1,<1,2,3>,"; ",5,1))", "  1.0;   2.0"},
        {R"(vstr(7,<1,2,3>,",",0,1))", "1.0,2.0,3.0,0.0,0.0"},
        {R"(vstr(3,7,",",0,0))", "7,0,0"},
        {R"(substr("a\u20acb\u00e4",2,2))", "\u20acb"},
        {R"(str(strlen("a\u20acb\u00e4"),0,0))", "4"},
        {R"(str(asc("\u20acb"),0,0))", "8364"},
        {R"(Name)", "value"},
        {R"(concat(Name,Name))", "valuevalue"},
        {R"(input_file_name)", "t.pov"},
    };
    for (const auto& [expression, text] : cases)
        EXPECT_EQ(debug_text("#declare Name = \"value\"\n#debug " + std::string(expression)), text) << expression;
}

TEST(String, MistakesAreNamedAsPovRayNamesThem) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {R"(#debug 1)", "Expected 'string expression', float function 'float constant' found instead"},
        {R"(#debug nobody)", "Expected 'string expression', undeclared identifier 'nobody' found instead"},
        {R"(#debug concat())", "Expected 'string expression', ) found instead"},
        {R"(#debug concat("a",1))", "Expected 'string expression', float function 'float constant' found instead"},
        {R"(#debug concat "a")", "Expected '(', string literal found instead"},
        {R"(#debug concat("a";)", "Expected ')', ; found instead"},
        {R"(#debug str(1))", "Expected 'numeric expression', ) found instead"},
        {R"(#debug vstr(3,x,1))", "Expected 'string expression', float function 'float constant' found instead"},
        {R"(#debug substr("\u20ac\u20ac",1,3))", "Illegal parameters in substr."},
        {R"(#debug substr("abc",2,5))", "Illegal parameters in substr."},
        {R"(#debug substr("abc",2,-1))", "Illegal parameters in substr."},
        {R"(#debug substr("abc",1e300,1))", "Illegal parameters in substr."},
        {R"(#debug chr(-1))", "Value -1 cannot be used in chr(...)."},
        {R"(#debug "a\qb")", "Illegal escape sequence in string."},
        {R"(#debug "a\0")", "Illegal escape sequence in string."},
        {R"(#debug str(1,1e9,3))", "Illegal parameters in str."},
        {R"(#debug str(1,3,1e9))", "Illegal parameters in str."},
        {R"(#debug str(1,1/0,3))", "Illegal parameters in str."},
        {"#debug \"a\\\nb\"", "Unterminated string literal."},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
}

TEST(String, AnEscapeIsPointedAt) {
    EXPECT_EQ(read_scene("#debug \"ab\\qc\"").error,
              "File 't.pov' line 1: Parse Error: Illegal escape sequence in string.\n"
              "   1 | #debug \"ab\\qc\"\n"
              "     |           ^^");
}

TEST(String, DoublingEndsAtALimit) {
    std::string scene = "#declare S0 = \"0123456789abcdef\"\n";
    for (int i = 0; i < 40; ++i)
        scene += "#declare S" + std::to_string(i + 1) + " = concat(S" + std::to_string(i) + ",S" + std::to_string(i) + ")\n";
    EXPECT_EQ(error_text(scene), "A string is longer than 1048576 bytes. --limit string=N allows more.");
}

}  // namespace
}  // namespace rt::string_test
