#include "syntax/lexer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>

namespace rt::lexer_test {
namespace {

struct Scanned {
    Sources sources;
    std::vector<Token> tokens;  ///< without the end
    std::string error;
};

/// The result's tokens point into its sources.
std::unique_ptr<Scanned> scan(const std::string& text) {
    auto result = std::make_unique<Scanned>();
    result->sources.add({"t.pov", text});
    try {
        Lexer lexer(result->sources, 0);
        for (Token token;;) {
            lexer.next(token);
            if (token.kind == Token::Kind::end) break;
            result->tokens.push_back(token);
        }
    } catch (const SceneError& e) {
        result->error = e.what();
    }
    return result;
}

std::string kinds(const std::string& text) {
    std::string result;
    const auto scanned = scan(text);
    for (const Token& t : scanned->tokens) {
        switch (t.kind) {
            case Token::Kind::number:
                result += '1';
                break;
            case Token::Kind::string:
                result += 's';
                break;
            case Token::Kind::identifier:
                result += 'i';
                break;
            case Token::Kind::word:
                result += 'w';
                break;
            case Token::Kind::symbol:
                result += t.symbol;
                break;
            default:
                result += 'c';
        }
    }
    return result;
}

TEST(Words, EveryOneIsFoundAndNothingElse) {
    std::set<std::string_view> seen;
    int count = 0;
    // A loop over a plain list: five hundred expanded assertions would take a sanitizing compiler minutes.
    static constexpr Word all[] = {
#define RT_ENTRY(name) Word::name,
        RT_WORDS(RT_ENTRY)
#undef RT_ENTRY
    };
    for (const Word word : all) {
        EXPECT_EQ(find_word(text(word)), word) << text(word);
        EXPECT_NE(text(word).back(), '_');
        EXPECT_TRUE(seen.insert(text(word)).second) << text(word);
        ++count;
    }
    EXPECT_EQ(count, 496);
    EXPECT_EQ(text(Word::union_), "union");
    EXPECT_EQ(find_word("default"), Word::default_);
    EXPECT_EQ(text(Word::none), "");
    for (const char* name : {"", "Sphere", "spher", "spheres", "union_", "sphere ", "clock_delta", "image_width", "foo", "_"})
        EXPECT_EQ(find_word(name), Word::none) << name;
}

TEST(Lexer, EveryKindOfToken) {
    EXPECT_EQ(kinds("sphere { <0, 1.5, foo_2>, \"a\" } #if(x!=1) a<=b>=c"), "w{<1,1,i>,s}#w(wN1)iLiGi");
    EXPECT_EQ(kinds("(){}[]<>,;+-*/=!&|?:."), "(){}[]<>,;+-*/=!&|?:.");
    EXPECT_EQ(kinds("@ ~ $ % \\ ' ` ^"), "@~$%\\'`^");
    EXPECT_EQ(kinds(""), "");
    EXPECT_EQ(kinds(" \t\r\n\v\f"), "");
}

TEST(Lexer, SpansAreTheBytesOfTheToken) {
    const std::string text = "sphere/*c*/{ 12.5e3 \"st\" Name }";
    const auto scanned = scan(text);
    std::vector<std::string> pieces;
    for (const Token& t : scanned->tokens) pieces.push_back(text.substr(t.span.begin, t.span.end - t.span.begin));
    EXPECT_THAT(pieces, testing::ElementsAre("sphere", "{", "12.5e3", "\"st\"", "Name", "}"));
    EXPECT_EQ(scanned->tokens[3].text, "st");
    EXPECT_EQ(scanned->tokens[4].text, "Name");
}

TEST(Lexer, NumbersOfEveryForm) {
    const std::vector<std::pair<const char*, double>> forms{
        {"0", 0},           {"007", 7},       {".5", .5},          {"1.", 1},
        {"1e-3", 1e-3},     {".5e1", 5},      {"1.e2", 100},       {"1E+2", 100},
        {"1e", 1},          {"1e+", 1},       {"0.50001", .50001}, {"1e-400", 0},
        {"5e-324", 5e-324}, {"1e308", 1e308}, {"0.1", .1},         {"9007199254740993", 9007199254740992.0}};
    for (const auto& [text, value] : forms) {
        const auto scanned = scan(text);
        ASSERT_EQ(scanned->tokens.size(), 1u) << text;
        EXPECT_EQ(scanned->tokens[0].number, value) << text;
    }
    EXPECT_EQ(scan("1e999")->tokens[0].number, std::numeric_limits<double>::infinity());
    EXPECT_EQ(scan("1" + std::string(400, '0'))->tokens[0].number, std::numeric_limits<double>::infinity());
    EXPECT_EQ(scan("." + std::string(400, '0') + "1")->tokens[0].number, 0.0);
}

TEST(Lexer, DecimalsOfAnyLengthAreTheNearestDoubles) {
    std::mt19937 random(3);
    for (int i = 0; i < 30000; ++i) {
        std::string text;
        const auto digits = static_cast<int>(random() % 22 + 1);
        for (int d = 0; d < digits; ++d) text += static_cast<char>('0' + random() % 10);
        text.insert(random() % (text.size() + 1), random() % 4 == 0 ? "" : ".");
        const auto scanned = scan(text);
        ASSERT_EQ(scanned->tokens.size(), 1u) << text;
        ASSERT_EQ(scanned->tokens[0].number, std::strtod(text.c_str(), nullptr)) << text;
        double value = 0.0;
        Lexer lexer(scanned->sources, 0);
        ASSERT_EQ(lexer.scan_plain_value({&value, 1}, false), 0u) << "the end may not be the end of the expression";
        scanned->sources.add({"u.pov", "-" + text + " x"});
        Lexer plain(scanned->sources, 1);
        ASSERT_EQ(plain.scan_plain_value({&value, 1}, false), 1u) << text;
        ASSERT_EQ(value, -std::strtod(text.c_str(), nullptr)) << text;
    }
}

/// How many components the fast path reads, and what is left of the text.
std::string plain(const std::string& text, std::size_t most, bool condition = false) {
    Sources sources;
    sources.add({"t.pov", text});
    Lexer lexer(sources, 0);
    std::array<double, 5> v{};
    const std::size_t size = lexer.scan_plain_value(std::span(v).first(most), condition);
    return fmt::format("{}:{}", size, text.substr(lexer.position()));
}

TEST(Lexer, PlainValuesAreReadAtOnce) {
    EXPECT_EQ(plain(" < 1, -2.5 ,3e2 >\n}", 3), "3:\n}");
    EXPECT_EQ(plain("<1,2> <3", 3), "2: <3");
    EXPECT_EQ(plain("<1,2,3,4,.5>pigment", 5), "5:pigment");
    EXPECT_EQ(plain("-7, 8", 1), "1:, 8");
    EXPECT_EQ(plain("4 {", 3), "1: {");
}

TEST(Lexer, WhatMayGoOnIsNoPlainValue) {
    for (const std::string text :
         {"<1,2,3> * 2",   "<1,2,3>.x",   "<1 2 3> }",   "<1,2,3",   "<1,2,a> }", "<1> }", "<> }", "< }", "<1,2,3,4> }",
          "<1,2,3> /**/}", "1 + 2",       "1.2.3 }",     "1e }",     "- 1 }",     "1x }",  "1",    "",    " ",
          "x }",           "<1,2,- 3> }", "<1,2,3.x> }", "1 ? 2 : 3"})
        EXPECT_EQ(plain(text, 3), "0:" + text);
    EXPECT_EQ(plain("1 < 2", 5, true), "0:1 < 2");
    EXPECT_EQ(plain("<1,2,3> <", 5, true), "0:<1,2,3> <");
    EXPECT_EQ(plain("<1,2,3> <", 3), "3: <");
    EXPECT_EQ(plain("<1,2,3> x", 1), "0:<1,2,3> x");
}

TEST(Lexer, WhereANumberEnds) {
    EXPECT_EQ(kinds("0.50001 0"), "11");
    EXPECT_EQ(kinds("1-2"), "1-1");
    EXPECT_EQ(kinds("0x10"), "1i");
    EXPECT_EQ(kinds("1f"), "1i");
    EXPECT_EQ(kinds("1.x"), "1w");
    EXPECT_EQ(kinds("x.5"), "w1");
    EXPECT_EQ(kinds("A.x"), "i.w");
}

TEST(Lexer, CommentsNestAndAreNoTokens) {
    EXPECT_EQ(kinds("a /* b /* c */ d */ e"), "ii");
    EXPECT_EQ(kinds("a // b /* c\nd"), "ii");
    EXPECT_EQ(kinds("a /* // */ b"), "ii");
    EXPECT_EQ(kinds("a /**/ b /***/ c"), "iii");
    EXPECT_EQ(kinds("a // no newline at the end"), "i");
    EXPECT_EQ(kinds("a\r\nb//\r\nc"), "iii");
    EXPECT_EQ(kinds("// \xff\xfe bytes of any kind \x01\na"), "i");
}

TEST(Lexer, DirectiveCommentsAreTokensWithThisExactPrefixOnly) {
    const auto scanned = scan("a //! raytrace: D=ggx alpha=0.5\r\nb");
    ASSERT_EQ(scanned->tokens.size(), 3u);
    EXPECT_EQ(scanned->tokens[1].kind, Token::Kind::choice);
    EXPECT_EQ(scanned->tokens[1].text, " D=ggx alpha=0.5");
    EXPECT_EQ(kinds("//! raytrace:"), "c");
    for (const char* other : {"//!raytrace: a=b", "// ! raytrace: a=b", "//! raytracer: a=b", "//! Raytrace: a=b", "///! raytrace: a=b"})
        EXPECT_EQ(kinds(other), "") << other;
}

TEST(Lexer, CommentsThatAreAlmostDirectivesAreTold) {
    const auto told = [](const std::string& text) {
        Sources sources;
        const std::uint32_t file = sources.add({"a.pov", text});
        std::string found;
        const Lexer::NearChoice sink = [&](const Span& place) { found += "[" + text.substr(place.begin, place.end - place.begin) + "]"; };
        Lexer lexer(sources, file, 0, Span::none, &sink);
        for (Token token; lexer.next(token), token.kind != Token::Kind::end;) continue;
        return found;
    };
    EXPECT_EQ(told("a //!raytrace: a=b\r\nb"), "[//!raytrace:]");
    EXPECT_EQ(told("//! raytrace :"), "[//! raytrace :]");
    EXPECT_EQ(told("//! Raytrace:"), "[//! Raytrace:]");
    EXPECT_EQ(told("//!\traytrace a=b"), "[//!\traytrace]");
    EXPECT_EQ(told("// raytrac: a=b\n//!RAYTRACES:"), "[// raytrac:][//!RAYTRACES:]");
    for (const char* prose :
         {"//! raytrace: a=b", "//", "//!", "// raytrace", "//! raytrace", "//! raytracing: a=b", "// raytrace a=b", "//! a raytrace: b=c",
          "// raytrace: a b=c", "/* //!raytrace: a=b */", "\"//!raytrace: a=b\"", "//! ray", "//! raytrace this: a=b"})
        EXPECT_EQ(told(prose), "") << prose;
}

TEST(Lexer, StringsKeepTheirEscapesRaw) {
    EXPECT_EQ(scan(R"("a\"b\\")")->tokens[0].text, R"(a\"b\\)");
    EXPECT_EQ(scan("\"two\nlines\"")->tokens[0].text, "two\nlines");
    EXPECT_EQ(scan("\"\xc3\xa9\"")->tokens[0].text, "\xc3\xa9");
    EXPECT_EQ(kinds("\"a\"\"b\""), "ss");
}

TEST(Lexer, ByteOrderMarkIsSkippedAtTheStartOnly) {
    EXPECT_EQ(kinds("\xEF\xBB\xBFsphere"), "w");
    EXPECT_THAT(scan("a \xEF\xBB\xBF")->error, testing::HasSubstr("Illegal character in input file, value is ef."));
}

TEST(Lexer, WhatIsNoTokenIsAnErrorWithItsPlace) {
    EXPECT_EQ(scan("a\n /* b /* c */ ")->error,
              "File 't.pov' line 2: Parse Error: No */ closing comment found.\n"
              "   2 |  /* b /* c */ \n"
              "     |  ^^");
    EXPECT_EQ(scan("a\n\"abc\nsphere")->error,
              "File 't.pov' line 2: Parse Error: No end quote for string.\n"
              "   2 | \"abc\n"
              "     | ^");
    EXPECT_EQ(scan("\"abc\\")->error,
              "File 't.pov' line 1: Parse Error: No end quote for string.\n"
              "   1 | \"abc\\\n"
              "     | ^");
    EXPECT_EQ(scan("a 1..2")->error,
              "File 't.pov' line 1: Parse Error: Unexpected additional '.' in floating-point number\n"
              "   1 | a 1..2\n"
              "     |   ^^^");
    EXPECT_THAT(scan("1e5.5")->error, testing::HasSubstr("Unexpected additional '.' in floating-point number"));
    EXPECT_EQ(scan("a \xe9")->error,
              "File 't.pov' line 1: Parse Error: Illegal character in input file, value is e9.\n"
              "   1 | a ?\n"
              "     |   ^");
    EXPECT_EQ(scan(std::string("a \0 b", 5))->error,
              "File 't.pov' line 1: Parse Error: Illegal character in input file, value is 00.\n"
              "   1 | a ? b\n"
              "     |   ^");
    EXPECT_THAT(scan("\x89PNG\r\n\x1a\n")->error, testing::HasSubstr("value is 89."));
}

TEST(Lexer, RestartsAnywhere) {
    Sources sources;
    sources.add({"t.pov", "a b c d"});
    Lexer lexer(sources, 0);
    Token token;
    lexer.next(token);
    const std::uint32_t place = lexer.position();
    for (const char* name : {"b", "c", "d"}) {
        lexer.next(token);
        EXPECT_EQ(token.text, name);
    }
    lexer.next(token);
    EXPECT_EQ(token.kind, Token::Kind::end);
    lexer.next(token);
    EXPECT_EQ(token.kind, Token::Kind::end);
    lexer.seek(place);
    lexer.next(token);
    EXPECT_EQ(token.text, "b");

    Lexer part(sources, 0, 2, 5);  // "b c"
    part.next(token);
    part.next(token);
    EXPECT_EQ(token.text, "c");
    part.next(token);
    EXPECT_EQ(token.kind, Token::Kind::end);
}

}  // namespace
}  // namespace rt::lexer_test
