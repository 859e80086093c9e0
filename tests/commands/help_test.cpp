// Every help text fits a screen.
#include "commands/help.h"

#include <gtest/gtest.h>

#include <sstream>

#include "commands/base/suggest.h"
#include "tests/commands/support.h"

namespace rt::help_test {
namespace {

void expect_fits(const std::string& what, const std::string& text) {
    std::istringstream lines(text);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 79u) << what << ": " << line;
    EXPECT_LE(count, 24) << what;
    EXPECT_GE(count, 4) << what;
}

TEST(Help, EveryCommandFitsAScreen) {
    for (const char* name : {"", "requires", "compare", "versus", "trade", "explain", "grade", "merge", "brdf", "render", "sceneinfo"}) {
        const std::string command = name;
        std::vector<std::string> words;
        if (!command.empty()) words.push_back(command);
        words.push_back("--help");
        const test::Outcome outcome = test::run(words);
        EXPECT_EQ(outcome.status, 0) << command;
        EXPECT_EQ(outcome.err, "") << command;
        expect_fits(command, outcome.out);
    }
}

TEST(Help, ThePlotsHelpFitsAScreen) {
    const test::Outcome outcome = test::run({"brdf", "plot", "--help"});
    EXPECT_EQ(outcome.status, 0);
    expect_fits("brdf plot", outcome.out);
}

TEST(Help, EveryTopicFitsAScreen) {
    for (const std::string& topic : help_topics()) {
        const test::Outcome outcome = test::run({"help", topic});
        EXPECT_EQ(outcome.status, 0) << topic;
        EXPECT_EQ(outcome.out, help_topic(topic));
        expect_fits(topic, outcome.out);
    }
}

TEST(Help, UnknownTopicsAreNamed) {
    const test::Outcome outcome = test::run({"help", "shadng"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "raytrace: no help on 'shadng'; did you mean 'shading'?\n");
}

TEST(Suggestions, NearestWordWithinAThird) {
    EXPECT_EQ(nearest_word("heigth", {"width", "height"}), "height");
    EXPECT_EQ(nearest_word("WIDTH", {"width", "height"}), "width");
    EXPECT_EQ(nearest_word("xyzzy", {"width", "height"}), "");
    EXPECT_EQ(nearest_word("ab", {"abcd"}), "");
    EXPECT_EQ(nearest_word("", {"a"}), "a");
    EXPECT_EQ(nearest_word(std::string(100000, 'x'), {"a"}), "");
    EXPECT_EQ(nearest_word("widht", {std::string(100'000'000, 'w'), "width"}), "width");
}

}  // namespace
}  // namespace rt::help_test
