// INI files: settings, switches, comments, sections.
#include <gtest/gtest.h>

#include "commands/job/povray_syntax.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt {
namespace {

using Words = std::vector<std::string>;

Translation translate(const Words& words) {
    const OwnOptions own{.takes_value = [](const std::string& word) { return word == "--define"; },
                         .long_names = {"--define", "--width"},
                         .try_out =
                             [](const Words& option) {
                                 if (option.back().ends_with("=x")) throw OptionError("'x' is no number");
                             }};
    return translate_povray_syntax(words, own);
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
    here.write("there.ini", "; first\nInclude_Ini=back.ini\n");
    here.write("back.ini", "Width=1\n./there.ini\n");
    here.write("sections.ini", "[one]\nWidth=1\nInclude_Ini=sections.ini[two]\n[two]\nHeight=2\n");
    EXPECT_EQ(translate({"a.ini"}).words, (Words{"--width=5"}));
    EXPECT_EQ(translate({"b.ini", "b.ini"}).words, (Words{"--width=5", "--width=5"}));
    EXPECT_EQ(translate({"sections.ini[one]"}).words, (Words{"--width=1", "--height=2"}));
    EXPECT_EQ(error_of({"loop.ini"}), "File 'loop.ini' line 1: INI file 'loop.ini' includes itself");
    EXPECT_EQ(error_of({"there.ini"}), "File 'back.ini' line 2: INI file './there.ini' includes itself");
}

TEST(Ini, FilesThatIncludeEachOtherManyTimesAreRefusedBeforeTheyAreAllRead) {
    const test::Workplace here;
    for (int i = 0; i < 12; ++i) {
        const std::string next = "Include_Ini=" + std::to_string(i + 1) + ".ini\n";
        here.write(std::to_string(i) + ".ini", next + next + next + next);
    }
    here.write("12.ini", "Width=5\n");
    EXPECT_NE(error_of({"0.ini"}).find("is one more than 64 to be read"), std::string::npos);
}

TEST(Ini, MistakesCarryTheirPlace) {
    const test::Workplace here;
    here.write("a.ini", "Width=5\nHieght=7\n");
    EXPECT_EQ(error_of({"a.ini"}), "File 'a.ini' line 2: unknown setting 'Hieght'; did you mean 'Height'?");
    EXPECT_EQ(error_of({"none.ini"}), "cannot open INI file 'none.ini'");
    here.write("value.ini", "Width=5\n\nHeight=x\nWidth=7\n");
    here.write("outer.ini", "Include_Ini=value.ini\n");
    EXPECT_EQ(error_of({"value.ini"}), "File 'value.ini' line 3: 'x' is no number");
    EXPECT_EQ(error_of({"outer.ini"}), "File 'value.ini' line 3: 'x' is no number");
    here.write("ours.ini", "--define=x\n");
    EXPECT_EQ(error_of({"ours.ini"}), "File 'ours.ini' line 1: 'x' is no number");
}

// POV-Ray 3.7 takes none of these lines.
TEST(Ini, ALineWithoutEqualsSignSaysWhatIsMissing) {
    const test::Workplace here;
    const std::vector<std::pair<std::string, std::string>> lines{
        {"Width 8", "no '=' behind 'Width': expected Width=value"},
        {"display", "no '=' behind 'display': expected Display=value"},
        {"Widht: 8", "expected Name=value, a switch (+W640) or a scene (NAME.pov), not 'Widht:'; did you mean 'Width'?"},
        {"+H6 W8", "expected Name=value, a switch (+W640) or a scene (NAME.pov), not 'W8'"},
        {"// text", "expected Name=value, a switch (+W640) or a scene (NAME.pov), not '//'"},
    };
    for (const auto& [line, text] : lines) {
        here.write("a.ini", "Height=6\n" + line + "\n");
        EXPECT_EQ(error_of({"a.ini"}), "File 'a.ini' line 2: " + text);
    }
}

// POV-Ray 3.7 takes all of these lines.
TEST(Ini, ScenesOptionsAndCommentsNeedNoEqualsSign) {
    const test::Workplace here;
    here.write("a.ini",
               "# a comment\n"
               "\"my scene.pov\" +W8 # behind\n"
               "+I\"my other.POV\" +H6\n"
               "other.POV\n");
    EXPECT_EQ(translate({"a.ini"}).words, (Words{"my scene.pov", "--width=8", "--input=my other.POV", "--height=6", "other.POV"}));
    here.write("b.ini", "--define a=1 -ss=2\n");
    EXPECT_EQ(translate({"b.ini"}).words, (Words{"--define", "a=1", "--ss=2"}));
}

TEST(Ini, AByteOrderMarkIsNoPartOfTheFirstLine) {
    const test::Workplace here;
    const std::string mark = "\xEF\xBB\xBF";
    here.write("a.ini", mark + "Width=1\n[small]\nWidth=2\n");
    here.write("b.ini", mark + "[small]\nWidth=2\n");
    here.write("c.ini", "Width=1\n" + mark + "Width=2\n");
    EXPECT_EQ(translate({"a.ini"}).words, (Words{"--width=1"}));
    EXPECT_EQ(translate({"b.ini[small]"}).words, (Words{"--width=2"}));
    EXPECT_TRUE(error_of({"c.ini"}).starts_with("File 'c.ini' line 2: unknown setting"));
}

TEST(Ini, MessagesOfFilesThatAreNoTextAreFitToPrint) {
    const test::Workplace here;
    here.write("a.ini", std::string("\x7f"
                                    "ELF\x02\x1b[31m\0\0z\n",
                                    13));
    EXPECT_EQ(error_of({"a.ini"}), "File 'a.ini' line 1: expected Name=value, a switch (+W640) or a scene (NAME.pov), not '?ELF??[31m??z'");
    here.write("b.ini", "Wid\x1bth=" + std::string(1000, 'x'));
    EXPECT_EQ(error_of({"b.ini"}), "File 'b.ini' line 1: unknown setting 'Wid?th'; did you mean 'Width'?");
    here.write("c.ini", std::string(1000, 'y'));
    EXPECT_LT(error_of({"c.ini"}).size(), 500u);
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
