#include <gtest/gtest.h>

#include "tests/syntax/read_scene.h"

namespace rt::conditional_test {
namespace {

TEST(Conditional, TheRightBranchIsRead) {
    const std::vector<std::pair<const char*, const char*>> cases{
        {"#if(1) #debug \"a\" #else #debug \"b\" #end", "a"},
        {"#if(0) #debug \"a\" #else #debug \"b\" #end", "b"},
        {"#if(0) #debug \"a\" #end #debug \"c\"", "c"},
        {"#if(0) #debug \"a\" #elseif(1) #debug \"b\" #else #debug \"c\" #end", "b"},
        {"#if(0) #elseif(0) #debug \"b\" #elseif(1) #debug \"c\" #elseif(1) #debug \"d\" #else #debug \"e\" #end", "c"},
        {"#if(1) #debug \"a\" #elseif(1) #debug \"b\" #end #debug \"c\"", "ac"},
        {"#if(1) #if(0) #debug \"a\" #else #debug \"b\" #end #debug \"c\" #else #debug \"d\" #end", "bc"},
        {"#if(1e-11) #debug \"a\" #end #if(1e-9) #debug \"b\" #end", "b"},
        {"#declare A = 0.1+0.2; #if(A = 0.3) #debug \"equal\" #end", "equal"},
        {"#if(1 & 0 | 1) #debug \"a\" #end", "a"},
        {"#if(\"a\" = \"a\") #debug \"a\" #end", "a"},
        {"#ifdef(A) #debug \"a\" #else #debug \"b\" #end", "b"},
        {"#declare A = 1; #ifdef(A) #debug \"a\" #else #debug \"b\" #end", "a"},
        {"#ifndef(A) #debug \"a\" #else #debug \"b\" #end", "a"},
        {"#ifndef(A) #elseif(1) #debug \"b\" #end #debug \"c\"", "c"},
        {"#ifdef(sphere) #debug \"a\" #end #ifndef(sphere) #debug \"b\" #end #ifdef(1) #debug \"c\" #end", "b"},
        {"#ifdef(pi) #debug \"a\" #end #ifdef(image_width) #debug \"b\" #end", "b"},
        {"#\n if (1) #debug \"a\" #  end", "a"},
        {"#if(1) #debug \"a\" #else #debug \"b\" #else #debug \"c\" #end", "a"},
        {"#if(#if(1) 1 #end) #debug \"a\" #end", "a"},
        {"#", ""},
    };
    for (const auto& [scene, text] : cases) EXPECT_EQ(debug_text(scene), text) << scene;
}

TEST(Conditional, StandsBetweenAnyTwoTokens) {
    EXPECT_EQ(debug_text("#declare A = <1,#if(1) 2 #else 3 #end,4>; #debug vstr(3,A,\",\",0,0)"), "1,2,4");
    EXPECT_EQ(debug_text("#declare A = (1 #if(1) + 2 #end); #debug str(A,0,0)"), "3");
    const Outcome o = read_scene("sphere { 0, #ifdef(Big) 10 #else 1 #end #declare B = 3; pigment { rgb B } }");
    ASSERT_TRUE(o.scene) << o.error;
    EXPECT_EQ(o.scene->objects.size(), 1u);
}

TEST(Conditional, SkippedTextNeedsTokensOnly) {
    const std::vector<const char*> skipped{
        "anything < goes ( here } ] ; 1 2 3",
        "\"#end\"",
        "/* #end */",
        "// #end\n",
        "@ $ ' ~ 1e",
        "#if(foo bar #end",
        "#ifdef #end #ifndef #else #end",
        "#while(1) #end #for(i,1,2) #end #switch(1) #case(1) #else #end #macro A() #else #end",
        "#foo #include \"nope\" #error \"no\" #declare",
        "#if(0) #elseif #else #end",
    };
    for (const char* text : skipped) EXPECT_EQ(debug_text("#if(0) " + std::string(text) + " #end #debug \"after\""), "after") << text;
}

TEST(Conditional, MistakesAreNamedAsPovRayNamesThem) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {"#end", "Mis-matched '#end'."},
        {"#else", "Mis-matched '#else'."},
        {"#elseif(1)", "Mis-matched '#elseif'."},
        {"#if(1) #end #end", "Mis-matched '#end'."},
        {"#if(0) #else #else #end", "Mis-matched '#else'."},
        {"#if(0) #else #elseif(1) #end", "Mis-matched '#elseif'."},
        {"#if(1)", "End of file reached but #end expected."},
        {"#if(0)", "End of file reached but #end expected."},
        {"#if(1) #if(1) #end", "End of file reached but #end expected."},
        {"#if(0) #if(1) #end", "End of file reached but #end expected."},
        {"#ifdef(A) #else", "End of file reached but #end expected."},
        {"#ifdef(A)", "End of file reached but #end expected."},
        {"#ifdef A #end", "Expected '(', undeclared identifier 'A' found instead"},
        {"#ifdef(A B) #end", "Expected ')', undeclared identifier 'B' found instead"},
        {"#if 1 #end", "Expected '(', float function 'float constant' found instead"},
        {"#if() #end", "Expected 'numeric expression', ) found instead"},
        {"#if(1 sphere { 0, 1 } #end", "Expected ')', sphere found instead"},
        {"#if(<1,0,0>) #end", "Float expected but vector or color expression found."},
        {"#if(\"a\") #end", "Expected 'string comparison operator', ) found instead"},
        {"#if(0) 1..2 #end", "Unexpected additional '.' in floating-point number"},
        {"#if(0) \xe9 #end", "Illegal character in input file, value is e9."},
        {"#if(0) \"abc #end", "No end quote for string."},
        {"#if(0) #elseif(#end 1) #end", "Mis-matched '#end'."},
        {"#break", "Invalid context for #break"},
        {"#if(1) #break #end", "Invalid context for #break"},
        {"#case(1)", "Mis-matched '#case' or '#range'."},
        {"#range(1,2)", "Mis-matched '#case' or '#range'."},
        {"#foo", "Expected 'object or directive', undeclared identifier 'foo' found instead"},
        {"#1", "Expected 'object or directive', float function 'float constant' found instead"},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
}

TEST(Conditional, TheOpenOneIsPointedAt) {
    EXPECT_EQ(read_scene("#if(1)\n  # ifdef(A)\n#end\nsphere { 0, 1 }\n").error,
              "File 't.pov' line 1: Parse Error: End of file reached but #end expected.\n"
              "   1 | #if(1)\n"
              "     | ^^^");
}

TEST(Conditional, AThousandInARowAreNoNesting) {
    std::string scene;
    for (int i = 0; i < 5000; ++i) scene += "#if(1) #declare A = 1; #declare B = sphere { 0, 1 } #else #end\n";
    EXPECT_EQ(read_scene(scene).error, "");
}

TEST(Conditional, DirectivesInsideDirectivesAreALimitNotACrash) {
    std::string scene;
    for (int i = 0; i < 100'000; ++i) scene += "#declare A = 1 + ";
    EXPECT_TRUE(read_scene(scene).limit);
    scene.clear();
    for (int i = 0; i < 100'000; ++i) scene += "#if(";
    EXPECT_TRUE(read_scene(scene).limit);
}

}  // namespace
}  // namespace rt::conditional_test
