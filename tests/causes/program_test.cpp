// `raytrace grade` says why a program's answers are wrong: its pictures, the rays it tells of, its texts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/causes/scene_maker.h"

namespace rt::test::program_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string contents(const fs::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

void call(const std::string& command, int status = 0) {
    const int ended = std::system((command + " > /dev/null 2>&1").c_str());
    ASSERT_TRUE(WIFEXITED(ended));
    ASSERT_EQ(WEXITSTATUS(ended), status) << command;
}

/// A suite with one picture and one record of rays, and a program beside it.
class GradedCause : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "raytrace_graded_XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        place = pattern;
        for (const char* folder : {"suite/inputs", "suite/answers", "program", "run/build"}) fs::create_directories(place / folder);
        std::ofstream(place / "suite/inputs/scene.pov") << random_scene(1);
        fs::create_directory_symlink(place / "suite/inputs", place / "run/resources");
        const std::string there = fmt::format("cd '{}' && '{}' ", (place / "run/build").string(), PROGRAM);
        call(there + picture + " -o ../../suite/answers/picture.png");
        ASSERT_EQ(std::system(fmt::format("{} {} > ../../suite/answers/rays.out", there, rays).c_str()), 0);
        std::ofstream(place / "suite/suite.json") << fmt::format(
            R"({{"format": "raytrace suite 1", "inputs": "inputs", "tests": [
 {{"name": "picture", "command": "{}", "expected": "answers/picture.png", "pass": [{{"metric": "differing", "at_most": 50}}]}},
 {{"name": "rays", "kind": "text", "command": "{}", "expected": "answers/rays.out"}}]}})",
            picture, rays);
        fs::copy_file(FAULTY, place / "program/faulty");
    }
    void TearDown() override { fs::remove_all(place); }

    /// The results of a program that begins with a few lines of the shell.
    std::string graded(const std::string& lines) {
        const fs::path program = place / "program/raytrace";
        std::ofstream(program) << fmt::format("#!/bin/sh\n{}\nexec \"$(dirname \"$0\")/faulty\" \"$@\"\n", lines);
        fs::permissions(program, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                                     fs::perms::others_exec);
        call(fmt::format("'{}' grade '{}' --exe '{}' -o '{}' --fresh -j 1", PROGRAM, (place / "suite/suite.json").string(),
                         program.parent_path().string(), (place / "results").string()),
             1);
        return contents(place / "results/results.json");
    }

    fs::path place;
    const std::string picture = "render ../resources/scene.pov 160 120", rays = "printrays ../resources/scene.pov 160 120 80 30";
};

TEST_F(GradedCause, PictureAndRaysSayTheSame) {
    const std::string results = graded("export RAYTRACE_FAULT=no_ambient");
    EXPECT_THAT(results, HasSubstr(R"("cause":"ambient missing")"));
    EXPECT_THAT(results, HasSubstr("our own picture without ambient light"));
    EXPECT_THAT(results, HasSubstr("the rays say the same as the picture"));
    EXPECT_THAT(results, HasSubstr(R"("cause":"missing or wrong ambient")"));  // of the text
}

TEST_F(GradedCause, WithoutRecordsOursIsShown) {
    const std::string results = graded("export RAYTRACE_FAULT=mirrored\n[ \"$1\" = printrays ] && exit 1");
    EXPECT_THAT(results, HasSubstr(R"("cause":"mirrored")"));
    EXPECT_THAT(results, HasSubstr("the picture is the expected one mirrored left to right"));
    EXPECT_THAT(results, HasSubstr("the program prints no rays of it; ours:"));
}

TEST_F(GradedCause, ARightProgramsAnswersHaveNone) {
    const std::string results = graded("[ \"$1\" = printrays ] && echo done");
    EXPECT_THAT(results, HasSubstr(R"("test":"picture","kind":"picture","required":true,"weight":1.0,"outcome":"passed")"));
    EXPECT_THAT(results, HasSubstr(R"("cause":"lines too many")"));
    EXPECT_THAT(results, Not(HasSubstr("our own picture")));
}

}  // namespace
}  // namespace rt::test::program_test
