#include "core/source.h"

#include <gtest/gtest.h>

namespace rt::source_test {
namespace {

Sources one_file(std::string text) {
    Sources sources;
    sources.add({"scene.pov", std::move(text)});
    return sources;
}

TEST(Sources, LinesAndColumnsCountFromOne) {
    const Sources sources = one_file("ab\n\ncd");
    EXPECT_EQ(sources.locate(0, 0).line, 1u);
    EXPECT_EQ(sources.locate(0, 0).column, 1u);
    EXPECT_EQ(sources.locate(0, 2).line, 1u);  // the newline belongs to the line it ends
    EXPECT_EQ(sources.locate(0, 2).column, 3u);
    EXPECT_EQ(sources.locate(0, 3).line, 2u);
    EXPECT_EQ(sources.locate(0, 5).line, 3u);
    EXPECT_EQ(sources.locate(0, 5).column, 2u);
    EXPECT_EQ(sources.locate(0, 999).column, 3u);  // past the end is the end
}

TEST(Sources, DescribesWithExcerptAndCaret) {
    const Sources sources = one_file("// one\nsphere { <0, 1, 2>, 3 pigmnt { rgb 1 } }\n");
    EXPECT_EQ(sources.describe({0, 32, 38}, "Parse Error", "No matching } in 'sphere', undeclared identifier 'pigmnt' found instead"),
              "File 'scene.pov' line 2: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead\n"
              "   2 | sphere { <0, 1, 2>, 3 pigmnt { rgb 1 } }\n"
              "     |                          ^^^^^^");
}

TEST(Sources, WithoutAPlaceOnlyTheText) {
    EXPECT_EQ(Sources().describe({}, "Parse Error", "Cannot open input file."), "Parse Error: Cannot open input file.");
}

TEST(Sources, PlaceAtTheEndOfTheFile) {
    const Sources sources = one_file("sphere {");
    EXPECT_EQ(sources.describe({0, 8, 8}, "Parse Error", "x"),
              "File 'scene.pov' line 1: Parse Error: x\n   1 | sphere {\n     |         ^");
}

TEST(Sources, CarriageReturnsTabsAndControlBytesKeepTheCaretInPlace) {
    const Sources sources = one_file("\tab\x01\xc3\xa9 x\r\nnext");
    EXPECT_EQ(sources.describe({0, 7, 8}, "Parse Error", "x"), "File 'scene.pov' line 1: Parse Error: x\n   1 |  ab??? x\n     |        ^");
}

TEST(Sources, LongLinesAreCutAroundTheCaret) {
    const Sources sources = one_file(std::string(100000, 'a') + "BAD" + std::string(100000, 'b'));
    const std::string message = sources.describe({0, 100000, 100003}, "Parse Error", "x");
    EXPECT_LT(message.size(), 450u);
    const auto excerpt = message.find("   1 | ");
    const auto carets = message.find("^^^");
    ASSERT_NE(carets, std::string::npos);
    const auto caret_line = message.rfind('\n', carets) + 1;
    EXPECT_EQ(message.substr(excerpt + (carets - caret_line), 3), "BAD");
}

TEST(Sources, ASpanOverSeveralLinesIsMarkedOnItsFirst) {
    const Sources sources = one_file("abc\ndef\n");
    EXPECT_EQ(sources.describe({0, 1, 7}, "Parse Error", "x"), "File 'scene.pov' line 1: Parse Error: x\n   1 | abc\n     |  ^^");
}

}  // namespace
}  // namespace rt::source_test
