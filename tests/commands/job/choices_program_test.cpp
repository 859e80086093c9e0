// Choices in `//! raytrace:` comments as every command meets them: the same message, the same exit status.
#include <gtest/gtest.h>

#include "tests/commands/support.h"

namespace rt::choices_program_test {
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

/// The notes on a 8 x 6 picture of a sphere with that finish.
class ChoicesWithoutEffect : public testing::Test {
protected:
    test::Workplace here;

    void state(const std::string& comment, const std::string& finish, const std::string& lamp = "light_source { <2, 3, -4> rgb 1 }") {
        here.write("c.pov", "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z }\n" + lamp + "\n" +
                                (comment.empty() ? "" : "//! raytrace: " + comment + "\n") + "sphere { 0, 1 pigment { rgb 1 } finish { " +
                                finish + "\n} }\n");
    }
    std::string notes(std::vector<std::string> options) {
        options.insert(options.begin(), {"c.pov", "--size=8x6"});
        const Outcome outcome = run(options);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return outcome.err;
    }
    static std::string idle(const std::string& named) {
        const char* const what = named.find(',') == std::string::npos ? "it" : "them";
        return "raytrace: note: no effect here: " + named + " (nothing in the picture depends on " + what + ")\n";
    }
};

const char* const shiny_finish = "specular 0.5 roughness 0.5";

TEST_F(ChoicesWithoutEffect, OfTheCommandLineAreNamedInOneNote) {
    state("", shiny_finish);
    EXPECT_EQ(notes({"--sigma=0.3", "--exponent=40"}),
              "raytrace: note: no effect here: --exponent, --sigma (nothing in the picture depends on them)\n");
    EXPECT_EQ(notes({"--sigma=0.3", "--exponent=40", "-q"}), "");
}

TEST_F(ChoicesWithoutEffect, AreThoseThatTheModelDoesNotRead) {
    state("", shiny_finish);
    const std::pair<std::vector<std::string>, std::string> rows[] = {
        {{"--edge-width=2"}, "--edge-width"},
        {{"--edges=silhouette", "--edge-angle=20"}, "--edge-angle"},
        {{"--D=ggx", "--shading=phong"}, "--D"},
        {{"--attenuate-ambient=on"}, "--attenuate-ambient"},
        {{"--phong-gate=off", "--shading=blinn-phong"}, "--phong-gate"},
        {{"--gooch=as-printed"}, "--gooch"},
        {{"--alpha-floor=0.1", "--shading=phong"}, "--alpha-floor"},
        {{"--clamp=after"}, "--clamp"},
        {{"--env-clamp=1"}, "--env-clamp"},
        {{"--eta=2", "--F=one"}, "--eta"},
        {{"--blinn-power=inverse-roughness"}, "--blinn-power"},
        {{"--spot=exponent"}, "--spot"},
        {{"--material=silver", "--shading=none", "--env=finish"}, "--material"},
        {{"--D=beckmann", "--s=0"}, "--D"},
    };
    for (const auto& [options, named] : rows) EXPECT_EQ(notes(options), idle(named)) << named;
}

TEST_F(ChoicesWithoutEffect, AreNotThoseThatSomeSurfaceOrLampReads) {
    state("", shiny_finish);
    const std::vector<std::string> rows[] = {
        {"--edges=all", "--edge-width=2", "--edge-color=1", "--edge-angle=20"},
        {"--edge-width=2", "--edges=silhouette"},
        {"--D=ggx", "--G=ggx", "--F=conductor", "--eta=0.2", "--k=3", "--alpha=0.3", "--alpha-floor=0.1", "--s=0.4"},
        {"--fresnel-arg=nv", "--half=nv", "--norm=ct1982", "--units=physical", "--dw=2", "--denominator=clamped", "--raw=on"},
        {"--attenuate-ambient=on", "--ambient=per-light"},
        {"--shading=phong", "--phong-gate=off", "--exponent=9", "--clamp=after"},
        {"--shading=blinn-phong", "--exponent=9"},
        {"--shading=blinn-phong", "--alpha=0.2"},
        {"--diffuse=gooch", "--gooch=as-printed"},
        {"--diffuse=oren-nayar", "--sigma=0.4"},
        {"--env=mirror", "--env-clamp=1"},
        {"--D=blinn", "--blinn-power=inverse-roughness"},
        {"--att=inverse-square", "--range=9"},
        {"--att-coefficients=1,0,1"},
        {"--s=0"},
        {"--preset=effects"},
        {"--preset=phong-lights", "--material=shiny-gold"},
        {"--shading=none", "--env=albedo", "--D=beckmann"},
        {"--shading=none", "--env=fresnel", "--f0=0.5"},
        {"--distances=povray", "--precision=fast"},
    };
    for (const std::vector<std::string>& options : rows) EXPECT_EQ(notes(options), "") << options[0];
    state("", shiny_finish, "light_source { <2, 3, -4> rgb 1 spotlight point_at 0 }");
    EXPECT_EQ(notes({"--spot=exponent", "--clamp=after"}), "");
    EXPECT_EQ(notes({"--clamp=after"}), idle("--clamp")) << "the cone of POV-Ray has no such power";
    state("", shiny_finish, "light_source { <2, 3, -4> rgb 1 parallel point_at 0 }");
    EXPECT_EQ(notes({"--att=inverse-square", "--range=9"}), idle("--att, --range")) << "a parallel lamp has no distance";
}

TEST_F(ChoicesWithoutEffect, OfTheFileAreNamedAsTheyStand) {
    state("exponent=40 D=beckmann sigma=0.2 sigma=0.3", shiny_finish);
    EXPECT_EQ(notes({}), idle("exponent=40, sigma=0.3"));
    EXPECT_EQ(notes({"--gooch=warm"}), idle("--gooch, exponent=40, sigma=0.3"));
    EXPECT_EQ(notes({"-q"}), "");
}

TEST_F(ChoicesWithoutEffect, LinesThatTheCommandLineTurnsOffAreNoNews) {
    state("edges=all edge-width=2", shiny_finish);
    EXPECT_EQ(notes({"--edges=off"}), "");
    EXPECT_EQ(notes({"--edges=off", "--edge-color=1"}), idle("--edge-color"));
    state("edges=silhouette edge-angle=20", shiny_finish);
    EXPECT_EQ(notes({}), idle("edge-angle=20"));
}

TEST_F(ChoicesWithoutEffect, AFinishMayGiveThemOne) {
    state("sigma=0.3", std::string(shiny_finish) + "\n//! raytrace: diffuse=oren-nayar exponent=40");
    EXPECT_EQ(notes({}), "") << "what a finish states is not named";
    state("", "specular 0");
    EXPECT_EQ(notes({"--D=beckmann"}), idle("--D")) << "no finish has a highlight";
}

TEST_F(ChoicesWithoutEffect, AreAllUnderPovRaysShading) {
    state("exponent=40 distances=scaled", shiny_finish);
    EXPECT_EQ(notes({"--shading=povray", "--D=beckmann", "--preset=classic"}), idle("--preset, --D, exponent=40"));
}

}  // namespace
}  // namespace rt::choices_program_test
