// What a picture's format cannot hold is said, and what is done instead.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::format_limits_test {
namespace {

using test::Outcome;
using test::run;

struct Loss {
    std::vector<std::string> words;
    std::string picture;
    std::vector<std::string> warnings;
};
void PrintTo(const Loss& loss, std::ostream* out) { *out << fmt::format("{}", fmt::join(loss.words, " ")); }

class FormatLimits : public testing::TestWithParam<Loss> {};

TEST_P(FormatLimits, AreSaidOnce) {
    const test::Workplace here;
    here.write("a.pov", test::small_scene);
    std::vector<std::string> words{"a.pov", "--size=8x6"};
    words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::string expected;
    for (const std::string& warning : GetParam().warnings) expected += fmt::format("raytrace: warning: {}\n", warning);
    EXPECT_EQ(outcome.err, expected);
    EXPECT_TRUE(here.has(GetParam().picture));
    words.push_back("-q");
    EXPECT_EQ(run(words).err, "");
}

INSTANTIATE_TEST_SUITE_P(
    All, FormatLimits,
    testing::Values(
        Loss{{"--bits=16", "-o", "a.jpg"}, "a.jpg", {"jpeg holds 8 bits per channel, not 16: 8 are written"}},
        Loss{{"+FJ16", "+UA"},
             "a.jpg",
             {"jpeg holds 8 bits per channel, not 16: 8 are written", "jpeg holds no alpha channel: the picture is written without one"}},
        Loss{{"--output-alpha=on", "-o", "a.ppm"}, "a.ppm", {"ppm holds no alpha channel: the picture is written without one"}},
        Loss{{"+FN12"}, "a.png", {"png holds 8 or 16 bits per channel, not 12: 16 are written"}},
        Loss{{"+FN5"}, "a.png", {"png holds 8 or 16 bits per channel, not 5: 8 are written"}},
        Loss{{"Bits_Per_Color=32"}, "a.png", {"png holds 8 or 16 bits per channel, not 32: 16 are written"}},
        Loss{{"--bits=8", "-o", "a.exr"}, "a.exr", {"exr holds 16 or 32 bits per channel, not 8: 16 are written"}},
        Loss{{"--dither=on", "-o", "a.exr"}, "a.exr", {"exr holds linear light: it is not dithered"}},
        Loss{{"--file-gamma=1.8", "-o", "a.hdr"}, "a.hdr", {"hdr holds linear light: the file gamma is left out"}},
        // What can be held is not worth a word.
        Loss{{"--bits=16", "--output-alpha=on"}, "a.png", {}}, Loss{{"--bits=32", "--output-alpha=on", "-o", "a.exr"}, "a.exr", {}},
        Loss{{"-o", "a.exr"}, "a.exr", {}}, Loss{{"-o", "a.hdr"}, "a.hdr", {}}, Loss{{"--bits=8", "-o", "a.jpg"}, "a.jpg", {}},
        Loss{{"--bits=16", "+UA", "-o", "a.tif"}, "a.tif", {}}, Loss{{"+UA", "+FT"}, "a.tga", {}}));

TEST(FormatLimitsOf, NobodyMindsThemWhereNothingIsWritten) {
    const test::Workplace here;
    here.write("a.pov", test::small_scene);
    EXPECT_EQ(run({"a.pov", "--size=8x6", "--bits=12", "+UA", "-F"}).err, "");
}

/// Single precision keeps what half precision rounds; the value is 1/3 of linear light, in front of which nothing stands.
TEST(FormatLimitsOf, OpenExrHoldsHalfAndSinglePrecision) {
    const test::Workplace here;
    here.write("b.pov", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 1/3 }\n");
    const auto value = [&](const char* bits) {
        EXPECT_EQ(run({"b.pov", "--size=2x2", "--bits", bits, "-o", "b.exr"}).status, 0);
        return read_image("b.exr").values[0];
    };
    EXPECT_EQ(value("16"), 0.333251953125f);  // 1365 / 4096, the nearest half
    EXPECT_EQ(value("32"), 1.0f / 3.0f);
}

}  // namespace
}  // namespace rt::format_limits_test
