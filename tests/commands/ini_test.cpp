// INI files: settings, switches, comments, sections.
#include <gtest/gtest.h>

#include "commands/povray_syntax.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt {
namespace {

using Words = std::vector<std::string>;

Translation translate(const Words& words) {
    return translate_povray_syntax(words, [](const std::string& word) { return word == "--define"; });
}

std::string error_of(const Words& words) {
    try {
        translate(words);
    } catch (const OptionError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Ini, SettingsSwitchesAndComments) {
    const test::Workplace here;
    here.write("a.ini",
               "; a comment\n"
               "Input_File_Name = \"my scene.pov\" ; behind a value\n"
               "\r\n"
               "Width=64\r\n"
               "+H48 -J\n"
               "Declare=s=\"a;b\"\n"
               "Display=on\n"
               "Verbose=off\n");
    const Translation t = translate({"a.ini"});
    EXPECT_EQ(t.words,
              (Words{"--input=my scene.pov", "--width=64", "--height=48", "--jitter=off", "--define=s=\"a;b\"", "--progress=off"}));
    EXPECT_EQ(t.ignored, (Words{"Display=on"}));
}

TEST(Ini, OnlyTheChosenSectionCounts) {
    const test::Workplace here;
    here.write("a.ini", "Width=1\n[small]\nWidth=2\n[Big one]\nWidth=3\n");
    EXPECT_EQ(translate({"a.ini"}).words, (Words{"--width=1"}));
    EXPECT_EQ(translate({"a.ini[small]"}).words, (Words{"--width=1", "--width=2"}));
    EXPECT_EQ(translate({"a.ini[big ONE]"}).words, (Words{"--width=1", "--width=3"}));
    EXPECT_EQ(error_of({"a.ini[none]"}), "INI file 'a.ini' has no section [none]");
}

TEST(Ini, OneFileMayIncludeAnotherButNotItself) {
    const test::Workplace here;
    here.write("a.ini", "Include_Ini=b.ini\n");
    here.write("b.ini", "Width=5\n");
    here.write("loop.ini", "Include_Ini=loop.ini\n");
    EXPECT_EQ(translate({"a.ini"}).words, (Words{"--width=5"}));
    EXPECT_NE(error_of({"loop.ini"}).find("INI file 'loop.ini' is nested too deeply"), std::string::npos);
}

TEST(Ini, MistakesCarryTheirPlace) {
    const test::Workplace here;
    here.write("a.ini", "Width=5\nHieght=7\n");
    EXPECT_EQ(error_of({"a.ini"}), "File 'a.ini' line 2: unknown setting 'Hieght'; did you mean 'Height'?");
    EXPECT_EQ(error_of({"none.ini"}), "cannot open INI file 'none.ini'");
}

TEST(Ini, AFolderIsNoIniFile) {
    const test::Workplace here;
    EXPECT_EQ(error_of({"/tmp/.ini"}), "cannot open INI file '/tmp/.ini'");
}

TEST(Translation, WordsThatBelongToAnOptionStay) {
    EXPECT_EQ(translate({"--define", "Width=3", "Width=4"}).words, (Words{"--define", "Width=3", "--width=4"}));
}

TEST(Translation, NothingIsTranslatedBehindTwoDashes) {
    EXPECT_EQ(translate({"+W4", "--", "+W5", "a.ini"}).words, (Words{"--width=4", "--", "+W5", "a.ini"}));
}

}  // namespace
}  // namespace rt
