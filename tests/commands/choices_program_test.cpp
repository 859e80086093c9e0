// Choices in `//! raytrace:` comments as every command meets them: the same message, the same exit status.
#include <gtest/gtest.h>

#include "tests/commands/support.h"

namespace rt {
namespace {

using test::Outcome;
using test::run;
using test::small_scene;

class ChoicesInScenes : public testing::Test {
protected:
    test::Workplace here;

    void state(const std::string& comment) { here.write("c.pov", small_scene + comment + "\n"); }
    Outcome render() { return run({"c.pov", "--size=8x6"}); }
};

TEST_F(ChoicesInScenes, BadOnesAreTheSameErrorForEveryCommand) {
    for (const char* comment : {"//! raytrace: shading=phongg", "//! raytrace: shadng=povray", "//! raytrace: precision",
                                "//! raytrace: alpha=direct distances=far"}) {
        state(comment);
        const Outcome rendered = render();
        EXPECT_EQ(rendered.status, 1) << comment;
        EXPECT_EQ(rendered.err.find("File 'c.pov' line 6: Parse Error: "), 0u) << rendered.err;
        for (const char* command : {"requires", "sceneinfo"}) {
            const Outcome other = run({command, "c.pov"});
            EXPECT_EQ(other.status, 1) << command << " " << comment;
            EXPECT_EQ(other.err, rendered.err) << command;
            EXPECT_EQ(other.out, "") << command;
        }
    }
}

TEST_F(ChoicesInScenes, IncludedFilesAreCheckedToo) {
    here.write("c.inc", "\n//! raytrace: precision=perfect\n");
    state("#include \"c.inc\"");
    const Outcome rendered = render();
    EXPECT_EQ(rendered.status, 1);
    EXPECT_EQ(rendered.err.find("File 'c.inc' line 2: Parse Error: precision: 'perfect' is no precision; expected one of "), 0u)
        << rendered.err;
    const Outcome needs = run({"requires", "c.pov"});
    EXPECT_EQ(needs.status, 1);
    EXPECT_EQ(needs.err, rendered.err);
}

TEST_F(ChoicesInScenes, OfAFileAFinishAndTheCommandLineReplaceEachOther) {
    const std::string shiny = "sphere { 0, 1 pigment { rgb 1 } finish { specular 1 roughness 0.5 ";
    const auto picture = [&](const std::string& file_choice, const std::string& finish_choice, std::vector<std::string> options) {
        here.write("c.pov",
                   "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z } light_source { <2, 3, -4> rgb 1 }\n" +
                       file_choice + "\n" + shiny + finish_choice + "\n} }\n");
        options.insert(options.begin(), {"c.pov", "--size=24x18", "-q", "-o", "c.ppm"});
        EXPECT_EQ(run(options).status, 0);
        return here.read("c.ppm");  // a format without texts
    };
    const auto same = [&](const std::string& a, const std::string& b) { return a == b; };
    const std::string plain = picture("", "", {}), beckmann = picture("", "", {"--D", "beckmann"});
    EXPECT_FALSE(same(plain, beckmann));
    EXPECT_TRUE(same(picture("//! raytrace: D=beckmann", "", {}), beckmann));
    EXPECT_TRUE(same(picture("", "//! raytrace: D=beckmann", {}), beckmann));
    EXPECT_TRUE(same(picture("//! raytrace: D=blinn", "//! raytrace: D=beckmann", {}), beckmann)) << "the finish over the file";
    EXPECT_TRUE(same(picture("", "//! raytrace: D=blinn", {"--D", "beckmann"}), beckmann)) << "the command line over all";
    EXPECT_TRUE(same(picture("", "", {"--D", "beckmann", "--preset", "modern"}), beckmann)) << "presets first, whatever the order";
}

TEST_F(ChoicesInScenes, LinesOverThePictureWithEveryShading) {
    const auto picture = [&](const std::string& comment, std::vector<std::string> options) {
        state(comment);
        options.insert(options.begin(), {"c.pov", "--size=24x18", "-q", "-o", "c.ppm"});
        EXPECT_EQ(run(options).status, 0);
        return here.read("c.ppm");
    };
    const std::string plain = picture("", {}), drawn = picture("", {"--edges", "all", "--edge-color", "0,1,0"});
    EXPECT_FALSE(plain == drawn);
    EXPECT_TRUE(picture("//! raytrace: edges=all edge-color=0,1,0", {}) == drawn);
    EXPECT_TRUE(picture("//! raytrace: edges=all edge-color=0,1,0", {"--edges=off"}) == plain) << "the command line wins";
    EXPECT_FALSE(picture("", {"--edges", "all", "--edge-color", "0,1,0", "--edge-width=3"}) == drawn);
    const std::string povray = picture("", {"--shading", "povray", "--edges", "all", "--edge-color", "0,1,0"});
    EXPECT_NE(povray.find(std::string("\0\377\0", 3)), std::string::npos);
}

TEST_F(ChoicesInScenes, StatsTellOfLobesNarrowerThanASample) {
    const std::string shiny = "sphere { 3, 1 pigment { rgb 1 } finish { specular 1 roughness 0.05 } }";  // alpha 0.0025
    state(shiny);
    // A pixel of 8 columns spans atan(4 / 3 / 8) = 0.1652.
    const std::string told = "lobes narrower than a sample: 1 materials, alpha 0.0025 and more, below 0.0826; highlights may be lost\n";
    EXPECT_NE(run({"c.pov", "--size=8x6", "--stats"}).err.find(told), std::string::npos) << run({"c.pov", "--size=8x6", "--stats"}).err;
    for (const char* option : {"--shading=povray", "--alpha=0.1", "--alpha=0", "--ss=40"})
        EXPECT_EQ(run({"c.pov", "--size=8x6", "--stats", option}).err.find("lobes narrower"), std::string::npos) << option;
}

TEST_F(ChoicesInScenes, UnderPovRaysShadingTheCatalogueIsSaidToHaveNoEffect) {
    state("");
    EXPECT_EQ(run({"c.pov", "--size=8x6", "--shading", "povray", "--D", "beckmann"}).err,
              "raytrace: note: --D has no effect: the shading is POV-Ray's\n");
}

}  // namespace
}  // namespace rt
