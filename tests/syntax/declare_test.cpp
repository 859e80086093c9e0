// #declare, #local, #undef, #macro, #version and the directives that write text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/read_scene.h"

namespace rt::declare_test {
namespace {

constexpr const char* semicolon =
    "All #declares of float, vector, and color require semi-colon ';' at end if the language version is set to 3.5 or higher. Either add "
    "the "
    "semi-colon or set the language version to 3.1 or lower.";

TEST(Declare, NamesStandForTheirValues) {
    const std::vector<std::pair<const char*, const char*>> cases{
        {"#declare A = 3; #declare A = A+1; #debug str(A,0,0)", "4"},
        {"#declare A = 3; #declare A = \"text\" #debug A", "text"},
        {"#declare A = pigment { rgb 1 } #declare A = 3; #debug str(A,0,0)", "3"},
        {"#declare a = 1; #declare A = 2; #debug str(a,0,0)", "1"},
        {"#declare _a1 = 1; #debug str(_a1,0,0)", "1"},
        {"# declare A = 1; #debug str(A,0,0)", "1"},
        {"#declare image_width = 3; #debug str(image_width,0,0)", "3"},
        {"#debug str(image_width,0,0) #debug str(image_height,0,0)", "800600"},
        {"#declare A = red 1; #debug vstr(5,A,\",\",0,0)", "1,0,0,0,0"},
        {"#declare A = color rgbt <1,2,3,4>; #debug vstr(5,A,\",\",0,0)", "1,2,3,0,4"},
        {"sphere { #declare A = 1; 0, A } #debug str(A,0,0)", "1"},
        {"#local A = 1; #debug str(A,0,0) #undef A #ifdef(A) #debug \"still\" #end", "1"},
        {"#declare A = 1; #local A = 2; #undef A #ifdef(A) #debug \"still\" #end", ""},
        {"#macro M() anything #end #ifdef(M) #debug \"macro\" #end #undef M #ifdef(M) #debug \"still\" #end", "macro"},
    };
    for (const auto& [scene, text] : cases) EXPECT_EQ(debug_text(scene), text) << scene;
}

TEST(Declare, EveryKindOfValue) {
    const Outcome o = read_scene(
        "#declare F = 1; #declare V = <1,2,3>; #declare C = rgb V; #declare S = \"s\";\n"
        "#declare P = pigment { color C } #declare N = finish { phong F }; #declare T = texture { pigment { P } finish { N } }\n"
        "#declare I = interior { ior 1.5 } #declare M = material { texture { T } interior { I } }\n"
        "#declare X = transform { scale 2 } #declare O = sphere { V, F material { M } transform { X } }\n"
        "#declare L = light_source { V, C } #declare K = camera { location V }\n"
        "O object { O } light_source { L } camera { K }\n");
    ASSERT_TRUE(o.scene) << o.error;
    EXPECT_EQ(o.scene->objects.size(), 2u);
    EXPECT_EQ(o.scene->lights.size(), 1u);
    EXPECT_EQ(o.scene->camera.location, Vec3(1, 2, 3));
}

TEST(Declare, MistakesAreNamedAsPovRayNamesThem) {
    const std::vector<std::pair<const char*, const char*>> mistakes{
        {"#declare A=1<2;", semicolon},
        {"#declare A=1=1;", semicolon},
        {"#declare A=1^2;", semicolon},
        {"#declare A=5%2;", semicolon},
        {"#declare A=0x10;", semicolon},
        {"#declare A=1\n#declare B=2;", semicolon},
        {"#declare A=1", semicolon},
        {"#declare A=<1,2,3>(1);", semicolon},
        {"#declare A=rgb 1 sphere { 0, 1 }", semicolon},
        {"#declare A=1; #declare B=A A;", semicolon},
        {"#declare C=rgb 1; #declare B=C transmit .3;", semicolon},
        {"#version 3.6; #declare A=1 #debug \"\"", semicolon},
        {"#declare A=<1,2,3\nsphere { 0, 1 }", "Expected '>', sphere found instead"},
        {"#declare", "Expected 'undeclared identifier', End of File found instead"},
        {"#local x=1;", "Expected 'undeclared identifier', vector function 'x' found instead"},
        {"#declare 1=1;", "Expected 'undeclared identifier', float function 'float constant' found instead"},
        {"#declare sphere=1;", "Expected 'undeclared identifier', sphere found instead"},
        {"#declare clock=2;", "Expected 'undeclared identifier', float function 'clock' found instead"},
        {"#declare colour=2;", "Expected 'undeclared identifier', color found instead"},
        {"#declare rgb=2;", "Expected 'undeclared identifier', color keyword 'rgb' found instead"},
        {"#declare A 1;", "Expected '=', float function 'float constant' found instead"},
        {"#declare A[1]=2;", "Expected '=', [ found instead"},
        {"#declare A.red=2;", "Expected '=', . (period) found instead"},
        {"#declare A=;", "Expected 'RValue to declare', ; found instead"},
        {"#declare A=", "Expected 'RValue to declare', End of File found instead"},
        {"#declare A={1};", "Expected 'RValue to declare', { found instead"},
        {"#declare A=sqr(3);", "Expected 'RValue to declare', sqr found instead"},
        {"#declare A=B;", "Cannot assign uninitialized identifier."},
        {"#declare A=B+1;", "Cannot assign uninitialized identifier."},
        {"#declare A=1;;", "Expected 'object or directive', ; found instead"},
        {"#declare A=1; #undef A #declare B=A;", "Cannot assign uninitialized identifier."},
        {"#declare A=sphere;", "Missing { after 'sphere', ; found instead"},
        {"#declare A=\"a\" \"b\";", "Expected 'object or directive', string literal found instead"},
        {"#declare A=\"a\" #declare B=A+1;", "Expected 'object or directive', + found instead"},
        {"#declare A=1; A", "Expected 'object or directive', float function 'float identifier' found instead"},
        {"#declare A=pigment { rgb 1 } A", "Expected 'object or directive', pigment identifier found instead"},
        {"#undef sphere", "Expected 'undeclared identifier', sphere found instead"},
        {"#undef", "Expected 'undeclared identifier', End of File found instead"},
    };
    for (const auto& [scene, text] : mistakes) EXPECT_EQ(error_text(scene), text) << scene;
}

TEST(Declare, OlderVersionsDoWithoutTheSemicolon) {
    EXPECT_EQ(read_scene("#version 3.0; #declare A=1 sphere { 0, A }").messages.size(), 0u);
    const Outcome o = read_scene("#version 3.1; #declare A=1 sphere { 0, A }");
    ASSERT_EQ(o.messages.size(), 1u);
    EXPECT_EQ(
        o.messages[0],
        "File 't.pov' line 1: Possible Parse Error: All #version and #declares of float, vector, and color require semi-colon ';' at end.\n"
        "   1 | #version 3.1; #declare A=1 sphere { 0, A }\n"
        "     |                            ^^^^^^");
}

TEST(Declare, UnknownNamesToUndefineAreAWarning) {
    EXPECT_EQ(read_scene("#undef A").log(),
              "File 't.pov' line 1: Parse Warning: Attempt to undef unknown identifier\n"
              "   1 | #undef A\n"
              "     | ^^^^^^\n");
}

TEST(Declare, DeprecatedNamesWarnWhereTheyAreUsed) {
    const std::string use = " A=1;\n#declare B=A;\n#declare B=A;\n";
    EXPECT_EQ(read_scene("#declare deprecated \"old\"" + use).log(),
              "File 't.pov' line 2: Parse Warning: old\n   2 | #declare B=A;\n     |            ^\n"
              "File 't.pov' line 3: Parse Warning: old\n   3 | #declare B=A;\n     |            ^\n");
    EXPECT_EQ(read_scene("#declare deprecated once \"old\"" + use).messages.size(), 1u);
    EXPECT_THAT(read_scene("#declare deprecated" + use).messages[0],
                testing::HasSubstr("Parse Warning: Identifier 'A' was declared deprecated."));
}

TEST(Declare, DescriptionsOfDeclaredNames) {
    const std::vector<std::pair<const char*, const char*>> kinds{
        {"1;", "float function 'float identifier'"},
        {"<1,2>;", "uv vector identifier"},
        {"<1,2,3>;", "vector function 'vector identifier'"},
        {"<1,2,3,4>;", "4d-vector identifier"},
        {"\"s\"", "string identifier"},
        {"pigment { rgb 1 }", "pigment identifier"},
        {"finish { phong 1 }", "finish identifier"},
        {"texture { pigment { rgb 1 } }", "texture identifier"},
        {"interior { ior 1 }", "interior identifier"},
        {"material { interior { ior 1 } }", "material identifier"},
        {"camera { }", "camera identifier"},
        {"light_source { 0, rgb 1 }", "object identifier"},
        {"sphere { 0, 1 }", "object identifier"},
        {"transform { scale 2 }", "transform identifier"},
    };
    for (const auto& [value, name] : kinds)
        EXPECT_EQ(error_text("#declare A = " + std::string(value) + " sphere { 0, 1 A }"),
                  "No matching } in 'sphere', " + std::string(name) + " found instead");
}

TEST(Declare, WithoutSemicolonsOldScenesAreReadAsTheyWereMeant) {
    const std::string old = "#version 3.1; ";
    EXPECT_EQ(read_scene(old + "#declare A = 1 #declare B = A + 1 #declare C = B sphere { 0, C }").error, "");
    EXPECT_THAT(debug_text(old + "#declare A = 1 #declare B = A + 1 #declare C = B; #debug str(C,0,0)"), testing::EndsWith("2"));
    EXPECT_THAT(debug_text(old + "#declare I = 0; #while(I < 3) #declare I = I + 1 #end #debug str(I,0,0)"), testing::EndsWith("3"));
    EXPECT_THAT(debug_text(old + "#if(1) #declare I = 5 #else #declare I = 6 #end #debug str(I,0,0)"), testing::EndsWith("5"));
    EXPECT_THAT(error_text("#declare I = 0; #while(I < 3) #declare I = I + 1 #end"), testing::StartsWith("All #declares of float"));
}

/// A directive behind a whole value is carried out with the name in force.
TEST(Declare, ADirectiveEndsAValueWithoutASemicolon) {
    const std::string old = "#version 3.1; #declare A = 0; ";
    const std::vector<std::pair<const char*, const char*>> cases{
        {"#declare A = 3 #if(A=3) #debug \"yes\" #end", "yes"},
        {"#declare A = 3 #debug str(A,0,0)", "3"},
        {"#declare A = -3 #debug str(A,0,0)", "-3"},
        {"#declare A = 3 #while(A<5) #debug str(A,0,0) #declare A=A+1; #end", "34"},
        {"#declare A = 3 #switch(A) #case(3) #debug \"three\" #end", "three"},
        {"#declare A = 3 #for(I,1,A) #debug \"i\" #end", "iii"},
        {"#declare A = 3 #undef A #ifdef(A) #debug \"still\" #end", ""},
        {"#declare A = 3 #default { finish { phong A } } #debug str(A,0,0)", "3"},
        {"#declare A = 3 #macro M() #debug str(A,0,0) #end M()", "3"},
        {"#declare A = 3 #version 3.1; #debug str(A,0,0)", "3"},
        {"#declare V = <1,2,3> #if(V.x=1) #debug \"yes\" #end", "yes"},
        {"#declare V = <1,2,3> #declare A = V.z #debug str(A,0,0)", "3"},
        {"#declare C = color rgb 1 #if(C.red=1) #debug \"yes\" #end", "yes"},
        {"#declare A = pi #if(A>3) #debug \"yes\" #end", "yes"},
        {"#macro M() 3 #end #declare A = M() #if(A=3) #debug \"yes\" #end", "yes"},
        {"#declare A = (3 #if(1) +2 #end); #debug str(A,0,0)", "5"},
        {"#macro M(a) #local b = a; #while (b < 3) #local b = b + 1; #end #if (b) b; #else 0; #end #end #declare A = M(1) #debug "
         "str(A,0,0)",
         "3"},
        {"#declare A = #while (0) #end 3 #if (1) #debug str(A,0,0) #end", "3"},
        {"#declare A = max(1, 2 #if(1) +2 #end); #debug str(A,0,0)", "4"},
        {"#declare A = #if(1) 1 #else 2 #end; #debug str(A,0,0)", "1"},
    };
    for (const auto& [scene, text] : cases) EXPECT_THAT(debug_text(old + scene), testing::EndsWith(text)) << scene;
    EXPECT_EQ(error_text("#declare A = 3 #if(1) +2 #end;"), semicolon);
    EXPECT_EQ(error_text("#declare A = 0; #declare A = 3\n#debug str(A,0,0)"), semicolon);
    EXPECT_THAT(debug_text("#version 3.6 #debug str(version,0,1)"), testing::EndsWith("3.6"));
    EXPECT_THAT(debug_text("#version 3.6 #version 3.5; #debug str(version,0,1)"), testing::EndsWith("3.5"));
}

TEST(Declare, WhatIsNotModelledIsReportedWhereItIsUsed) {
    const std::string unused = "#declare F = function { pattern { agate } } #declare T = density { planar } ";
    EXPECT_EQ(read_scene(unused + "sphere { 0, 1 }").error, "");
    EXPECT_EQ(error_text(unused + "sphere { 0, F(1,2,3) }"), "'a pattern's value while reading' is not modelled.");
    EXPECT_EQ(read_scene("#declare B = julia_fractal { }\n#declare C = B\nobject { C }").error,
              "File 't.pov' line 1: Parse Error: 'julia_fractal' is not modelled.\n"
              "   1 | #declare B = julia_fractal { }\n"
              "     |              ^^^^^^^^^^^^^");
    ParseOptions lenient;
    lenient.lenient = true;
    const Outcome o = read_scene("#declare B = julia_fractal { } #for(I,1,3) object { B } #end", lenient);
    EXPECT_EQ(o.messages.size(), 1u) << o.log();
}

TEST(Version, IsKeptAndRestored) {
    EXPECT_EQ(debug_text("#version 3.5; #debug str(version,0,2)"), "3.50");
    EXPECT_EQ(debug_text("#version 3.5+.1; #debug str(version,0,2)"), "3.60");
    EXPECT_EQ(debug_text("#declare unofficial=3; #version unofficial 3.6; #debug str(version,0,2)"), "3.60");
    EXPECT_EQ(debug_text("#version 3.5; #version 3.7; #debug str(version,0,2)"), "3.70");
    EXPECT_EQ(read_scene("sphere { 0, 1 }").scene->language_version, 0.0);
    EXPECT_EQ(read_scene("#version 3.6; sphere { 0, 1 }").scene->language_version, 3.6);
    EXPECT_EQ(read_scene("#declare V = version; #version 3.5; #version V;").scene->language_version, 3.7);
    ParseOptions options;
    options.version = 3.6;
    EXPECT_EQ(read_scene("sphere { 0, 1 }", options).scene->language_version, 3.6);
    EXPECT_EQ(debug_text("#debug str(version,0,1)", options), "3.6");
}

TEST(Version, DecidesTheGamma) {
    const auto gamma = [](const char* scene) { return read_scene(scene).scene->settings.gamma; };
    EXPECT_EQ(gamma("sphere { 0, 1 }").kind, Gamma::Kind::legacy);
    EXPECT_EQ(gamma("#version 3.6; sphere { 0, 1 }").kind, Gamma::Kind::legacy);
    EXPECT_EQ(gamma("#version 3.7; #version 3.6;").kind, Gamma::Kind::legacy);
    EXPECT_EQ(gamma("#version 3.7; sphere { 0, 1 }"), (Gamma{Gamma::Kind::power, 1.0}));
    EXPECT_EQ(gamma("#declare V = version; #version 3.5; #version V;"), (Gamma{Gamma::Kind::power, 1.0}));
}

TEST(Version, MistakesAreNamedAsPovRayNamesThem) {
    EXPECT_EQ(error_text("#version 3.8;"), "Your scene file requires POV-Ray version 3.8 or later!");
    EXPECT_EQ(error_text("#version 3.71;"), "Your scene file requires POV-Ray version 3.71 or later!");
    EXPECT_EQ(error_text("#version foo;"), "Expected 'numeric expression', undeclared identifier 'foo' found instead");
    EXPECT_EQ(error_text("#version;"), "Expected 'numeric expression', ; found instead");
    EXPECT_THAT(
        read_scene("#version 3.7 sphere { 0, 1 }").log(),
        testing::HasSubstr("Possible Parse Error: All #version and #declares of float, vector, and color require semi-colon ';' at end."));
}

TEST(Message, DirectivesSpeak) {
    EXPECT_EQ(debug_text("#debug \"a\\n\" #debug concat(\"b\",str(1,0,0))"), "a\nb1");
    EXPECT_EQ(read_scene("#warning \"hm\"").log(), "File 't.pov' line 1: Parse Warning: hm\n   1 | #warning \"hm\"\n     | ^^^^^^^^\n");
    EXPECT_EQ(read_scene("\n#error \"boom\"").error,
              "File 't.pov' line 2: Parse Error: Parse halted by #error directive: boom\n   2 | #error \"boom\"\n     | ^^^^^^");
    EXPECT_EQ(error_text("#error boom"), "Expected 'string expression', undeclared identifier 'boom' found instead");
    const Outcome o = read_scene("#render \"r\" #statistics \"s\"");
    ASSERT_EQ(o.messages.size(), 4u);
    EXPECT_EQ(o.messages[1], "r");
    EXPECT_THAT(o.messages[2], testing::HasSubstr("#render and #statistics streams are no longer available."));
}

TEST(Default, IsReadWhereItStands) {
    EXPECT_EQ(read_scene("#default { pigment { rgb 1 } finish { ambient 1 } }").error, "");
    EXPECT_EQ(error_text("#default 1"), "Missing { after 'default', float function 'float constant' found instead");
    EXPECT_EQ(error_text("#default { sphere }"), "No matching } in 'default', sphere found instead");
    EXPECT_EQ(error_text("#default {"), "No matching } in 'default', End of File found instead");
}

TEST(Option, AFramesValues) {
    ParseOptions options;
    options.frame = {true, 3, 2, 5, 0.25, 0.75, 0.125};
    EXPECT_EQ(debug_text("#debug vstr(5, <clock_on,frame_number,initial_frame,final_frame,initial_clock>, \" \", 0, 2)", options),
              "1.00 3.00 2.00 5.00 0.25");
    EXPECT_EQ(debug_text("#debug vstr(2, <final_clock,clock_delta>, \" \", 0, 3)", options), "0.750 0.125");
}

TEST(Option, DeclaresAndClock) {
    ParseOptions options;
    options.declares = {{"Radius", "2.5"}, {"Name", "2.5m"}, {"Empty", ""}};
    options.clock = .25;
    options.image_width = 96;
    EXPECT_EQ(debug_text("#debug concat(str(Radius,0,2),Name,Empty,str(clock,0,2),str(image_width,0,0))", options), "2.502.5m0.2596");
}

}  // namespace
}  // namespace rt::declare_test
