// Texts of any bytes: where they may be cut, what of them is UTF-8, what a line may hold.
#include <gtest/gtest.h>

#include "core/utf8.h"

namespace rt::utf8_test {
namespace {

constexpr std::string_view a_umlaut = "\xC3\xA4", euro = "\xE2\x82\xAC", smile = "\xF0\x9F\x98\x80", replacement = "\xEF\xBF\xBD";

TEST(Utf8, CharactersAreThoseOfTheStandard) {
    EXPECT_EQ(utf8_character("a"), 1u);
    EXPECT_EQ(utf8_character(std::string_view("\0", 1)), 1u);
    EXPECT_EQ(utf8_character(a_umlaut), 2u);
    EXPECT_EQ(utf8_character(euro), 3u);
    EXPECT_EQ(utf8_character(smile), 4u);
    for (const char* last_of_its_length : {"\x7F", "\xDF\xBF", "\xED\x9F\xBF", "\xEF\xBF\xBF", "\xF4\x8F\xBF\xBF"})
        EXPECT_EQ(utf8_character(last_of_its_length), std::string_view(last_of_its_length).size());
    for (const char* none : {"", "\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3(", "\xE0\x9F\xBF", "\xE2\x82", "\xED\xA0\x80",
                             "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
        EXPECT_EQ(utf8_character(none), 0u) << none;
}

TEST(Utf8, NoCharacterIsCutInTwo) {
    const std::string text = "x" + std::string(a_umlaut) + std::string(euro) + std::string(smile);  // begin at 1, 3, 6; the end is 10
    const std::size_t ends[] = {0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10, 10};
    for (std::size_t most = 0; most < std::size(ends); ++most) EXPECT_EQ(whole_characters(text, most), text.substr(0, ends[most])) << most;
    EXPECT_EQ(whole_characters(text.substr(0, 9), 8), text.substr(0, 6)) << "the rest of it was never read";
}

TEST(Utf8, AShortenedTextTellsWhatIsMissing) {
    EXPECT_EQ(shortened("a\xC3\xA4z", 4), "a\xC3\xA4z");
    EXPECT_EQ(shortened("a\xC3\xA4z", 3), "a\xC3\xA4… (1 bytes more)");
    EXPECT_EQ(shortened("a\xC3\xA4z", 2), "a… (3 bytes more)");
}

TEST(Utf8, WhatIsNoneIsCutAnywhere) {
    EXPECT_EQ(whole_characters("\xFF\xFF\xFF", 2), "\xFF\xFF");
    EXPECT_EQ(whole_characters("\x80\x80\x80\x80\x80\x80", 5), "\x80\x80\x80\x80\x80");
    EXPECT_EQ(whole_characters("a\x80\x80", 2), "a\x80");
    EXPECT_EQ(whole_characters("\x80\x80", 1), "\x80");
    EXPECT_EQ(whole_characters("", 0), "");
}

TEST(Utf8, TextsAreItWhole) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8(std::string("a\0b", 3) + std::string(smile)));
    EXPECT_FALSE(is_utf8("a\xFF"));
    EXPECT_FALSE(is_utf8("\xE2\x82"));
}

TEST(Utf8, BytesThatAreNoneAreReplaced) {
    EXPECT_EQ(valid_utf8("a\n" + std::string(smile)), "a\n" + std::string(smile));
    EXPECT_EQ(valid_utf8("a\xFFz"), "a" + std::string(replacement) + "z");
    EXPECT_EQ(valid_utf8("a\xE2\x82"), "a" + std::string(replacement) + std::string(replacement));
    EXPECT_EQ(valid_utf8("\xC3\xE2\x82\xAC"), std::string(replacement) + std::string(euro));
}

TEST(Utf8, ALineHoldsNothingThatATerminalObeys) {
    EXPECT_EQ(one_line("Zo\xC3\xAB \xE6\x97\xA5"), "Zo\xC3\xAB \xE6\x97\xA5");
    EXPECT_EQ(one_line("a\033[31mb\r\nc\x7F\td"), "a?[31mb??c??d");
    EXPECT_EQ(one_line("\xC2\x9B"
                       "2J"),
              "?2J")
        << "the control sequence introducer as one character";
    EXPECT_EQ(one_line("\x9B"
                       "2J\xFF"),
              "?2J?");
    EXPECT_EQ(one_line("a\xE2\x80\xA8z\xE2\x80\xAEz\xE2\x81\xA6z\xD8\x9Cz"), "a?z?z?z?z") << "separators and directions";
    EXPECT_EQ(one_line("\xC2\xA0\xE2\x80\xA7\xE2\x80\xAF"), "\xC2\xA0\xE2\x80\xA7\xE2\x80\xAF") << "their neighbours";
}

}  // namespace
}  // namespace rt::utf8_test
