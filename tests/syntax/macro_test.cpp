// #macro and its calls, as measured on POV-Ray.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/expect_debug.h"

namespace rt::macro_test {
namespace {

TEST(Macro, BodiesAreSkippedUntilUsed) {
    EXPECT_EQ(
        debug_text("#macro M(a, b) unknown { } \"#end\" /* #end */ #if(1) #while(0) #end #else #end #local x = 1 #end #debug \"after\""),
        "after");
    EXPECT_EQ(debug_text("#macro M() #end #macro N(a b,c) #end #debug \"after\""), "after");
}

TEST(Macro, CallsStandBetweenAnyTwoTokens) {
    expect_debug({
        {"#macro M(a,b) a+b #end Show(2*M(3,4))", "10 "},
        {"#macro V() <1,2,3> #end Show(V().y)", "2 "},
        {"#macro V() 1,2 #end #debug vstr(3,<V(),3>,\",\",0,0)", "1,2,3"},
        {"#macro Open() sphere{0, #end Open() 1} #debug \"ok\"", "ok"},
        {"#macro Word() sphere #end Word(){0,1} #debug \"ok\"", "ok"},
        {"#macro M(A) sphere{0,A} #end #declare S=M(2); object{S} #debug \"ok\"", "ok"},
        {"#macro M(A) sphere{0,A} #end #declare S=M(2) object{S} #debug \"ok\"", "ok"},
        {"#macro T(A) texture{pigment{A}} #end #declare L=T(rgb 1) texture{pigment{rgb 0}} sphere{0,1 texture{L}} #debug \"ok\"", "ok"},
        {"#macro M() 1 #end #if(M()) #debug \"one\" #end", "one"},
        {"#declare I=0; #macro More() I<3 #end #while(More()) #declare I=I+1; #end Show(I)", "3 "},
        {"#macro M() #debug \"a\" #end #\nmacro N() M() M() #end N()", "aa"},
        {"#macro M() #end #ifdef(M) #debug \"known\" #end", "known"},
        {"#macro M(A,B) #debug concat(A,str(B,0,0)) #end M(\"a\" 1) M(concat(\"b\",\"c\"),1+1)", "a1bc2"},
    });
}

TEST(Macro, ArgumentsAreAnyValue) {
    EXPECT_EQ(read_scene("#macro M(A) sphere{0,1 pigment{A}} #end M(rgb 1) M(color rgb <1,0,0>) #declare C=rgb 1; M(C) M(C*.5)").error, "");
    EXPECT_EQ(read_scene("#macro M(A) sphere{0,1 texture{A}} #end M(texture{pigment{rgb 1}}) M(texture{})").error, "");
    const Outcome o = read_scene("#macro M(A) A object{A} #end M(sphere{0,1})");
    ASSERT_TRUE(o.scene) << o.error;
    EXPECT_EQ(o.scene->objects.size(), 2u);
}

TEST(Macro, NamesArePassedAsThemselvesAndOtherThingsAsValues) {
    expect_debug({
        {"#macro M(P) #declare P = P+1; #end #declare A=5; M(A) Show(A)", "6 "},
        {"#macro M(P) #local P = 7; #end #declare A=1; M(A) Show(A)", "7 "},
        {"#macro M(P) #declare P = \"s\"; #end #declare A=1; M(A) #debug A", "s"},
        {"#macro M(P) #declare P = 7; #end M(5) #declare A=5; M(A+0) Show(A)", "5 "},
        {"#declare A=array[3]{1,2,5} #macro M(P) #declare P=77; #end M(A[1]) Show(A[1])", "77 "},
        {"#macro M(P) Show(P[1]) #declare P[1]=9; #end #declare A=array[3]{1,2,5} M(A) Show(A[1])", "2 9 "},
        {"#declare F=1; #macro M(P) Show(P) #declare F=2; Show(P) #end M(F) M(F+0)", "1 2 2 2 "},
        {"#declare K=1; #macro M(P) #undef P #ifdef(P) Show(9) #end #end M(K) Show(K)", "1 "},
        {"#macro M(P) #ifdef(P) Show(P) #end #end M(3)", "3 "},
    });
}

TEST(Macro, LocalNamesEndWithTheCallAndAreSeenByWhatItCalls) {
    expect_debug({
        {"#macro N() Show(L) #end #macro M() #local L=3; N() #end M() #ifdef(L) Show(0) #end", "3 "},
        {"#macro N() #declare L=9; #end #macro M() #local L=3; N() Show(L) #end M() #ifdef(L) Show(0) #end", "9 "},
        {"#macro N() #local L=9; #end #macro M() #local L=3; N() Show(L) #end M()", "3 "},
        {"#macro M() #declare Z=1; #local Z=2; Show(Z) #end M() Show(Z)", "2 1 "},
        {"#macro M() #local K=1; #declare K=2; #end M() #ifdef(K) Show(0) #end #debug \"-\"", "-"},
        {"#declare K=1; #macro M() #local K=2; #undef K Show(K) #end M() Show(K)", "1 1 "},
        {"#declare K=1; #macro M() #undef K #end M() #ifndef(K) #debug \"gone\" #end", "gone"},
        {"#macro M() #for(I,1,3) #end Show(I) #end #declare I=50; M() Show(I)", "4 50 "},
        {"#macro Outer() #macro Inner() #debug \"in\" #end #end Outer() Inner()", "in"},
        {"#macro M(A) #end #macro M(A) #debug \"second\" #end M(1)", "second"},
        {"#macro M() #undef M #debug \"once\" #end M() #ifndef(M) #debug \" gone\" #end", "once gone"},
        {"#macro M() #macro M() #debug \"new\" #end #debug \"old\" #end M() M()", "oldnew"},
    });
}

TEST(Macro, CallThemselves) {
    expect_debug({
        {"#macro F(n) #local r=1; #if(n>1) #local r=n*F(n-1); #end r #end #declare A=F(5); Show(A)", "120 "},
        {"#macro F(n) #if(n<=1) 1 #else (n*F(n-1)) #end #end #declare A=(F(5)); Show(A)", "120 "},
        {"#macro R(n) #if(n>0) R(n-1) #else #debug \"deep\" #end #end R(1000)", "deep"},
        {"#macro Fib(n) #if(n<2) n #else (Fib(n-1)+Fib(n-2)) #end #end Show(Fib(12))", "144 "},
        {"#macro A(n) #if(n>0) B(n-1) #end #end #macro B(n) Show(n) A(n) #end A(3)", "2 1 0 "},
    });
    const Outcome o = read_scene("#macro R(n) #if(n>0) sphere{n*x,1} R(n-1) #end #end R(300)");
    ASSERT_TRUE(o.scene) << o.error;
    EXPECT_EQ(o.scene->objects.size(), 300u);
}

TEST(Macro, MistakesAreNamedAsPovRayNamesThem) {
    const Cases mistakes{
        {"#macro M()", "End of file reached but #end expected."},
        {"#macro M() #if(1) #end", "End of file reached but #end expected."},
        {"#macro M() #else #end", "Mis-matched '#else'."},
        {"#macro M(1) #end", "Expected 'identifier or expression.', float function 'float constant' found instead"},
        {"#macro sphere() #end", "Expected 'undeclared identifier', sphere found instead"},
        {"#macro M() \"abc #end", "No end quote for string."},
        {"#declare M=5; #macro M() #end", "Expected 'undeclared identifier', float function 'float identifier' found instead"},
        {"#macro M() #end #declare M=5;", "Expected 'undeclared identifier', macro identifier found instead"},
        {"#macro M() #end M() #end", "Mis-matched '#end'."},
        {"#macro M() #if(1) #end #end M() #end", "Mis-matched '#end'."},
        {"#macro M(A,B) #end M(1)", "Expected 2 parameters but only 1 found."},
        {"#macro M(A,B) #end M(1,)", "Expected 2 parameters but only 1 found."},
        {"#macro M(A) #end M()", "Expected 1 parameters but only 0 found."},
        {"#macro M(A,B) #end M(1,2,3)", "Expected ')', float function 'float constant' found instead"},
        {"#macro M(A) #end M((1,2))", "Expected ')', , found instead"},
        {"#macro M(A) #end M(1<2)", "Expected ')', < found instead"},
        {"#macro M(A) #end M", "Expected '(', End of File found instead"},
        {"#macro M(A) #end M(Nope)", "Cannot pass uninitialized identifier as macro parameter. Initialize identifier first."},
        {"#macro M() #end #undef M M()", "Expected 'object or directive', undeclared identifier 'M' found instead"},
        {"#macro M() 1) #end #if(M() #end", "What stands in parentheses must end in the text it begins in."},
        {"#macro C() 1) #end #while(C() #end", "What stands in parentheses must end in the text it begins in."},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
    EXPECT_NE(error_text("#macro M #end"), "");
}

TEST(Macro, ANameThatAMacroEndsWithIsPassedItself) {
    const std::string set = "#declare N=1; #macro Set(X) #declare X=5; #end #macro Name() N #end #macro More() Name() #end ";
    EXPECT_EQ(debug_text(set + "Set(Name()) #debug str(N,0,0)"), "5");
    EXPECT_EQ(debug_text(set + "Set(More()) #debug str(N,0,0)"), "5");
    EXPECT_EQ(debug_text(set + "Set(Name() + 0) #debug str(N,0,0)"), "1");
}

TEST(Macro, MistakesInsideArePointedAtInTheBody) {
    EXPECT_EQ(read_scene("#macro M(A)\n  sphere { 0, A B }\n#end\nM(1)").error,
              "File 't.pov' line 2: Parse Error: No matching } in 'sphere', undeclared identifier 'B' found instead\n"
              "   2 |   sphere { 0, A B }\n"
              "     |                 ^");
}

}  // namespace
}  // namespace rt::macro_test
