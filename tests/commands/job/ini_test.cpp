// INI files: settings, switches, comments, sections.
#include <gtest/gtest.h>

#include <cstdlib>

#include "commands/job/povray_settings.h"
#include "commands/job/povray_syntax.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::ini_test {
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

// As POV-Ray 3.7 reads it.
TEST(Ini, ASectionsLineMayGoOn) {
    const test::Workplace here;
    here.write("a.ini", "Width=1\n [small] ; less\nWidth=2\n[large]Width=3\n[]\nWidth=4\n[small] Height=5 # more\n");
    EXPECT_EQ(translate({"a.ini[small]"}).words, (Words{"--width=1", "--width=2", "--height=5"}));
    EXPECT_EQ(translate({"a.ini[large]"}).words, (Words{"--width=1", "--width=3"}));
    EXPECT_EQ(translate({"a.ini"}).words, (Words{"--width=1"}));
    here.write("b.ini", "[small\nWidth=2\n");
    EXPECT_EQ(error_of({"b.ini"}), "File 'b.ini' line 1: expected Name=value, a switch (+W640) or a scene (NAME.pov), not '[small'");
}

TEST(Ini, TheEndingMayBeLeftOutWhereNoSceneHasTheName) {
    const test::Workplace here;
    here.write("a.ini", "Width=1\n[small]\nWidth=2\n");
    EXPECT_EQ(translate({"a"}).words, (Words{"--width=1"}));
    EXPECT_EQ(translate({"a[small]"}).words, (Words{"--width=1", "--width=2"}));
    EXPECT_EQ(translate({"b", "b[small]"}).words, (Words{"b", "b[small]"}));
    here.write("a.pov", "");
    EXPECT_EQ(translate({"a"}).words, (Words{"a"}));
}

TEST(Ini, SeveralFilesAndSwitchesCountInTheirOrder) {
    const test::Workplace here;
    here.write("a.ini", "Width=1\nHeight=1\n");
    here.write("b.ini", "Width=2\n");
    EXPECT_EQ(translate({"a.ini", "+W7", "b.ini"}).words, (Words{"--width=1", "--height=1", "--width=7", "--width=2"}));
}

// As in POV-Ray 3.7, the last scene counts.
TEST(Ini, ASceneNamedBehindTheFileReplacesTheFiles) {
    const test::Workplace here;
    here.write("a.ini", "Input_File_Name=a.pov\nWidth=1\n");
    EXPECT_EQ(translate({"a.ini", "b.pov"}).words, (Words{"--width=1", "b.pov"}));
    EXPECT_EQ(translate({"a.ini", "-W3", "b.pov", "c.pov"}).words, (Words{"--width=1", "--width=3", "b.pov", "c.pov"}));
    EXPECT_EQ(translate({"b.pov", "a.ini"}).words, (Words{"b.pov", "--input=a.pov", "--width=1"}));
    EXPECT_EQ(translate({"a.ini", "+Ib.pov"}).words, (Words{"--input=a.pov", "--width=1", "--input=b.pov"}));
}

TEST(Ini, CommandsAreNeverStarted) {
    const test::Workplace here;
    here.write("a.ini", "Pre_Scene_Command=touch there\nPost_Frame_Command=touch %o\nUser_Abort_Command=\nPre_Scene_Return=F\n");
    const Translation t = translate({"a.ini"});
    EXPECT_EQ(t.words, Words{});
    EXPECT_EQ(t.notes, (Words{"Pre_Scene_Command=touch there: no command is ever started",
                              "Post_Frame_Command=touch %o: no command is ever started"}));
    EXPECT_EQ(t.ignored, (Words{"Pre_Scene_Return=F"}));
}

/// A variable of the environment while this lives.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~Variable() { unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
};

Translation with_defaults(const Words& words) {
    return translate_povray_syntax(
        words, {.takes_value = [](const std::string&) { return false; }, .long_names = {}, .try_out = [](const Words&) {}},
        Defaults::of_povray);
}

TEST(Ini, DefaultsComeFromTheFileOfThatNameOrTheVariables) {
    const test::Workplace here;
    EXPECT_EQ(with_defaults({"+W7"}).words, (Words{"--width=7"}));
    here.write("povray.ini", "Width=1\n");
    here.write("mine", "Width=2\n");
    EXPECT_EQ(translate({"+W7"}).words, (Words{"--width=7"}));
    EXPECT_EQ(with_defaults({"+W7"}).words, (Words{"--width=1", "--width=7"}));
    EXPECT_EQ(with_defaults({}).notes, (Words{"defaults are those of 'povray.ini'"}));
    {
        const Variable named("POVINI", "mine");
        EXPECT_EQ(with_defaults({}).words, (Words{"--width=2"}));
        EXPECT_EQ(with_defaults({}).notes, (Words{"defaults are those of 'mine'"}));
    }
    const Variable missing("POVINI", "none");
    EXPECT_EQ(with_defaults({}).words, (Words{"--width=1"}));
    EXPECT_EQ(with_defaults({}).notes, (Words{"POVINI: there is no file 'none'", "defaults are those of 'povray.ini'"}));
    here.write("povray.ini", "Widht=1\n");
    EXPECT_THROW(with_defaults({}), OptionError);
}

/// Accepted by POV-Ray 3.7.0.10, each by itself in an INI file.
TEST(Ini, EverySettingOfPovrayIsKnown) {
    for (const char* key : {"All_Console",
                            "All_File",
                            "Antialias",
                            "Antialias_Depth",
                            "Antialias_Gamma",
                            "Antialias_Threshold",
                            "Append_File",
                            "Bits_Per_Color",
                            "Bits_Per_Colour",
                            "Bounding",
                            "Bounding_Method",
                            "Bounding_Threshold",
                            "BSP_BaseAccessCost",
                            "BSP_ChildAccessCost",
                            "BSP_IsectCost",
                            "BSP_MaxDepth",
                            "BSP_MissChance",
                            "Buffer_Output",
                            "Buffer_Size",
                            "Clock",
                            "Clockless_Animation",
                            "Compression",
                            "Continue_Trace",
                            "Create_Ini",
                            "Cyclic_Animation",
                            "Debug_Console",
                            "Debug_File",
                            "Declare",
                            "Display",
                            "Display_Gamma",
                            "Dither",
                            "Dither_Method",
                            "Draw_Vistas",
                            "End_Column",
                            "End_Row",
                            "Fatal_Console",
                            "Fatal_Error_Command",
                            "Fatal_Error_Return",
                            "Fatal_File",
                            "Field_Render",
                            "File_Gamma",
                            "Final_Clock",
                            "Final_Frame",
                            "Frame_Step",
                            "Grayscale_Output",
                            "Height",
                            "High_Reproducibility",
                            "Histogram_Grid_Size",
                            "Histogram_Name",
                            "Histogram_Type",
                            "Include_Header",
                            "Initial_Clock",
                            "Initial_Frame",
                            "Input_File_Name",
                            "Jitter",
                            "Jitter_Amount",
                            "Library_Path",
                            "Light_Buffer",
                            "Max_Image_Buffer_Memory",
                            "Odd_Field",
                            "Output_Alpha",
                            "Output_File_Name",
                            "Output_File_Type",
                            "Output_to_File",
                            "Palette",
                            "Pause_When_Done",
                            "Post_Frame_Command",
                            "Post_Frame_Return",
                            "Post_Scene_Command",
                            "Post_Scene_Return",
                            "Pre_Frame_Command",
                            "Pre_Frame_Return",
                            "Pre_Scene_Command",
                            "Pre_Scene_Return",
                            "Preview_End_Size",
                            "Preview_Start_Size",
                            "Quality",
                            "Radiosity_File_Name",
                            "Radiosity_From_File",
                            "Radiosity_To_File",
                            "Radiosity_Vain_Pretrace",
                            "Real_Time_Raytracing",
                            "Remove_Bounds",
                            "Render_Block_Size",
                            "Render_Block_Step",
                            "Render_Console",
                            "Render_File",
                            "Render_Pattern",
                            "Sampling_Method",
                            "Split_Unions",
                            "Start_Column",
                            "Start_Row",
                            "Statistic_Console",
                            "Statistic_File",
                            "Subset_End_Frame",
                            "Subset_Start_Frame",
                            "Test_Abort",
                            "Test_Abort_Count",
                            "User_Abort_Command",
                            "User_Abort_Return",
                            "Verbose",
                            "Version",
                            "Video_Mode",
                            "Vista_Buffer",
                            "Warning_Console",
                            "Warning_File",
                            "Warning_Level",
                            "Width",
                            "Work_Threads"})
        EXPECT_NE(find_povray_setting(key), nullptr) << key;
}

TEST(Ini, WhatChangesThePictureAndIsNotThereIsRefusedByName) {
    EXPECT_EQ(error_of({"Grayscale_Output=on"}), "Grayscale_Output (from 'Grayscale_Output=on') is not available in this version");
    EXPECT_EQ(error_of({"Clockless_Animation=on"}), "Clockless_Animation (from 'Clockless_Animation=on') is not available in this version");
    EXPECT_EQ(translate({"Field_Render=on", "+UO", "Field_Render=off"}).ignored, (Words{"Field_Render=on", "+UO"}));
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
}  // namespace rt::ini_test
