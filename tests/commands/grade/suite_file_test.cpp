// Suites from the course's layout and from a file of our own, with every mistake told in full.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "commands/grade/suite_file.h"
#include "tests/commands/support.h"

namespace rt::suite_file_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class SuiteFile : public testing::Test {
protected:
    Suite read(const std::string& path, const std::string& inputs = "") {
        return read_suite(path, inputs, [this](std::string_view text) { notes_ += std::string(text) + "\n"; });
    }
    std::string mistake(const std::string& text) {
        place_.write("suite.json", text);
        try {
            read("suite.json");
        } catch (const std::exception& error) {
            return error.what();
        }
        return "none";
    }
    void part(const std::string& name) {
        fs::create_directories("suite/inputs");
        fs::create_directories("suite/" + name);
        place_.write("suite/" + name + "/tests.json",
                     R"([{"name": "test1", "type": "text", "required": true},
                         {"name": "shiny", "type": "image", "timeout": 45},
                         {"name": "own", "type": "additional"}, {"name": "gone", "type": "text"}])");
        place_.write("suite/" + name + "/test1.args", "pixelray  ../resources/a.pov 640 480\n10 20\n");
        place_.write("suite/" + name + "/test1.out", "");
        place_.write("suite/" + name + "/shiny.args", "render ../resources/a.pov 640 480");
        place_.write("suite/" + name + "/shiny.png", "");
        place_.write("suite/" + name + "/test7.args", "sceneinfo a.pov");
        place_.write("suite/" + name + "/test7.out", "");
    }

    test::Workplace place_;
    std::string notes_;
};

TEST_F(SuiteFile, ReadsTheCoursesLayout) {
    part("p10"), part("p2");
    const Suite suite = read("suite");
    EXPECT_EQ(suite.name, "suite");
    EXPECT_THAT(suite.inputs, EndsWith("suite/inputs"));
    std::vector<std::string> names;
    for (const TestCase& test : suite.tests) names.push_back(test.name);
    EXPECT_THAT(names, ElementsAre("p2/test1", "p2/shiny", "p2/own", "p2/test7", "p10/test1", "p10/shiny", "p10/own", "p10/test7"));
    const TestCase& text = suite.tests[0];
    EXPECT_EQ(text.kind, TestCase::Kind::text);
    EXPECT_THAT(text.arguments, ElementsAre("pixelray", "../resources/a.pov", "640", "480", "10", "20"));
    EXPECT_EQ(text.limits.wall_seconds, 20.0);
    EXPECT_TRUE(text.required);
    EXPECT_THAT(text.expected, EndsWith("suite/p2/test1.out"));
    const TestCase& picture = suite.tests[1];
    EXPECT_EQ(picture.limits.wall_seconds, 45.0);
    EXPECT_EQ(picture.output, "output.png");
    ASSERT_EQ(picture.pass.size(), 1u);
    EXPECT_EQ(picture.pass[0], (Threshold{Metric::differing, 1000.0}));
    EXPECT_EQ(suite.tests[2].kind, TestCase::Kind::shown);
    EXPECT_EQ(suite.tests[2].weight, 0.0);
    EXPECT_FALSE(suite.tests[3].required) << "it is not in the list";
    EXPECT_THAT(notes_, HasSubstr("test p2/gone is in the list but has no gone.args: left out"));
    EXPECT_THAT(notes_, HasSubstr("run, as not required: test7"));
}

TEST_F(SuiteFile, OnePartAlone) {
    part("p1");
    const Suite suite = read("suite/p1");
    EXPECT_EQ(suite.tests[0].name, "test1");
    EXPECT_THAT(suite.inputs, EndsWith("suite/inputs")) << "beside the part";
}

TEST_F(SuiteFile, NamesWhatIsMissing) {
    EXPECT_THROW(read("nothing"), OptionError);
    fs::create_directories("empty/inputs");
    try {
        read("empty");
        FAIL();
    } catch (const OptionError& error) {
        EXPECT_STREQ(
            error.what(),
            ("'" + fs::canonical("empty").string() + "' is no suite: it has no tests.json with tests, nor have its folders").c_str());
    }
    part("p1");
    EXPECT_THROW(read("suite", "no_folder"), OptionError);
}

TEST_F(SuiteFile, ReadsOurOwnFile) {
    place_.write("a.txt", "");
    fs::create_directory("scenes");
    place_.write("suite.json", R"({"format": "raytrace suite 1", "name": "Winter", "inputs": "scenes",
        "defaults": {"timeout": 5, "memory": 512, "weight": 2},
        "tests": [{"name": "a", "kind": "text", "command": "sceneinfo  ../resources/a.pov", "expected": "a.txt", "tolerance": 1e-3},
                  {"name": "b", "command": ["render", "my scene.pov"], "expected": "a.txt", "output": "b.png", "timeout": 9, "required": false,
                   "timed": true, "repeats": 3, "fuzz": 1, "processes": 8, "pass": [{"metric": "rmse", "at_most": 0.01}],
                   "credit": {"metric": "flip", "curve": [[0.1, 1], [0.2, 0]]}}]})");
    const Suite suite = read("suite.json");
    EXPECT_EQ(suite.name, "Winter");
    EXPECT_EQ(suite.inputs, fs::canonical("scenes").string());
    ASSERT_EQ(suite.tests.size(), 2u);
    EXPECT_THAT(suite.tests[0].arguments, ElementsAre("sceneinfo", "../resources/a.pov"));
    EXPECT_EQ(suite.tests[0].limits.wall_seconds, 5.0);
    EXPECT_EQ(suite.tests[0].limits.memory_bytes, 512ull << 20);
    EXPECT_EQ(suite.tests[0].weight, 2.0);
    EXPECT_EQ(suite.tests[0].tolerance, 1e-3);
    const TestCase& b = suite.tests[1];
    EXPECT_THAT(b.arguments, ElementsAre("render", "my scene.pov"));
    EXPECT_EQ(b.limits.wall_seconds, 9.0);
    EXPECT_EQ(b.limits.processes, 8);
    EXPECT_FALSE(b.required);
    EXPECT_TRUE(b.timed);
    EXPECT_EQ(b.repeats, 3);
    EXPECT_EQ(b.fuzz_percent, 1.0);
    EXPECT_EQ(b.pass[0], (Threshold{Metric::rmse, 0.01}));
    EXPECT_EQ(b.curve, (CreditCurve{Metric::flip, {{0.1, 1.0}, {0.2, 0.0}}}));
}

TEST_F(SuiteFile, RepeatedTestsAreTimed) {
    place_.write("a.txt", "x");
    place_.write("suite.json", R"({"format": "raytrace suite 1", "defaults": {"kind": "text"}, "tests": [
        {"name": "a", "command": "x", "expected": "a.txt", "repeats": 3}, {"name": "b", "command": "x", "expected": "a.txt"}]})");
    const Suite suite = read("suite.json");
    EXPECT_TRUE(suite.tests[0].timed);
    EXPECT_FALSE(suite.tests[1].timed);
}

TEST_F(SuiteFile, NotesTestsThatCannotTellAnything) {
    place_.write("empty.txt", " \n\n");
    place_.write("full.txt", "1\n");
    const auto picture = [&](const char* name, int pixels) {
        place_.write(name, "P6 " + std::to_string(pixels) + " 1 255\n" + std::string(3 * pixels, 'x'));
    };
    picture("small.ppm", 1000), picture("large.ppm", 1001);
    place_.write("suite.json", R"({"format": "raytrace suite 1", "tests": [
        {"name": "none", "kind": "text", "command": "x", "expected": "empty.txt"},
        {"name": "some", "kind": "text", "command": "x", "expected": "full.txt"},
        {"name": "small", "command": "x", "expected": "small.ppm"}, {"name": "large", "command": "x", "expected": "large.ppm"},
        {"name": "strict", "command": "x", "expected": "small.ppm", "pass": [{"metric": "differing", "at_most": 999}]},
        {"name": "both", "command": "x", "expected": "small.ppm", "pass": [{"metric": "differing", "at_most": 1000},
                                                                         {"metric": "rmse", "at_most": 0.1}]},
        {"name": "lax", "command": "x", "expected": "large.ppm", "pass": [{"metric": "rmse", "at_most": 1}]}]})");
    read("suite.json");
    EXPECT_THAT(notes_, HasSubstr("note: any picture of the right size passes small, lax: their rules allow for all that can differ\n"));
    EXPECT_THAT(notes_, HasSubstr("note: a program that prints nothing passes none: no text is expected\n"));
}

TEST_F(SuiteFile, NamesForgeNoLines) {
    const std::string odd = "p1\033[31m\nraytrace: note: forged";
    part(odd);
    place_.write("suite/" + odd + "/two\n\033[2J.args", "x");
    place_.write("suite/" + odd + "/two\n\033[2J.out", "1");
    read("suite");
    EXPECT_THAT(notes_, HasSubstr("note: test p1?[31m?raytrace: note: forged/gone is in the list but has no gone.args: left out\n"));
    EXPECT_THAT(notes_, HasSubstr("suite/p1?[31m?raytrace: note: forged/tests.json but run, as not required: test7, two??[2J\n"));
    EXPECT_EQ(notes_.find('\033'), notes_.npos);
    for (const std::string& path : {std::string("none\033\n"), "suite/" + odd}) try {
            fs::remove("suite/" + odd + "/test1.out");
            read(path);
            FAIL();
        } catch (const OptionError& error) {
            EXPECT_EQ(std::string(error.what()).find_first_of("\033\n"), std::string::npos) << error.what();
        }
}

TEST_F(SuiteFile, NamesOfTestsAreUtf8) {
    part("p1");
    place_.write("suite/p1/caf\xE9.args", "x");
    place_.write("suite/p1/caf\xE9.out", "1");
    try {
        read("suite");
        FAIL();
    } catch (const OptionError& error) {
        EXPECT_THAT(error.what(), EndsWith("suite/p1/caf?': its name is not UTF-8"));
    }
}

TEST_F(SuiteFile, EveryMistakeHasItsPlace) {
    place_.write("a.txt", "");
    EXPECT_EQ(mistake("{\"format\": \"raytrace suite 2\"}"),
              "File 'suite.json' line 1: Parse Error: Expected \"raytrace suite 1\", \"raytrace suite 2\" found instead.\n"
              "   1 | {\"format\": \"raytrace suite 2\"}\n"
              "     |            ^");
    const auto of_test = [&](const std::string& members) {
        return mistake("{\"format\": \"raytrace suite 1\", \"tests\": [\n{\"name\": \"a\", \"command\": \"x\", \"expected\": \"a.txt\"" +
                       members + "}]}");
    };
    const std::pair<const char*, const char*> cases[] = {
        {", \"timout\": 3", "line 2: Parse Error: Unknown member \"timout\"; known are name, kind, command, expected, output, required,"},
        {", \"timeout\": -1", "line 2: Parse Error: Expected a number from 0.01 to 86400, -1 found instead."},
        {", \"timeout\": \"3\"", "Expected a number from 0.01 to 86400, \"3\" found instead."},
        {", \"kind\": \"image\"", "Expected a kind of test: text, picture or shown, \"image\" found instead."},
        {", \"output\": \"../x\"", "Expected a file's name without a folder, \"../x\" found instead."},
        {", \"kind\": \"shown\"",
         "Expected a command whose second word is the name of the author's own scene, without a folder, \"x\" found"},
        {", \"pass\": []", "Expected at least one threshold, [] found instead."},
        {", \"pass\": [{\"metric\": \"psnr\", \"at_most\": 1}]", "Expected a metric, \"psnr\" found instead."},
        {", \"credit\": {\"metric\": \"rmse\", \"curve\": [[1, 1], [1, 0]]}",
         "Expected a figure above the one before, [1,0] found instead."},
        {"}, {\"name\": \"a\", \"command\": \"x\", \"expected\": \"a.txt\"",
         "Expected a name that no other test has, \"a\" found instead."},
        {"}, {\"name\": \"b\", \"command\": \"x\", \"expected\": \"b.txt\"",
         "Expected an existing file or folder, \"b.txt\" found instead."},
        {"}, {\"name\": \"b\", \"command\": \"x\"", "Expected a member \"expected\""}};
    for (const auto& [members, text] : cases) EXPECT_THAT(of_test(members), HasSubstr(text));
    EXPECT_THAT(mistake("{\"format\": \"raytrace suite 1\", \"tests\": []}"), HasSubstr("Expected at least one test, [] found instead."));
    EXPECT_THAT(mistake("{\"format\": "), HasSubstr("Parse Error: syntax error while parsing value"));
}

}  // namespace
}  // namespace rt::suite_file_test
