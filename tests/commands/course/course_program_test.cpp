// The course's commands as a user types them: what they print, that a pixel's numbers are the picture's, and every wrong line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::course_program_test {
namespace {

using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

const char* const course_scene =
    "camera { location <0, 0, 14> up <0, 1, 0> right <1.33333, 0, 0> look_at <0, 0, 0> }\n"
    "light_source { <-10, 10, 10> color rgb <1.5, 1.2, 1> }\n"
    "sphere { <0, 0, 0>, 2 pigment { color rgbf <1, 0.5, 0.25, 0.75> } finish { ambient 0.2 diffuse 0.4 ior 1.5 } }\n"
    "sphere { <0, 0, 0>, 2 pigment { color rgb <0.5, 1, 0.25> }\n"
    "  finish { ambient 0.2 diffuse 0.4 specular 0.6 roughness 0.1 reflection 0.5 ior 1.4 }\n"
    "  scale <1, 1.5, 1> rotate <10, 20, 30> translate <3, 0, -4> }\n"
    "plane { <0, 1, 0>, -4 pigment { color rgb <0.2, 0.2, 0.8> } finish { ambient 0.4 diffuse 0.8 } }\n"
    "triangle { <-5, -2, -3>, <-2, -2, -3>, <-4, 3, -3> pigment { color rgb <1, 1, 0> } }\n";

class CourseProgram : public testing::Test {
protected:
    CourseProgram() { here.write("a.pov", course_scene); }
    test::Workplace here;
};

TEST_F(CourseProgram, PixelsAreCountedFromTheBottomLeft) {
    EXPECT_EQ(run({"pixelray", "a.pov", "640", "480", "170", "360"}).out,
              "Pixel: [170, 360] Ray: {0.0000 0.0000 14.0000} -> {-0.2892 0.2331 -0.9285}\n");
    EXPECT_EQ(run({"pixelray", "a.pov", "2", "1", "0", "0"}).out,
              "Pixel: [0, 0] Ray: {0.0000 0.0000 14.0000} -> {-0.3162 0.0000 -0.9487}\n");
    EXPECT_EQ(run({"pixelray", "a.pov", "1", "2", "0", "0"}).out,
              "Pixel: [0, 0] Ray: {0.0000 0.0000 14.0000} -> {0.0000 -0.2425 -0.9701}\n");
}

TEST_F(CourseProgram, FirstHitNamesDistanceTypeAndPigment) {
    EXPECT_EQ(run({"firsthit", "a.pov", "3", "3", "1", "1"}).out,
              "Pixel: [1, 1] Ray: {0.0000 0.0000 14.0000} -> {0.0000 0.0000 -1.0000}\n"
              "T = 12.0000\nObject Type: Sphere\nColor: 1.0000 0.5000 0.2500\n");
    EXPECT_EQ(run({"firsthit", "a.pov", "3", "3", "1", "2"}).out,
              "Pixel: [1, 2] Ray: {0.0000 0.0000 14.0000} -> {0.0000 0.3162 -0.9487}\nNo Hit\n");
}

TEST_F(CourseProgram, SceneInfoHasTheCoursesDefaults) {
    const std::string out = run({"sceneinfo", "a.pov"}).out;
    EXPECT_NE(out.find("- Color: {1.0000 1.0000 0.0000}\n- Material:\n  - Ambient: 0.0000\n  - Diffuse: 0.0000\n"), std::string::npos)
        << out;
}

/// The bytes of a pixel of output.png, counted from the bottom left, as the texts print them.
std::string bytes_of_picture(int x, int y) {
    const StoredImage image = read_image("output.png");
    const std::size_t first =
        (static_cast<std::size_t>(image.height - 1 - y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
        static_cast<std::size_t>(image.channels);
    const auto byte = [&](std::size_t c) { return static_cast<int>(image.values.at(first + c)); };
    return fmt::format("Color: ({}, {}, {})\n", byte(0), byte(1), byte(2));
}

TEST_F(CourseProgram, PixelsHaveTheNumbersOfThePicture) {
    for (const Words& options : std::vector<Words>{{},
                                                   {"-fresnel"},
                                                   {"-altbrdf", "-beers"},
                                                   {"-ss=2", "-sds"},
                                                   {"-gi_samples=9,4", "-gi"},
                                                   {"--shading", "povray"},
                                                   {"-normals"}}) {
        Words render{"render", "a.pov", "48", "36"};
        render.insert(render.end(), options.begin(), options.end());
        const Outcome picture = run(render);
        ASSERT_EQ(picture.status, 0) << picture.err;
        EXPECT_EQ(picture.out + picture.err, "");
        for (const auto& [x, y] : {std::pair(24, 18), std::pair(34, 17), std::pair(5, 2), std::pair(36, 25), std::pair(15, 19)}) {
            const std::string want = bytes_of_picture(x, y);
            for (const char* command : {"pixelcolor", "printrays", "pixeltrace"}) {
                Words words{command, "a.pov", "48", "36", std::to_string(x), std::to_string(y)};
                words.insert(words.end(), options.begin(), options.end());
                const Outcome text = run(words);
                EXPECT_EQ(text.status, 0) << text.err;
                EXPECT_EQ(text.err, "");
                const bool told = text.out.find("No Hit") != std::string::npos || text.out.find(want) != std::string::npos;
                EXPECT_TRUE(told) << want << text.out << fmt::format("{}", fmt::join(options, " "));
            }
        }
    }
}

TEST_F(CourseProgram, OptionsChangeWhatTheyNameAlone) {
    const auto picture = [&](const Words& options) {
        Words words{"render", "a.pov", "48", "36"};
        words.insert(words.end(), options.begin(), options.end());
        EXPECT_EQ(run(words).status, 0);
        return read_image("output.png").values;
    };
    const auto plain = picture({});
    EXPECT_EQ(picture({"-sds"}), plain);
    for (const char* option : {"-fresnel", "-altbrdf", "-beers", "-normals", "-gi", "-ss=2"}) EXPECT_NE(picture({option}), plain) << option;
    EXPECT_EQ(picture({"-gi"}), picture({"-gi", "-gi_samples=64,16"}));
    EXPECT_EQ(picture({"-gi", "-gi_samples=4,9", "-gi_bounces=1"}), picture({"-gi_samples=4", "-gi"}));
    EXPECT_EQ(picture({"-gi", "-gi_samples=4", "-gi_bounces=2"}), picture({"-gi_samples=4,4", "-gi"}));
    EXPECT_EQ(picture({"-gi", "-gi_samples=4,2", "-t1"}), picture({"-gi", "-gi_samples=4,2", "-t3"}));
}

TEST_F(CourseProgram, RaycastShowsPigments) {
    EXPECT_EQ(run({"raycast", "a.pov", "48", "36"}).status, 0);
    EXPECT_EQ(bytes_of_picture(24, 18), "Color: (255, 128, 64)\n");
    EXPECT_EQ(bytes_of_picture(24, 35), "Color: (0, 0, 0)\n");
}

TEST_F(CourseProgram, PrintbvhHalvesTheObjectsAlongXYZInTurn) {
    here.write(
        "b.pov",
        "sphere { <4, 0, 0>, 1 }\nplane { <0, 1, 0>, -4 }\nsphere { <0, 0, 0>, 1 translate <1.5, 0, 0> }\nsphere { <-3, 2, 0>, 0.5 }\n");
    EXPECT_EQ(run({"printbvh", "b.pov"}).out,
              "Root:\n- Min: {-3.5000 -1.0000 -1.0000}\n- Max: {5.0000 2.5000 1.0000}\n- Branch: 3 objects\n\n"
              "Root/L:\n- Min: {-3.5000 1.5000 -0.5000}\n- Max: {-2.5000 2.5000 0.5000}\n- Leaf: (ID #4 - Sphere)\n\n"
              "Root/R:\n- Min: {0.5000 -1.0000 -1.0000}\n- Max: {5.0000 1.0000 1.0000}\n- Branch: 2 objects\n\n"
              "Root/R/L:\n- Min: {0.5000 -1.0000 -1.0000}\n- Max: {2.5000 1.0000 1.0000}\n- Leaf: (ID #3 - Sphere)\n\n"
              "Root/R/R:\n- Min: {3.0000 -1.0000 -1.0000}\n- Max: {5.0000 1.0000 1.0000}\n- Leaf: (ID #1 - Sphere)\n\n"
              "Without a box:\n(ID #2 - Plane)\n");
}

struct Wrong {
    Words words;
    std::string error;
    friend std::ostream& operator<<(std::ostream& out, const Wrong& w) { return out << fmt::format("{}", fmt::join(w.words, " ")); }
};

class CourseMistakes : public testing::TestWithParam<Wrong> {};

TEST_P(CourseMistakes, HaveOneLineAndLeaveThePictureAlone) {
    test::Workplace here;
    here.write("a.pov", course_scene);
    here.write("output.png", "what was here before");
    const Outcome outcome = run(GetParam().words);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, GetParam().error + "\n");
    EXPECT_EQ(here.read("output.png"), "what was here before");
    EXPECT_EQ(here.files(), (Words{"a.pov", "output.png"}));
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, CourseMistakes,
    testing::Values(Wrong{{"render"}, "raytrace: expected: raytrace render SCENE WIDTH HEIGHT [options]"},
                    Wrong{{"render", "a.pov", "8"}, "raytrace: expected: raytrace render SCENE WIDTH HEIGHT [options]"},
                    Wrong{{"raycast", "a.pov", "8", "6", "1"}, "raytrace: expected: raytrace raycast SCENE WIDTH HEIGHT [options]"},
                    Wrong{{"sceneinfo"}, "raytrace: expected: raytrace sceneinfo SCENE"},
                    Wrong{{"sceneinfo", "a.pov", "8", "6"}, "raytrace: expected: raytrace sceneinfo SCENE"},
                    Wrong{{"printbvh"}, "raytrace: expected: raytrace printbvh SCENE"},
                    Wrong{{"pixelray", "a.pov", "8", "6"}, "raytrace: expected: raytrace pixelray SCENE WIDTH HEIGHT X Y [options]"},
                    Wrong{{"firsthit", "a.pov", "8", "6", "1"}, "raytrace: expected: raytrace firsthit SCENE WIDTH HEIGHT X Y [options]"},
                    Wrong{{"pixelcolor", "8", "6", "1", "1"}, "raytrace: expected: raytrace pixelcolor SCENE WIDTH HEIGHT X Y [options]"},
                    Wrong{{"printrays"}, "raytrace: expected: raytrace printrays SCENE WIDTH HEIGHT X Y [options]"},
                    Wrong{{"pixeltrace", "a.pov"}, "raytrace: expected: raytrace pixeltrace SCENE WIDTH HEIGHT X Y [options]"},
                    Wrong{{"pixeltrce", "a.pov"}, "raytrace: 'pixeltrce' is neither a command nor a scene; did you mean 'pixeltrace'?"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, CourseMistakes,
    testing::Values(Wrong{{"render", "a.pov", "wide", "6"}, "raytrace: width: 'wide' is no number"},
                    Wrong{{"render", "a.pov", "8", "6x"}, "raytrace: height: '6x' is no number"},
                    Wrong{{"render", "a.pov", "0", "6"}, "raytrace: width: 0 is outside 1 to 1000000"},
                    Wrong{{"render", "a.pov", "8", "-6"}, "raytrace: height: -6 is outside 1 to 1000000"},
                    Wrong{{"render", "a.pov", "8.5", "6"}, "raytrace: width: expected a whole number, not '8.5'"},
                    Wrong{{"pixelray", "a.pov", "8", "6", "x", "1"}, "raytrace: x: 'x' is no number"},
                    Wrong{{"pixelray", "a.pov", "8", "6", "1", ""}, "raytrace: y: '' is no number"},
                    Wrong{{"firsthit", "a.pov", "8", "6", "8", "1"}, "raytrace: x: 8 is outside 0 to 7"},
                    Wrong{{"pixelcolor", "a.pov", "8", "6", "1", "6"}, "raytrace: y: 6 is outside 0 to 5"},
                    Wrong{{"printrays", "a.pov", "8", "6", "-1", "1"}, "raytrace: x: -1 is outside 0 to 7"},
                    Wrong{{"render", "a.pov", "8", "6", "-ss=two"}, "raytrace: ss: 'two' is no number"},
                    Wrong{{"render", "a.pov", "8", "6", "-ss=0"}, "raytrace: ss: 0 is outside 1 to 64"},
                    Wrong{{"render", "a.pov", "8", "6", "-gi", "-gi_samples=4,x"}, "raytrace: -gi_samples: 'x' is no number"},
                    Wrong{{"render", "a.pov", "8", "6", "-gi", "-gi_samples"}, "raytrace: -gi_samples: '' is no number"},
                    Wrong{{"render", "a.pov", "8", "6", "-gi", "-gi_bounces=99"}, "raytrace: -gi_bounces: 99 is outside 1 to 16"}));

INSTANTIATE_TEST_SUITE_P(
    Options, CourseMistakes,
    testing::Values(Wrong{{"render", "a.pov", "8", "6", "-fresnl"}, "raytrace: unknown option '-fresnl'; did you mean '-fresnel'?"},
                    Wrong{{"printrays", "a.pov", "8", "6", "1", "1", "-altbdrf"},
                          "raytrace: unknown option '-altbdrf'; did you mean '-altbrdf'?"},
                    Wrong{{"render", "a.pov", "8", "6", "-fresnel=1"}, "raytrace: option '-fresnel' takes no value"},
                    Wrong{{"render", "a.pov", "8", "6", "-gi_samples=4"}, "raytrace: option '-gi_samples' goes with -gi"},
                    Wrong{{"pixelcolor", "a.pov", "8", "6", "1", "1", "-W9"},
                          "raytrace: '-W9': the size stands behind the scene: raytrace pixelcolor SCENE WIDTH HEIGHT"},
                    Wrong{{"render", "a.pov", "8", "6", "-fresnel", "--shading", "povray"},
                          "raytrace: the course's options go with its own rules, not with another shading"},
                    Wrong{{"a.pov", "--profile=csc473", "-q", "+Q3"},
                          "raytrace: a quality (+Q) goes with another shading, not with the course's rules"},
                    Wrong{{"render", "b.pov", "8", "6"}, "File 'b.pov': Parse Error: Cannot open input file."},
                    Wrong{{"sceneinfo", "b.pov"}, "File 'b.pov': Parse Error: Cannot open input file."},
                    Wrong{{"printrays", "b.pov", "8", "6", "1", "1"}, "File 'b.pov': Parse Error: Cannot open input file."}));

TEST_F(CourseProgram, APictureThatCannotBeWrittenIsAFailure) {
    here.write("output.png/file", "");
    std::filesystem::create_directory("output.png");
    const Outcome outcome = run({"render", "a.pov", "8", "6"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.err.find("output.png"), std::string::npos);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

TEST_F(CourseProgram, WhatItsRulesCannotShowIsRefusedWithItsPlace) {
    const auto error = [&](const std::string& text) {
        here.write("b.pov", text + "\n");
        const Outcome outcome = run({"render", "b.pov", "8", "6"});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(run({"render", "b.pov", "8", "6", "--shading=povray"}).status, 0);
        return outcome.err.substr(0, outcome.err.find('\n'));
    };
    const std::string begin = "File 'b.pov' line 1: Parse Error: ", end = " is no part of the course's scenes; --shading povray shows it.";
    EXPECT_EQ(error("light_source { 0, rgb 1 spotlight }"), begin + "A lamp other than a point" + end);
    EXPECT_EQ(error("light_source { 0, rgb 1 shadowless }"), begin + "A lamp without shadows" + end);
    EXPECT_EQ(error("light_source { 0, rgb 1 area_light x, y, 2, 2 }"), begin + "An area light" + end);
    EXPECT_EQ(error("light_source { 0, rgb 1 fade_distance 2 fade_power 2 }"), begin + "A lamp that fades" + end);
    EXPECT_EQ(error("camera { orthographic }"), begin + "A camera of the type 'orthographic'" + end);
    EXPECT_EQ(error("camera { cylinder 2 }"), begin + "A camera of the type 'cylinder 2'" + end);
    EXPECT_EQ(error("sphere { 0, 1 pigment { rgbt <1, 1, 1, 0.5> } }"), begin + "'transmit'" + end);
    EXPECT_EQ(error("sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgb 1 } } }"),
              begin + "A texture of several layers" + end);
    EXPECT_EQ(error("sphere { 0, 1 texture { pigment { rgb 1 } } interior_texture { pigment { rgb 1 } } }"),
              begin + "'interior_texture'" + end);
    EXPECT_EQ(error("#declare T = texture { pigment { rgb 1 } } mesh { triangle { 0, x, y texture { T } } triangle { 0, x, z } }"),
              begin + "A texture of a part of a shape" + end);
}

TEST_F(CourseProgram, WordsThatItsRulesDoNotUseAreWarnedOfOutsideTheCoursesOwnCommands) {
    here.write("b.pov", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nsphere { 0, 1 finish { phong 0.5 } }\n");
    EXPECT_EQ(run({"render", "b.pov", "8", "6"}).err, "");
    const Outcome outcome = run({"b.pov", "--profile=csc473", "--size=8x6"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("line 3: Parse Warning: The course's rules do not use phong."), std::string::npos) << outcome.err;
}

TEST_F(CourseProgram, SurroundingsBelongToOtherShadings) {
    here.write("sky.pov", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb <0.2, 0.4, 0.8> }\n");
    EXPECT_EQ(run({"sky.pov", "--size=8x4"}).status, 0);
    EXPECT_EQ(run({"pixelcolor", "a.pov", "8", "6", "4", "3", "--environment", "sky.png"}).err,
              "raytrace: --environment goes with another shading, not with the course's rules\n");
    Words render{"render", "a.pov", "8", "6"}, pixel{"printrays", "a.pov", "8", "6", "4", "5"};
    for (const char* option : {"--environment=sky.png", "--shading=general"}) render.emplace_back(option), pixel.emplace_back(option);
    EXPECT_EQ(run(render).status, 0);
    const std::string sky = bytes_of_picture(4, 5);
    EXPECT_NE(sky, "Color: (0, 0, 0)\n");
    EXPECT_NE(run(pixel).out.find(sky), std::string::npos);
}

TEST_F(CourseProgram, HelpIsTheTopic) {
    const std::string topic = run({"help", "course"}).out;
    EXPECT_NE(topic, "");
    for (const char* command :
         {"render", "raycast", "sceneinfo", "pixelray", "firsthit", "pixelcolor", "printrays", "pixeltrace", "printbvh"}) {
        EXPECT_EQ(run({command, "--help"}).out, topic);
        EXPECT_NE(topic.find(command), std::string::npos) << command;
    }
}

}  // namespace
}  // namespace rt::course_program_test
