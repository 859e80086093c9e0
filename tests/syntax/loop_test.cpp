// #while, #for, #break, #switch, as measured on POV-Ray.
#include <gtest/gtest.h>

#include "tests/syntax/expect_debug.h"

namespace rt::loop_test {
namespace {

TEST(While, RepeatsAsLongAsItsConditionHolds) {
    expect_debug({
        {"#declare I=0; #while(I<3) Show(I) #declare I=I+1; #end Show(I)", "0 1 2 3 "},
        {"#while(0) anything at all #else #end #debug \"after\"", "after"},
        {"#declare N=3; #while(N) #declare N=N-1; #end Show(N)", "0 "},
        {"#declare I=0; #while(I<2) #declare J=0; #while(J<2) Show(10*I+J) #declare J=J+1; #end #declare I=I+1; #end", "0 1 10 11 "},
        {"#declare I=0; #declare A=<1,#while(I<1) #declare I=I+1; 2, #end 4>; #debug vstr(3,A,\",\",0,0)", "1,2,4"},
        {"#declare I=0; #while(I<3) #if(I=1) #declare I=I+1; #else #declare I=I+1; #end Show(I) #end", "1 2 3 "},
    });
    const Outcome o = read_scene("#declare I=0; #while(I<1000) sphere { I*x, 1 } #declare I=I+1; #end");
    ASSERT_TRUE(o.scene) << o.error;
    ASSERT_EQ(o.scene->objects.size(), 1000u);
    EXPECT_EQ(std::get<Sphere>(o.scene->objects[999].shape).center.x, 999.0);
}

TEST(For, CountsUpAndDownWithATolerance) {
    expect_debug({
        {"#for(I,1,3) Show(I) #end Show(I)", "1 2 3 4 "},
        {"#for(I,3,1,-1) Show(I) #end Show(I)", "3 2 1 0 "},
        {"#for(I,3,1) Show(9) #end Show(I)", "3 "},
        {"#declare N=0; #for(I,0,1,.1) #declare N=N+1; #end Show(N)", "11 "},
        {"#declare N=0; #for(I,0,1-1e-9,.1) #declare N=N+1; #end Show(N)", "10 "},
        {"#declare N=0; #for(I,0,1-1e-11,.1) #declare N=N+1; #end Show(N)", "11 "},
        {"#for(I,1,6) #declare I=I+1; Show(I) #end", "2 4 6 "},
        {"#for(I,1,2) #for(J,1,2) Show(10*I+J) #end #end", "11 12 21 22 "},
        {"#for(I 1 2) Show(I) #end", "1 2 "},
    });
}

TEST(Break, LeavesTheInnermostLoopOrSwitch) {
    expect_debug({
        {"#while(1) #if(1) #break #end #debug \"no\" #end #debug \"after\"", "after"},
        {"#while(1) #switch(1) #case(1) #break #end #debug \"in \" #break #end #debug \"after\"", "in after"},
        {"#for(I,1,3) #for(J,1,2) Show(10*I+J) #if(J=1) #if(1) #break #end #end #end #end", "11 21 31 "},
        {"#macro B() #while(1) #break #end #debug \"in \" #end B() #debug \"after\"", "in after"},
        {"#for(I,1,9) #if(I=3) #break #else Show(I) #end #end Show(I)", "1 2 3 "},
    });
}

TEST(Switch, ReadsFromTheFirstCaseThatHoldsToABreak) {
    expect_debug({
        {"#switch(2) #case(1) Show(1) #case(2) Show(2) #case(3) Show(3) #else Show(4) #end", "2 3 4 "},
        {"#switch(2) #case(1) Show(1) #break #case(2) Show(2) #break #case(3) Show(3) #break #else Show(4) #end", "2 "},
        {"#switch(9) #case(1) Show(1) #else Show(4) #end Show(5)", "4 5 "},
        {"#switch(9) #case(1) Show(1) #end Show(5)", "5 "},
        {"#switch(1.5) #range(1,2) Show(1) #range(5,6) Show(2) #else Show(3) #end", "1 2 3 "},
        {"#switch(2) #range(1,2) Show(1) #break #end #switch(1) #range(1,2) Show(2) #break #end", "1 2 "},
        {"#switch(2+1e-11) #case(2) Show(1) #break #else Show(2) #end", "1 "},
        {"#switch(2+1e-11) #range(1,2) Show(1) #break #else Show(2) #end", "2 "},
        {"#switch(1) #declare Q=3; #case(1) Show(Q) #end", "3 "},
        {"#switch(2) #case(1) #switch(2) #case(2) Show(9) #else #end #case(2) Show(1) #end", "1 "},
        {"#switch(1) #case(1) #switch(2) #case(1) Show(9) #case(2) Show(1) #break #end Show(2) #end", "1 2 "},
        {"#switch(3) #case(1) junk { #case(2) ( #else Show(1) #end", "1 "},
    });
}

TEST(Loop, ABreakInAMacroEndsTheMacro) {
    expect_debug({
        {"#macro M(A) Show(A) #break Show(9) #end M(1) Show(2)", "1 2 "},
        {"#macro M(A) #if(1) Show(A) #break Show(9) #end Show(8) #end M(1) Show(2)", "1 2 "},
        {"#macro B() #break Show(9) #end #while(1) B() Show(1) #break #end Show(2)", "1 2 "},
        {"#macro B() #while(1) #break #end Show(1) #end B() Show(2)", "1 2 "},
        {"#macro N() 3 #break #end Show(N()+1)", "4 "},
    });
}

TEST(Loop, MacrosOfDirectivesMayStandBeforeTheFirstCase) {
    expect_debug({
        {"#macro M() Show(3) #end #switch(1) M() #case(1) Show(1) #end", "3 1 "},
        {"#macro M() #end #macro N() M() M() #end #switch(2) N() #case(1) Show(1) #case(2) Show(2) #end", "2 "},
    });
}

TEST(Loop, MistakesAreNamedAsPovRayNamesThem) {
    const Cases mistakes{
        {"#while(1)", "End of file reached but #end expected."},
        {"#while(0)", "End of file reached but #end expected."},
        {"#while(1) #else #end", "Mis-matched '#else'."},
        {"#while(1) #elseif(1) #end", "Mis-matched '#elseif'."},
        {"#while(1 sphere #end", "Expected ')', sphere found instead"},
        {"#while 1 #end", "Expected '(', float function 'float constant' found instead"},
        {"#for(I,1,3,0) #end", "#for loop increment must be non-zero."},
        {"#for(I,1,3,1e-11) #end", "#for loop increment must be non-zero."},
        {"#for(I,\"a\",3) #end", "Expected 'numeric expression', string literal found instead"},
        {"#for(I,1) #end", "Expected 'numeric expression', ) found instead"},
        {"#for(x,1,2) #end", "Expected 'undeclared identifier', vector function 'x' found instead"},
        {"#for(I,1,2) #declare I=x; #end", "The #for loop's counter is no float any more."},
        {"#for(I,1,2) #undef I #end", "The #for loop's counter is no float any more."},
        {"#for(I,1,2)", "End of file reached but #end expected."},
        {"#for(I,1,2) #break", "End of file reached but #end expected."},
        {"#switch(1) junk #case(1) #end", "#switch not followed by #case or #range."},
        {"#switch(1) #end", "Mis-matched '#end'."},
        {"#switch(1) #else #case(1) #end", "Mis-matched '#else'."},
        {"#switch(1) #case(1) #else #case(2) #end", "Mis-matched '#case' or '#range'."},
        {"#switch(1) #case(1) #else #else #end", "Mis-matched '#else'."},
        {"#switch(1) #case(1) #elseif(1) #end", "Mis-matched '#elseif'."},
        {"#switch(\"a\") #case(\"a\") #end", "Expected 'string comparison operator', ) found instead"},
        {"#switch(1) #case(1) #case(Nope) #end", "Expected 'numeric expression', undeclared identifier 'Nope' found instead"},
        {"#switch(1) #case(2)", "End of file reached but #end expected."},
        {"#switch(1) #if(1) #case(1) #end #end", "What stands before the first #case must end in the text it begins in."},
        {"#macro M() #case(1) #end #switch(1) M() #end", "Mis-matched '#case' or '#range'."},
        {"#if(1) #case(1) #end", "Mis-matched '#case' or '#range'."},
        {"#break", "Invalid context for #break"},
        {"#if(1) #break #end", "Invalid context for #break"},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
    EXPECT_EQ(error_text("#while(1) #include \"a.inc\" #end", {}, {{"a.inc", "#break"}}), "Invalid context for #break");
    EXPECT_EQ(error_text("#while(1) #include \"a.inc\"", {}, {{"a.inc", "#end"}}), "Mis-matched '#end'.");
}

}  // namespace
}  // namespace rt::loop_test
