// `pixeltrace --html`: what is in the page's data, which pixels, how much of them, and what stays behind when it cannot be made.
#include "commands/pixel/pixel_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/commands/support.h"

namespace rt::pixel_page_test {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using testing::HasSubstr;
using Words = std::vector<std::string>;

const char* const glass_scene =
    "#version 3.7;\n"
    "global_settings { assumed_gamma 1 max_trace_level 9 }\n"
    "camera { location <0, 0.5, 6> up <0, 1, 0> right <1.25, 0, 0> look_at <0, 0, 0> }\n"
    "light_source { <-4, 9, 7> color rgb <0.9, 0.8, 0.7> area_light x, y, 3, 3 }\n"
    "sphere { <0, 0, 0>, 1 pigment { color rgbf <1, 0.5, 0.25, 0.75> }\n"
    "  finish { ambient 0.2 diffuse 0.4 specular 0.3 roughness 0.1 reflection 0.25 ior 1.5 } scale <1, 1.5, 1> }\n"
    "plane { <0, 1, 0>, -2 pigment { color rgb <0.2, 0.7, 0.8> } finish { ambient 0.4 diffuse 0.6 } }\n";

class PixelPageProgram : public testing::Test {
protected:
    PixelPageProgram() { here.write("a.pov", glass_scene); }

    Outcome page(const Words& options) {
        Words words{"pixeltrace", "a.pov", "40", "32", "17", "20", "--profile=povray", "--html", "p.html"};
        words.insert(words.end(), options.begin(), options.end());
        return run(words);
    }
    json data(const Words& options) {
        const Outcome outcome = page(options);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.out + outcome.err, "");
        return data_of_page();
    }
    json data_of_page() {
        const std::string text = here.read("p.html"), begin = R"(id="data">)";
        const std::size_t at = text.find(begin) + begin.size();
        return json::parse(text.substr(at, text.find("</script>", at) - at));
    }
    std::vector<std::pair<int, int>> chosen_of_many_samples() {
        std::vector<std::pair<int, int>> places;
        const json page = data({"-ss=60", "--crop=16,21,16,21"});
        for (const json& pixel : page.at("pixels")) places.emplace_back(pixel.at("x"), pixel.at("y"));
        return places;
    }
    json told(const Words& options, const json& pixel) {
        Words words{"pixeltrace", "a.pov", "40", "32", pixel.at("x").dump(), pixel.at("y").dump(), "--profile=povray", "--json"};
        words.insert(words.end(), options.begin(), options.end());
        return json::parse(run(words).out);
    }
    test::Workplace here;
};

TEST_F(PixelPageProgram, HasTheNumbersThatJsonHas) {
    for (const Words& options : std::vector<Words>{{}, {"--shading=povray"}, {"--profile=csc473"}, {"--profile=csc473", "-ss=2"}}) {
        if (!options.empty() && options[0] == "--profile=csc473")
            here.write("a.pov", std::string(glass_scene).replace(std::string(glass_scene).find(" area_light x, y, 3, 3"), 22, ""));
        const json page = data(options);
        ASSERT_GT(page.at("pixels").size(), 100u);
        for (const std::size_t i : {0u, 1u, 60u, 90u}) {
            const json& pixel = page.at("pixels").at(i);
            json want = told(options, pixel);
            EXPECT_EQ(pixel.at("radiance"), want.at("pixel").at("radiance"));
            EXPECT_EQ(page.at("camera"), want.at("camera"));
            EXPECT_EQ(page.at("origin"), want.at("pixel").at("origin"));
            json got = pixel.at("samples");
            for (json* samples : {&got, &want.at("samples")})
                for (json& sample : *samples)
                    for (json& ray : sample)
                        if (ray.contains("hit")) ray["hit"].erase("object_ray"), ray["hit"].erase("shadows");
            EXPECT_EQ(got, want.at("samples"));
        }
    }
}

TEST_F(PixelPageProgram, SaysOfAnAreaLightHowManySamplesArrive) {
    const json page = data({});
    int partly = 0;
    for (const json& pixel : page.at("pixels")) {
        for (const json& ray : pixel.at("samples").at(0)) {
            if (!ray.contains("hit") || ray.at("hit").at("shadows").empty()) continue;
            const json& shadow = ray.at("hit").at("shadows").at(0);
            EXPECT_EQ(ray.at("hit").at("shadows").size(), 1u);
            partly += shadow.at("samples") == 9 && shadow.at("transmitted").at(0) > 0 && shadow.at("transmitted").at(0) < 1;
        }
    }
    EXPECT_GT(partly, 0);
}

TEST_F(PixelPageProgram, TracesTheGridAndThePixelsAskedFor) {
    const auto places = [](const json& page, bool asked) {
        std::vector<std::pair<int, int>> found;
        for (const json& pixel : page.at("pixels"))
            if (pixel.at("asked") == asked) found.emplace_back(pixel.at("x"), pixel.at("y"));
        return found;
    };
    const json alone = data({"--grid=0"});
    EXPECT_THAT(places(alone, true), testing::ElementsAre(std::pair(17, 20)));
    EXPECT_TRUE(places(alone, false).empty());
    EXPECT_EQ(alone.at("spacing"), 0);
    const json grid = data({"--grid", "16", "--pixel", "8,8", "--pixel=1,2"});
    EXPECT_THAT(places(grid, true), testing::ElementsAre(std::pair(17, 20), std::pair(8, 8), std::pair(1, 2)));
    EXPECT_THAT(places(grid, false),
                testing::ElementsAre(std::pair(24, 8), std::pair(8, 24), std::pair(24, 24)));  // 40 lies outside, 8,8 was asked for
    const json cropped = data({"--grid=16", "--crop=10,30,12,30"});
    EXPECT_THAT(places(cropped, false), testing::ElementsAre(std::pair(18, 20)));
    EXPECT_THAT(page({"--crop=0,9,0,9"}).err, HasSubstr("pixel 17,20 is outside of the part that --crop leaves"));
    // The course counts from below: the grid is the picture's.
    const json course = data({"--grid=20", "--shading=povray", "--profile=csc473"});
    EXPECT_THAT(places(course, false), testing::ElementsAre(std::pair(10, 21), std::pair(30, 21), std::pair(10, 1), std::pair(30, 1)));
}

TEST_F(PixelPageProgram, IsTheSameForAnyNumberOfThreads) {
    EXPECT_EQ(page({"-t1"}).status, 0);
    const std::string one = here.read("p.html");
    EXPECT_EQ(page({"-t3"}).status, 0);
    std::string three = here.read("p.html");
    three.replace(three.find("\"-t3\""), 5, "\"-t1\"");
    EXPECT_EQ(one, three);
}

TEST_F(PixelPageProgram, IsNotLargeUnlessAsked) {
    const auto rays = [](const json& page) {
        std::size_t count = 0;
        for (const json& pixel : page.at("pixels"))
            for (const json& sample : pixel.at("samples")) count += sample.size();
        return count;
    };
    const json chosen = data({"-ss=4"});
    EXPECT_LT(rays(chosen), 3600u);
    EXPECT_GT(chosen.at("spacing"), 2);
    EXPECT_EQ(data({}).at("spacing"), 1);
    EXPECT_THAT(chosen_of_many_samples(), testing::ElementsAre(std::pair(17, 20), std::pair(18, 18)));
    const std::string too_large = "rays is too large, at most 60000 are possible: choose a larger --grid or fewer pixels\n";
    const auto expect_refused = [&](const Outcome& refused, const std::string& how_many) {
        EXPECT_EQ(refused.status, 4);
        EXPECT_EQ(refused.err, "raytrace: a page of " + how_many + " " + too_large);
    };
    expect_refused(page({"-ss=8", "--grid=1"}), "81920 or more");
    Words asked{"-ss=64", "--grid=0"};
    for (int x = 0; x < 14; ++x) asked.push_back("--pixel=" + std::to_string(x) + ",0");
    expect_refused(page(asked), "61440 or more");
    const Words many{"pixeltrace", "a.pov", "4000", "3000", "1", "1", "--html=q.html", "--grid=1", "--profile=povray"};
    expect_refused(run(many), "12000000 or more");
    // Of a picture that nobody waits for: no memory holds it.
    const Words huge{"pixeltrace", "a.pov", "1000000", "1000000", "1", "1", "--html=q.html", "--grid=5000", "--profile=povray"};
    expect_refused(run(huge), "more than 60000");
    EXPECT_EQ(here.files(), (Words{"a.pov", "p.html"}));
}

TEST_F(PixelPageProgram, FlatPicturesHaveAGrid) {
    const auto grid_of = [&](const Words& size, const Words& options) {
        Words words{"pixeltrace", "a.pov", size[0], size[1], "0", "0", "--profile=povray", "--html=p.html"};
        words.insert(words.end(), options.begin(), options.end());
        EXPECT_EQ(run(words).status, 0);
        const json page = data_of_page();
        std::vector<std::pair<int, int>> places;
        for (const json& pixel : page.at("pixels"))
            if (!pixel.at("asked")) places.emplace_back(pixel.at("x"), pixel.at("y"));
        EXPECT_EQ(places.empty(), page.at("spacing") == 0);
        return places;
    };
    EXPECT_GT(grid_of({"2000", "1"}, {}).size(), 100u);
    EXPECT_GT(grid_of({"2000", "1"}, {"-ss=3"}).size(), 20u);
    EXPECT_GT(grid_of({"1", "2000"}, {}).size(), 100u);
    EXPECT_THAT(grid_of({"600", "60"}, {"--grid=200"}), testing::ElementsAre(std::pair(100, 30), std::pair(300, 30), std::pair(500, 30)));
    EXPECT_THAT(grid_of({"600", "60"}, {"--grid=200", "--crop=0,299,0,9"}), testing::ElementsAre(std::pair(100, 4)));
    // As many pixels as in a whole picture, where a part of it is wanted.
    EXPECT_GT(grid_of({"4000", "3000"}, {"--crop=0,39,0,29"}).size(), 1000u);
    EXPECT_TRUE(grid_of({"1", "1"}, {}).empty());
}

TEST_F(PixelPageProgram, NeverTakesThePlaceOfItsScene) {
    here.write("inc.inc", "#declare Ball = sphere { 0, 1 pigment { rgb 1 } }\n");
    const std::string scene = "#include \"inc.inc\"\ncamera { location -5*z look_at 0 }\nobject { Ball }\n";
    here.write("b.pov", scene);
    symlink("b.pov", "link.html");
    link("inc.inc", "hard.html");
    for (const auto& [target, input] : std::vector<std::pair<std::string, std::string>>{
             {"b.pov", "b.pov"}, {"./b.pov", "b.pov"}, {"link.html", "b.pov"}, {"inc.inc", "inc.inc"}, {"hard.html", "inc.inc"}}) {
        const Outcome outcome = run({"pixeltrace", "b.pov", "8", "6", "1", "1", "--profile=povray", "--html", target});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.err, "raytrace: --html " + target + ": the page would take the place of '" + input + "', which it is made of\n");
    }
    EXPECT_EQ(here.read("b.pov"), scene);
    EXPECT_EQ(run({"a.pov", "-W8", "-H6", "-o", "sky.ppm"}).status, 0);
    EXPECT_THAT(run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--environment=sky.ppm", "--profile=povray", "--html=sky.ppm"}).err,
                HasSubstr("the page would take the place of 'sky.ppm'"));
}

TEST_F(PixelPageProgram, MistakesAreNamedBeforeAnyWork) {
    EXPECT_EQ(run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--grid=2"}).err, "raytrace: option '--grid' goes with --html FILE\n");
    EXPECT_EQ(run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--html"}).err, "raytrace: option '--html' needs a value\n");
    EXPECT_EQ(run({"printrays", "a.pov", "8", "6", "1", "1", "--html=x"}).err, "raytrace: option '--html' goes with pixeltrace\n");
    EXPECT_EQ(run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--htlm=x"}).err,
              "raytrace: unknown option '--htlm'; did you mean '--html'?\n");
    EXPECT_EQ(page({"--json"}).err, "raytrace: --html and --json are two forms of one answer: choose one\n");
    const Words command{"pixeltrace", "a.pov", "8", "6", "1", "1"};
    const auto error_of = [&](const Words& options) {
        Words words = command;
        words.insert(words.end(), options.begin(), options.end());
        return run(words).err;
    };
    EXPECT_EQ(error_of({"--html=a.html", "--html=b.html"}), "raytrace: option '--html' is given twice\n");
    EXPECT_EQ(error_of({"--html=a.html", "--grid", "2", "--grid=3"}), "raytrace: option '--grid' is given twice\n");
    EXPECT_EQ(error_of({"--html", "--json"}),
              "raytrace: option '--html' needs a value, found the option '--json' (a value of that name: --html=--json)\n");
    const std::string no_picture = "goes with render and raycast: pixeltrace writes no picture\n";
    EXPECT_EQ(error_of({"--html=a.html", "-o", "b.png"}), "raytrace: option '-o' " + no_picture);
    EXPECT_EQ(error_of({"--output=b.png"}), "raytrace: option '--output' " + no_picture);
    EXPECT_EQ(error_of({"--max-error", "0.1"}), "raytrace: option '--max-error' " + no_picture);
    EXPECT_EQ(error_of({"--html=a.html", "--max-error=0.1"}), "raytrace: option '--max-error' " + no_picture);
    EXPECT_EQ(error_of({"--json", "--time=1"}), "raytrace: option '--time' " + no_picture);
    EXPECT_EQ(error_of({"--preview"}), "raytrace: option '--preview' " + no_picture);
    for (const std::string other : {"pixelray", "firsthit", "pixelcolor", "printrays"})
        EXPECT_EQ(run({other, "a.pov", "8", "6", "1", "1", "--max-error=0.1"}).err,
                  "raytrace: option '--max-error' goes with render and raycast: " + other + " writes no picture\n");
    EXPECT_EQ(run({"sceneinfo", "a.pov", "-o", "b.png"}).err,
              "raytrace: option '-o' goes with render and raycast: sceneinfo writes no picture\n");
    EXPECT_THAT(page({"--pixel=40,1"}).err, HasSubstr("--pixel: x"));
    EXPECT_EQ(page({"--pixel=7"}).err, "raytrace: --pixel: expected X,Y, found '7'\n");
    EXPECT_THAT(page({"--grid=-1"}).err, HasSubstr("--grid"));
    EXPECT_EQ(here.files(), (Words{"a.pov"}));
}

TEST_F(PixelPageProgram, IsWrittenWholeOrNotAtAll) {
    const Outcome nowhere = run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--html", "none/p.html"});
    EXPECT_EQ(nowhere.status, 3);
    EXPECT_EQ(nowhere.err, "raytrace: Cannot write 'none/p.html': No such file or directory\n");
    here.write("old.html", "old");
    for (const std::vector<int>& signals : {std::vector<int>{SIGINT}, std::vector<int>{SIGTERM, SIGINT}}) {
        const Outcome interrupted = test::run_and_interrupt(
            {"pixeltrace", "a.pov", "4000", "4000", "9", "9", "-ss=8", "-t2", "--profile=povray", "--html=old.html"}, signals);
        EXPECT_EQ(interrupted.status, 2);
        EXPECT_THAT(interrupted.err, HasSubstr("raytrace: interrupted\n"));
        EXPECT_EQ(here.files(), (Words{"a.pov", "old.html"}));
        EXPECT_EQ(here.read("old.html"), "old");
    }
}

TEST_F(PixelPageProgram, AFullDiskIsNotWritten) {
    if (access("/dev/full", W_OK) != 0) GTEST_SKIP() << "no /dev/full here";
    const Outcome full = run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--html", "/dev/full", "--profile=povray"});
    EXPECT_EQ(full.status, 3);
    EXPECT_EQ(full.err, "raytrace: Cannot write '/dev/full': No space left on device\n");
}

TEST_F(PixelPageProgram, GoesToStandardOutputWhereAsked) {
    const Outcome out = run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--html", "-", "--profile=povray"});
    EXPECT_EQ(out.status, 0);
    EXPECT_TRUE(out.out.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(out.out.ends_with("</html>\n"));
    EXPECT_EQ(here.files(), (Words{"a.pov"}));
}

}  // namespace
}  // namespace rt::pixel_page_test
