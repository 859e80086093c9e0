// The command lines of a comparison.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/versus/versus_settings.h"
#include "core/source.h"

namespace rt::versus_commands_test {
namespace {

using testing::ElementsAre;

VersusSettings settings(const std::vector<std::string>& words) {
    VersusSettings s;
    s.words = words, s.job = job_of_words(words), s.threads = 2, s.povray = "/usr/bin/povray", s.program = "/p/raytrace";
    return s;
}

TEST(VersusCommands, BothSayTheSame) {
    VersusSettings s = settings({"--width=64", "--height=48", "--aa=2,0.1,4", "--library=/lib dir", "--define=N=3", "--define=T=3a",
                                 "--clock=0.5", "--language=3.6"});
    s.folder = "/out", s.installed = {"/share/include"};
    PovrayNames names("/links");
    EXPECT_THAT(povray_command(s, "/a/b.pov", "/out/povray.png", names),
                ElementsAre("/usr/bin/env", "POVINI=/out/povray.ini", "/usr/bin/povray", "+I/a/b.pov", "+O/out/povray.png", "+W64", "+H48",
                            "+FN8", "-D", "-V", "+A0.1", "+AM2", "+R4", "-J", "Declare=N=3", "Declare='T=\"3a\"'", "+K0.5", "+MV3.6",
                            "+WT2", "+L/a", "+L\"/lib dir\"", "+L/share/include"));
    EXPECT_TRUE(names.links().empty());
    EXPECT_THAT(our_command(s, "/a/b.pov", Maker::same, "same.png"),
                ElementsAre("/usr/bin/env", "POVINI=/out/povray.ini", "/p/raytrace", "/a/b.pov", "--width=64", "--height=48",
                            "--aa=2,0.1,4", "--library=/lib dir", "--define=N=3", "--define=T=3a", "--clock=0.5", "--language=3.6",
                            "--threads=2", "--shading=povray", "--stats", "-o", "same.png"));
    EXPECT_THAT(our_command(settings({}), "/b.pov", Maker::general, "general.png"),
                ElementsAre("/usr/bin/env", "POVINI=povray.ini", "/p/raytrace", "/b.pov", "--threads=2", "--stats", "-o", "general.png"));
    EXPECT_THAT(povray_picture_words(settings({"--width=8"}).job), testing::Contains("-A"));
    EXPECT_THAT(povray_picture_words(settings({"--clock=0"}).job), testing::Contains("+K0"));
}

TEST(VersusCommands, NamesThatPovrayCannotReadGetALink) {
    PovrayNames names("/links");
    EXPECT_EQ(names.word("/a/b;[c] d'.pov", "scene.pov"), "\"/a/b;[c] d'.pov\"");
    EXPECT_EQ(names.word("/a/b\"c.pov", "scene.pov"), "'/a/b\"c.pov'");
    EXPECT_EQ(names.word("/a/\u00e9", "folder"), "/links/folder");
    EXPECT_EQ(names.word("/a/'\"", "library1"), "/links/library1");
    EXPECT_EQ(names.word("/a\n", "library2"), "/links/library2");
    const std::string fits = "/" + std::string(149, 'a');
    EXPECT_EQ(names.word(fits, "library3"), fits);
    EXPECT_EQ(names.word(fits + "a", "library3"), "/links/library3");
    EXPECT_EQ(names.links().size(), 4u);
    EXPECT_EQ(names.without_links("File '/links/folder/x.inc' line 3"), "File '/a/\u00e9/x.inc' line 3");
}

TEST(VersusCommands, ACopyMakesItsLinksAndRemovesThem) {
    VersusSettings s = settings({});
    s.folder = "/out";
    EXPECT_EQ(povray_command_to_copy(s, "/a/b.pov", "/out/p.png")[0], "/usr/bin/env");
    const std::vector<std::string> copy = povray_command_to_copy(s, "/a/\u00e9.pov", "/out/p.png");
    ASSERT_EQ(copy.size(), 3u);
    EXPECT_THAT(
        copy,
        ElementsAre(
            "/bin/bash", "-c",
            testing::ContainsRegex(
                "^rm -rf (/tmp/raytrace-names-[0-9a-f]{16}) && mkdir -m 700 (/tmp/[^ ]+) && trap 'rm -r (/tmp/[^ ]+)' EXIT && "
                "ln -s -- '/a/\u00e9.pov' /tmp/raytrace-names-[0-9a-f]+/scene.pov && /usr/bin/env POVINI=/out/povray.ini /usr/bin/povray "
                "\\+I/tmp/raytrace-names-[0-9a-f]+/scene.pov \\+O/out/p.png ")));
}

TEST(VersusCommands, WhatIsNotUtf8IsWrittenByAShell) {
    EXPECT_THAT(command_as_text({"/p/raytrace", "/\u00e9 a.pov"}), ElementsAre("/p/raytrace", "/\u00e9 a.pov"));
    EXPECT_THAT(command_as_text({"/p/raytrace", "/\xff a.pov"}), ElementsAre("/bin/bash", "-c", "/p/raytrace $'/\\377 a.pov'"));
}

TEST(VersusCommands, ValuesThatPovrayCannotTakeAreMistakes) {
    for (const char* word : {"--define=N=nan", "--define=N=inf", "--define=T=a'b", "--define=T=a\\b", "--define=T=\u00e9"})
        EXPECT_THROW(povray_picture_words(settings({word}).job), OptionError) << word;
    EXPECT_THAT(povray_picture_words(settings({"--define=T=a b;[c]"}).job), testing::Contains("Declare='T=\"a b;[c]\"'"));
}

}  // namespace
}  // namespace rt::versus_commands_test
