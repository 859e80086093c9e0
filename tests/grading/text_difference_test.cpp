// The rule of `diff -bB`, against diff itself, and the first field that differs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "grading/text_difference.h"

namespace rt::text_difference_test {
namespace {

TEST(TextDifference, BlanksAndBlankLinesDoNotMatter) {
    EXPECT_FALSE(first_difference("a b\nc\n", "a \t b  \r\n\n \nc", 0.0));
    EXPECT_FALSE(first_difference("", "\n \n", 0.0));
    EXPECT_TRUE(first_difference("a", " a", 0.0)) << "diff -b keeps whether a line is indented";
    EXPECT_TRUE(first_difference("ab", "a b", 0.0));
}

TEST(TextDifference, NamesTheFirstFieldThatDiffers) {
    const auto found = first_difference("Ray: {0 1 2}\nHit: {3.5 4}\n", "Ray: {0 1 2}\n\nHit: {3.25 4}\n", 0.0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 3u);
    EXPECT_EQ(found->field, 2u);
    EXPECT_EQ(found->expected, "{3.5");
    EXPECT_EQ(found->actual, "{3.25");
    ASSERT_TRUE(found->apart);
    EXPECT_DOUBLE_EQ(*found->apart, 0.25);
}

TEST(TextDifference, MissingAndSuperfluousLines) {
    const auto missing = first_difference("a\nb\n", "a\n", 0.0);
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->line, 2u);
    EXPECT_EQ(missing->field, 0u);
    EXPECT_EQ(missing->expected_line, "b");
    const auto more = first_difference("a\n", "a\nb\n", 0.0);
    ASSERT_TRUE(more);
    EXPECT_EQ(more->actual_line, "b");
    EXPECT_TRUE(more->expected_line.empty());
}

TEST(TextDifference, MinusZeroIsAnotherText) {
    EXPECT_TRUE(first_difference("-0.0000", "0.0000", 0.0));
    EXPECT_FALSE(first_difference("-0.0000", "0.0000", 1e-9));
}

TEST(TextDifference, ToleranceIsForNumbersAlone) {
    EXPECT_FALSE(first_difference("t {1.0000, 200.00}", "t {1.0001, 200.01}", 1.1e-4));
    EXPECT_TRUE(first_difference("t {1.0000}", "t {1.0002}", 1.1e-4));
    EXPECT_TRUE(first_difference("t1.0a", "t1.0b", 1.0)) << "what is around the number counts";
    EXPECT_TRUE(first_difference("sphere", "plane", 1.0));
}

std::string random_text(std::mt19937& random) {
    constexpr const char* pieces[] = {"a", "b", "c d", " ", "\t", "\n", "\n", "\n\n", "\r\n", "e"};
    std::string text;
    for (int i = 0; i < 8; ++i) text += pieces[random() % std::size(pieces)];
    return text;
}

/// diff pairs lines so that most of them agree; where it would rather pair blank lines than others it prints more than there is. Texts
/// whose lines that are not blank agree are therefore judged by whether they do; all others by diff.
TEST(TextDifference, SaysWhatDiffSays) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("text_difference_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    std::mt19937 random(7);
    int same = 0;
    for (int i = 0; i < 300; ++i) {
        const std::string a = random_text(random), b = i % 3 == 0 ? a + random_text(random).substr(0, 2) : random_text(random);
        std::ofstream(folder / "a", std::ios::binary) << a;
        std::ofstream(folder / "b", std::ios::binary) << b;
        const bool equal =
            std::system(("diff -bB " + (folder / "a").string() + " " + (folder / "b").string() + " > /dev/null").c_str()) == 0;
        same += equal;
        const bool lines_agree = compared_lines(a) == compared_lines(b);
        if (equal || !lines_agree) {
            EXPECT_EQ(!first_difference(a, b, 0.0), equal) << '"' << a << "\" and \"" << b << '"';
        }
    }
    EXPECT_GT(same, 30);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rt::text_difference_test
