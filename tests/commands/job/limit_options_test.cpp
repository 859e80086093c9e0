// --limit NAME=N.
#include "commands/job/limit_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::limit_options_test {
namespace {

using test::run;

std::string error_of(const std::string& text) {
    ParseOptions parse;
    try {
        set_limit(parse, text);
    } catch (const OptionError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(LimitOption, TakesThousandsOfCountsAndPowersOfTwoOfBytes) {
    ParseOptions parse;
    set_limit(parse, "macro-depth=17");
    EXPECT_EQ(parse.max_macro_depth, 17u);
    set_limit(parse, "macro-depth=20k");
    EXPECT_EQ(parse.max_macro_depth, 20'000u);
    set_limit(parse, "parts=3M");
    EXPECT_EQ(parse.max_set_parts, 3'000'000u);
    set_limit(parse, "memory=2g");
    EXPECT_EQ(parse.max_memory_bytes, std::size_t{2} << 30);
    set_limit(parse, "file=64K");
    EXPECT_EQ(parse.max_file_bytes, 65'536u);
    set_limit(parse, "nesting=500");
    EXPECT_EQ(parse.max_nesting, 500);
}

TEST(LimitOption, SaysWhatIsWrong) {
    EXPECT_EQ(error_of("memory"), "--limit: expected NAME=N, not 'memory'");
    EXPECT_EQ(error_of("memry=1G"), "--limit: there is none of the name 'memry'; did you mean 'memory'?; see raytrace help limits");
    for (const char* value : {"", "0", "-1", "1.5", "1T", "1kk", "k", "99999999999999999999", "18446744073709551615G"})
        EXPECT_EQ(error_of(std::string("array=") + value),
                  std::string("--limit array: '") + value + "' is no whole number from 1 to 1000000000; k, M or G may stand behind it");
    EXPECT_EQ(error_of("file=4G"), "--limit file: '4G' is no whole number from 1 to 4294967294; k, M or G may stand behind it");
}

TEST(LimitOption, RaisesAndLowersWhatAScenesMayAskFor) {
    const test::Workplace here;
    here.write("deep.pov", "#version 3.7;\n#macro M(N) #if (N > 0) M(N - 1) #end #end\nM(100)\n");
    const test::Outcome refused = run({"deep.pov", "-W8", "-H6", "-q", "-F", "--limit", "macro-depth=50"});
    EXPECT_EQ(refused.status, 4);
    EXPECT_EQ(refused.err,
              "File 'deep.pov' line 2: Parse Error: Macros call each other more than 50 deep. --limit macro-depth=N allows more.\n"
              "   2 | #macro M(N) #if (N > 0) M(N - 1) #end #end\n"
              "     |                         ^\n");
    EXPECT_EQ(run({"deep.pov", "-W8", "-H6", "-q", "-F", "--limit", "macro-depth=50", "--limit=macro-depth=101"}).status, 0);
    EXPECT_EQ(run({"requires", "deep.pov", "--limit", "macro-depth=50"}).status, 4);
    EXPECT_EQ(run({"deep.pov", "--limit", "depth=50"}).err,
              "raytrace: --limit: there is none of the name 'depth'; see raytrace help limits\n");
}

TEST(LimitOption, TheHelpNamesEveryLimitWithItsValue) {
    EXPECT_THAT(limits_topic(), testing::HasSubstr("macro-depth          10k  macros that call each other\n"));
    EXPECT_THAT(limits_topic(), testing::HasSubstr("file                  1G  bytes of one file\n"));
    EXPECT_THAT(limits_topic(), testing::HasSubstr("memory                    bytes of the whole program: 3/4 of the machine's\n"));
}

}  // namespace
}  // namespace rt::limit_options_test
