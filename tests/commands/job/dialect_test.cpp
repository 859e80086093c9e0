// Options where two dialects meet: our commands with POV-Ray's switches, the course's words with our options.
#include <gtest/gtest.h>

#include <filesystem>

#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::dialect_test {
namespace {

using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

class Dialects : public testing::Test {
protected:
    Dialects() {
        here.write("a.pov", test::small_scene);
        std::filesystem::create_directory("lib");
        here.write("lib/part.inc", "sphere { 0, n }\n");
        here.write("s.pov",
                   "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#include \"part.inc\"\n#debug concat(text_value, \"\\n\")\n");
    }
    test::Workplace here;
};

TEST_F(Dialects, RequiresUnderstandsPovraysSwitches) {
    const Outcome ours = run({"requires", "s.pov", "-L", "lib", "--define", "n=1", "--define", "text_value=\"x y\""});
    EXPECT_EQ(ours.status, 0) << ours.err;
    EXPECT_NE(ours.out.find("objects:   1 (1 sphere)"), std::string::npos) << ours.out;
    here.write("s.ini", "Library_Path=lib\nDeclare=n=1\nDeclare=text_value=\"x y\"\n");
    for (const Words& words : std::vector<Words>{
             {"requires", "+Is.pov", "+Llib", "Declare=n=1", "Declare=text_value=\"x y\""},
             {"requires", "+Is", "-Llib", "Declare=n=1", "Declare=text_value='x y'", "+W64", "+A0.3", "-D", "--stats", "+FN"},
             {"requires", "s", "s.ini"},
         }) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.out, ours.out) << words[1];
        EXPECT_EQ(outcome.err, "");
    }
    EXPECT_EQ(run({"requires", "+Ia.pov", "a.pov", "+Ia.pov"}).out, run({"requires", "a", "a", "a"}).out);
    EXPECT_EQ(run({"requires", "+Y7", "a.pov"}).err, "raytrace: unknown switch '+Y7'; see raytrace help povray\n");
    EXPECT_EQ(run({"requires", "-D"}).err, "raytrace: requires: no scene given; see raytrace requires --help\n");
}

TEST_F(Dialects, RequiresKnowsThePicturesSize) {
    here.write("w.pov",
               "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#if (image_width = 64) sphere { 0, 1 } #else plane { y, 0 } #end\n");
    EXPECT_NE(run({"requires", "w.pov", "+W64"}).out.find("1 sphere"), std::string::npos);
    EXPECT_NE(run({"requires", "w.pov"}).out.find("1 plane"), std::string::npos);
}

TEST_F(Dialects, TheCoursesPositionsAreCountedWithoutOptionsValues) {
    ASSERT_EQ(run({"render", "a.pov", "12", "9", "--shading=general", "-ss=2"}).status, 0);
    const std::string picture = here.read("output.png");
    for (const Words& words : std::vector<Words>{{"render", "--shading", "general", "a.pov", "12", "9", "-ss", "2"},
                                                 {"render", "a.pov", "--shading", "general", "12", "-ss", "2", "9"},
                                                 {"render", "-ss", "2", "a.pov", "--shading", "general", "12", "9"},
                                                 {"render", "-ss=2", "--shading=general", "--", "a.pov", "12", "9"}}) {
        std::filesystem::remove("output.png");
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(here.read("output.png"), picture) << words[1];
    }
    EXPECT_EQ(run({"render", "a.pov", "12", "9", "9"}).err, "raytrace: expected: raytrace render SCENE WIDTH HEIGHT [options]\n");
    EXPECT_EQ(run({"render", "a.pov", "12", "9", "--shading"}).err, "raytrace: option '--shading' needs a value\n");
}

}  // namespace
}  // namespace rt::dialect_test
