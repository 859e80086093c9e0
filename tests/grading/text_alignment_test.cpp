// Texts side by side: what is paired, what stands alone, and which fields of a pair are marked.
#include "grading/text_alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace rt::text_alignment_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "1=1", "2!3(2,4)", "4<" and ">5": same, a pair with its differing fields, expected alone, actual alone.
std::vector<std::string> shape(std::string_view expected, std::string_view actual, double tolerance = 0.0) {
    std::vector<std::string> all;
    for (const AlignedLine& line : aligned_lines(expected, actual, tolerance)) {
        if (!line.actual_number)
            all.push_back(fmt::format("{}<", line.expected_number));
        else if (!line.expected_number)
            all.push_back(fmt::format(">{}", line.actual_number));
        else if (line.differing.empty())
            all.push_back(fmt::format("{}={}", line.expected_number, line.actual_number));
        else
            all.push_back(fmt::format("{}!{}({})", line.expected_number, line.actual_number, fmt::join(line.differing, ",")));
    }
    return all;
}

TEST(AlignedLines, OfTheSameTextAreAllTheSame) { EXPECT_THAT(shape("a 1\nb 2\n", "a  1 \n\nb 2"), ElementsAre("1=1", "2=3")); }

TEST(AlignedLines, MarkTheFieldsThatDiffer) {
    EXPECT_THAT(shape("T = 1.0 2.0\n", "T = 1.5 2.0\n"), ElementsAre("1!1(3)"));
    EXPECT_THAT(shape("T = 1.0 2.0\n", "T = 1.0\n"), ElementsAre("1!1(4)"));
}

TEST(AlignedLines, AMissingLineShiftsNoOther) {
    EXPECT_THAT(shape("a 1\nb 2\nc 3\n", "a 1\nc 3\n"), ElementsAre("1=1", "2<", "3=2"));
    EXPECT_THAT(shape("a 1\nc 3\n", "a 1\nb 2\nc 3\n"), ElementsAre("1=1", ">2", "2=3"));
}

TEST(AlignedLines, AChangedLineBesideAMissingOneFindsItsPartner) {
    EXPECT_THAT(shape("k 0\nray 1 2 3\nhit 4 5 6\nend\n", "k 1\nhit 4 5 7\nend\n"), ElementsAre("1!1(2)", "2<", "3!2(4)", "4=3"));
}

TEST(AlignedLines, NumbersWithinTheToleranceAreTheSame) {
    EXPECT_THAT(shape("{1.0000 2}\n", "{1.0001 2}\n", 1e-3), ElementsAre("1=1"));
    EXPECT_THAT(shape("{1.0000 2}\n", "{1.0001 2}\n", 1e-5), ElementsAre("1!1(1)"));
}

TEST(AlignedLines, IndentationIsMarkedAtTheFirstField) { EXPECT_THAT(shape("a b\n", "  a b\n"), ElementsAre("1!1(1)")); }

TEST(AlignedLines, OfNothing) {
    EXPECT_THAT(shape("", ""), IsEmpty());
    EXPECT_THAT(shape("a\n", ""), ElementsAre("1<"));
    EXPECT_THAT(shape("", "a\n"), ElementsAre(">1"));
}

TEST(AlignedLines, OfLongTextsArePairedByTheirOrder) {
    std::string expected, actual;
    for (int i = 0; i < 400; ++i) expected += fmt::format("e {}\n", i), actual += fmt::format("a {}\n", i);
    actual += "last\n";
    const std::vector<AlignedLine> lines = aligned_lines(expected, actual, 0.0);
    ASSERT_EQ(lines.size(), 401u);
    EXPECT_EQ(lines[399].expected_number, 400u);
    EXPECT_THAT(lines[399].differing, ElementsAre(1));
    EXPECT_EQ(lines[400].expected_number, 0u);
}

}  // namespace
}  // namespace rt::text_alignment_test
