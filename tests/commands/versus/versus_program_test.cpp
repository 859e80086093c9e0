// raytrace versus end to end: with POV-Ray where it is installed, else with a program that stands in for it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "commands/base/shell_words.h"
#include "tests/commands/support.h"

namespace rt::versus_program_test {
namespace {

using test::Outcome;
using test::run;
using testing::HasSubstr;

constexpr const char* shiny_scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -4*z }
light_source { <5, 5, -5>, 1 }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.2> } finish { specular 0.9 roughness 0.05 } }
)";

class Versus : public testing::Test {
protected:
    test::Workplace here;

    nlohmann::json results(const std::string& folder = "versus-results") const {
        return nlohmann::json::parse(here.read(folder + "/results.json"));
    }

    /// A stand-in for POV-Ray: prints a version; else `act` in a shell, where $out is the picture's name and $here this folder.
    void stand_in(const std::string& act) const {
        here.write("stand_in", fmt::format("#!/bin/sh\nhere='{}'\ncase $1 in --version) echo 'POV-Ray 3.7 of the tests'; exit;; esac\n"
                                           "for word; do case $word in +O*) out=${{word#+O}};; +I*) scene=${{word#+I}};; esac; done\n{}\n",
                                           std::filesystem::current_path().string(), act));
        std::filesystem::permissions(
            "stand_in", std::filesystem::perms::owner_all | std::filesystem::perms::others_exec | std::filesystem::perms::others_read);
    }

    static Outcome versus(std::vector<std::string> words) {
        words.insert(words.begin(), {"versus", "-W", "32", "-H", "24", "--povray", "./stand_in"});
        return run(words);
    }
};

TEST_F(Versus, OptionsThatPovrayLacksAreRefusedByName) {
    here.write("a.pov", shiny_scene);
    for (const std::string word : {"--shadows=none", "--light-samples=2", "--max-trace-level=3", "--ss=2"}) {
        const Outcome outcome = versus({"a.pov", word});
        EXPECT_EQ(outcome.status, 4) << word;
        EXPECT_EQ(outcome.err, fmt::format("raytrace: '{}' is an option of a render and not of a comparison, in which both programs get "
                                           "size, --aa, -L, --define and --clock\n",
                                           word.substr(0, word.find('='))));
    }
    EXPECT_FALSE(here.has("versus-results"));
}

TEST_F(Versus, WithoutPovrayItSaysHowToInstallIt) {
    here.write("a.pov", shiny_scene);
    const std::string command = fmt::format("PATH=/nowhere '{}' versus a.pov > out 2> err", PROGRAM);
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 4);
    EXPECT_EQ(here.read("out"), "");
    EXPECT_EQ(here.read("err"),
              "raytrace: POV-Ray is not installed, so there is nothing to compare with. On Debian:\n"
              "    sudo apt-get install povray povray-includes\n"
              "A program that is not in $PATH is named by --povray PROGRAM\n");
    EXPECT_FALSE(here.has("versus-results"));
}

TEST_F(Versus, MistakesAreStatusFour) {
    here.write("a.pov", shiny_scene);
    const auto message = [](const std::vector<std::string>& words) {
        std::vector<std::string> line = {"versus"};
        line.insert(line.end(), words.begin(), words.end());
        const Outcome outcome = run(line);
        EXPECT_EQ(outcome.status, 4) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_EQ(message({}), "raytrace: versus: expected scenes or folders; see raytrace versus --help\n");
    EXPECT_EQ(message({"a.pov", "--povray", "nowhere"}),
              "raytrace: --povray: 'nowhere' is no program. On Debian:\n    sudo apt-get install povray povray-includes\n");
    EXPECT_EQ(message({"a.pov", "--povray", "/bin/true"}), "raytrace: '/bin/true' is not POV-Ray: --version prints no version of it\n");
    EXPECT_EQ(message({"nowhere"}), "raytrace: there is no scene or folder 'nowhere'\n");
    EXPECT_EQ(message({"a.pov", "-W", "8192", "-H", "4097"}),
              "raytrace: 8192 x 4097 pixels are too many to compare; at most 33554432 are\n");
    EXPECT_EQ(message({"a.pov", "--rmse", "0"}), "raytrace: rmse: 0 is too little: no RMSE is below it\n");
    EXPECT_EQ(message({"a.pov", "-L", "/nosuch"}), "raytrace: --library: there is no folder '/nosuch'\n");
    EXPECT_EQ(message({"a.pov", "-W", "0"}), "raytrace: width: 0 is outside 1 to 1000000\n");
    EXPECT_EQ(message({"a.pov", "--judge", "povray"}), "raytrace: 'povray' is no shading to judge; expected one of same, general\n");
    EXPECT_EQ(message({"a.pov", "--percent", "101"}), "raytrace: percent: 101 is outside 0 to 100\n");
    EXPECT_THAT(message({"a.pov", "--ss", "3"}), HasSubstr("--ss"));
    EXPECT_THAT(message({"a.pov", "+Q3"}), HasSubstr("--povray-quality"));
    EXPECT_THAT(message({"a.pov", "+UA"}),
                testing::StartsWith("raytrace: '--output-alpha' is an option of a render and not of a comparison"));
    EXPECT_FALSE(here.has("versus-results"));
}

TEST_F(Versus, AStandInThatPrintsOurPictureAgrees) {
    here.write("a.pov", shiny_scene);
    ASSERT_EQ(run({"a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    stand_in("cp $here/right.png $out");
    const Outcome outcome = versus({"a.pov"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("agrees (1)\n  a      100.00 %  0.0000"));
    EXPECT_THAT(outcome.out, HasSubstr("1 of 1 scenes agree: 1 agrees\n"));
    for (const char* name : {"povray", "same", "general", "difference_same", "difference_general"})
        EXPECT_TRUE(here.has(fmt::format("versus-results/pictures/a/{}.png", name))) << name;
    const nlohmann::json scene = results()["scenes"][0];
    EXPECT_EQ(scene["cause"], "agrees");
    EXPECT_EQ(scene["same"]["likeness"]["figures"]["rmse"], 0.0);
    EXPECT_GT(scene["general"]["likeness"]["figures"]["rmse"], 0.01);
    EXPECT_EQ(scene["same"]["rays"], 32 * 24);
}

TEST_F(Versus, TheGeneralFormDiffersWhereItIsJudged) {
    here.write("a.pov", shiny_scene);
    ASSERT_EQ(run({"a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    stand_in("cp $here/right.png $out");
    const Outcome outcome = versus({"a.pov", "--judge", "general"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr("differs (1)\n"));
    EXPECT_THAT(outcome.out,
                testing::ContainsRegex("[0-9]+ pixels in \\([0-9]+, [0-9]+\\) to .*; at .* POV-Ray has [0-9 ]+, we [0-9 ]+\n"));
}

TEST_F(Versus, KnownPicturesAreNotMadeAgain) {
    here.write("a.pov", shiny_scene);
    ASSERT_EQ(run({"a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    std::filesystem::create_directory("scenes");
    std::filesystem::rename("a.pov", "scenes/a.pov");
    stand_in(". $here/act");
    here.write("act", "cp $here/right.png $out");
    ASSERT_EQ(versus({"scenes/a.pov"}).status, 0);
    const std::string before = here.read("versus-results/results.json");
    here.write("act", "exit 7");  // whoever starts it now fails
    EXPECT_EQ(versus({"scenes/a.pov"}).status, 0);
    EXPECT_EQ(here.read("versus-results/results.json"), before);
    EXPECT_EQ(versus({"scenes/a.pov", "--threads", "1"}).status, 0);  // the picture is the same
    EXPECT_EQ(versus({"scenes/a.pov", "--fresh"}).status, 1);
    EXPECT_EQ(versus({"scenes/a.pov", "-W", "16"}).status, 1);
    here.write("scenes/a.pov", std::string(shiny_scene) + "// as \"table.inc\" says\n");
    EXPECT_EQ(versus({"scenes/a.pov"}).status, 1);
    EXPECT_EQ(results()["scenes"][0]["cause"], "failed");
    EXPECT_EQ(results()["scenes"][0]["povray"]["message"], "exit status 7");
}

TEST_F(Versus, RefusalsAreToldApart) {
    here.write("bad.pov", "sphere { 0, 1 pigmnt { rgb 1 } }\n");
    here.write("good.pov", shiny_scene);
    here.write("mist.pov", std::string(shiny_scene) + "media { }\novus { 1, 0.5 }\nmedia { }\n");
    here.write("worse.pov", "\n\nsphere { 0, 1 pigmnt { rgb 1 } }\n");
    stand_in("case $scene in *mist*) cp $here/right.png $out;; *) echo \"File '$scene' line 1: Parse Error: no\"; exit 1;; esac");
    ASSERT_EQ(run({"good.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    const Outcome outcome = versus({"."});
    EXPECT_EQ(outcome.status, 1);
    const nlohmann::json all = results()["scenes"];
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0]["cause"], "refused by both");
    EXPECT_EQ(all[0]["povray"]["message"], fmt::format("File '{}' line 1: Parse Error: no", all[0]["path"].get<std::string>()));
    EXPECT_THAT(all[0]["same"]["message"].get<std::string>(), HasSubstr("line 1: Parse Error: No matching } in 'sphere'"));
    EXPECT_EQ(all[1]["cause"], "refused by POV-Ray alone");
    EXPECT_EQ(all[2]["cause"], "not modelled");
    EXPECT_EQ(all[2]["not_modelled"].size(), 2u);  // each once
    EXPECT_EQ(all[2]["not_modelled"][0]["name"], "media");
    EXPECT_EQ(all[2]["not_modelled"][0]["line"], 6);
    EXPECT_THAT(all[2]["same"]["message"].get<std::string>(), HasSubstr("mist.pov:6:1: media is not modelled"));
    EXPECT_EQ(all[3]["cause"], "refused at different places");
    EXPECT_THAT(outcome.out, HasSubstr("1 of 4 scenes agree: 1 refused at different places, 1 not modelled, 1 refused by POV-Ray alone, "
                                       "1 refused by both\n"));
    const Outcome nothing = versus({"bad.pov"});
    EXPECT_EQ(nothing.status, 4);
    EXPECT_THAT(nothing.out, HasSubstr("1 of 1 scenes agree: 1 refused by both\n"));
    EXPECT_THAT(nothing.err, testing::EndsWith("\nraytrace: nothing was compared: both programs refuse every scene\n"));
    stand_in("case $scene in *good*) cp $here/right.png $out;; *) echo \"File '$scene' line 1: Parse Error: no\"; exit 1;; esac");
    EXPECT_EQ(versus({"bad.pov", "good.pov"}).status, 0);
    EXPECT_EQ(versus({"good.pov", "bad.pov"}).status, 0);
}

TEST_F(Versus, TheTableIsPrintedWhereReportsCannotBeWritten) {
    here.write("a.pov", shiny_scene);
    stand_in("exit 7");
    std::filesystem::create_directories("out/results.json");
    const Outcome outcome = versus({"a.pov", "-o", "out"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.out, HasSubstr("0 of 1 scenes agree: 1 failed\n"));
    EXPECT_THAT(outcome.err, testing::MatchesRegex("raytrace: Cannot write '.*/out/results.json': Is a directory\n"));
    here.write("file", "");
    const Outcome none = versus({"a.pov", "-o", "file/out"});
    EXPECT_EQ(none.status, 3);
    EXPECT_EQ(none.out, "");
    EXPECT_EQ(none.err, "raytrace: cannot make the folder 'file/out': Not a directory\n");
}

TEST_F(Versus, NamesThatAreNotUtf8LeadToTheirPictures) {
    here.write("\xff.pov", shiny_scene);
    ASSERT_EQ(run({"\xff.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    stand_in("cat $here/right.png > $out");  // cp writes through no link to what is not there
    EXPECT_EQ(versus({"\xff.pov", "-o", "\xfe"}).status, 0);
    const nlohmann::json scene = results("\xfe")["scenes"][0];
    EXPECT_EQ(scene["scene"], "%FF");
    for (const char* maker : {"povray", "same", "general"}) {
        const std::string picture = fmt::format("\xfe/pictures/%FF/{}.png", maker), before = here.read(picture);
        std::filesystem::remove(picture);
        std::string again;
        for (const nlohmann::json& word : scene[maker]["command"]) again += shell_word(word.get<std::string>()) + " ";
        EXPECT_EQ(std::system((again + " > /dev/null 2>&1").c_str()), 0) << again;
        EXPECT_EQ(here.read(picture), before) << again;
    }
    EXPECT_THAT(here.read("\xfe/report.html"), HasSubstr(R"("label":"Same shading","picture":)"));
}

TEST_F(Versus, ScenesInSharedMemorySeeWhatIsAroundThem) {
    std::string folder = "/dev/shm/raytrace_test_XXXXXX";
    if (!mkdtemp(folder.data())) GTEST_SKIP() << "there is no /dev/shm";
    std::filesystem::create_directory(folder + "/scenes");
    std::ofstream(folder + "/lamp.inc") << "light_source { <5, 5, -5>, 1 }\n";
    std::ofstream(folder + "/scenes/a.pov") << "#include \"../lamp.inc\"\n" << shiny_scene;
    ASSERT_EQ(run({folder + "/scenes/a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    stand_in("cp $here/right.png $out");
    const Outcome outcome = versus({folder});
    std::filesystem::remove_all(folder);
    EXPECT_EQ(outcome.status, 0) << outcome.out;
}

TEST_F(Versus, APictureThatNobodyCanReadIsPovraysFailureAndNotKept) {
    here.write("a.pov", shiny_scene);
    stand_in("echo no picture > $out");
    EXPECT_EQ(versus({"a.pov"}).status, 1);
    EXPECT_EQ(results()["scenes"][0]["cause"], "failed");
    EXPECT_EQ(results()["scenes"][0]["povray"]["state"], "failed");
    EXPECT_EQ(results()["scenes"][0]["same"]["state"], "done");
    ASSERT_EQ(run({"a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    stand_in("cp $here/right.png $out");
    EXPECT_EQ(versus({"a.pov"}).status, 0);
}

TEST_F(Versus, AFailureSaysWhatWasPrinted) {
    here.write("a.pov", shiny_scene);
    stand_in("echo 'Problem with option setting'; exit 1");
    EXPECT_EQ(versus({"a.pov"}).status, 1);
    EXPECT_EQ(results()["scenes"][0]["povray"]["message"], "exit status 1: Problem with option setting");
}

TEST_F(Versus, WhatNeverEndsIsEnded) {
    here.write("a.pov", shiny_scene);
    stand_in("sleep 100");
    const Outcome outcome = versus({"a.pov", "--timeout", "0.3"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(results()["scenes"][0]["cause"], "failed");
    EXPECT_EQ(results()["scenes"][0]["povray"]["message"], "not done within 0.3 s");
    EXPECT_EQ(results()["scenes"][0]["same"]["state"], "done");
}

TEST_F(Versus, AnInterruptionReportsWhatIsDone) {
    here.write("a.pov", shiny_scene), here.write("b.pov", shiny_scene);
    ASSERT_EQ(run({"a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    here.write("b.pov", std::string(shiny_scene) + "// another\n");
    stand_in("case $scene in *b.pov) sleep 100;; esac; cp $here/right.png $out");
    const std::string script = fmt::format(
        "'{}' versus a.pov b.pov -W 32 -H 24 --povray ./stand_in > out 2> err & pid=$!\n"
        "while [ ! -d versus-results/pictures/b ]; do sleep 0.05; done; kill -TERM $pid; wait $pid",
        PROGRAM);
    const auto left = [] {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::current_path() / "tmp"))
            names.insert(entry.path().filename().string());
        return names;
    };
    std::filesystem::create_directory("tmp");
    EXPECT_EQ(WEXITSTATUS(std::system(("TMPDIR=$PWD/tmp; export TMPDIR\n" + script).c_str())), 2);
    EXPECT_THAT(left(), testing::IsEmpty());
    EXPECT_EQ(results()["scenes"][0]["cause"], "agrees");
    EXPECT_EQ(results()["scenes"][1]["cause"], "not run");
    EXPECT_THAT(here.read("out"), HasSubstr("1 of 2 scenes agree: 1 not run, 1 agrees\n"));
}

TEST_F(Versus, ManyAtATimeSayThatTimesAreNotFair) {
    here.write("a.pov", shiny_scene), here.write("b.pov", shiny_scene);
    ASSERT_EQ(run({"a.pov", "--size=32x24", "--shading=povray", "-o", "right.png"}).status, 0);
    stand_in("cp $here/right.png $out");
    const Outcome outcome = versus({"a.pov", "b.pov", "-j", "2"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, HasSubstr("seconds of the 2 scenes that all rendered (not fair: not all ran alone with as many threads)\n"));
    EXPECT_EQ(nlohmann::json::parse(here.read("versus-results/times.json"))["scenes"][0]["same"]["alone"], false);
}

TEST_F(Versus, PovrayItself) {
    if (std::system("command -v povray > /dev/null") != 0) GTEST_SKIP() << "POV-Ray is not installed";
    std::filesystem::create_directories("scenes/inner");
    // POV-Ray comes with a file of that name: the one beside the scene counts.
    here.write("scenes/glass.inc", "#declare Red = pigment { rgb <1, 0.2, 0.2> };\n");
    here.write("scenes/agrees.pov",
               "#version 3.7;\n#include \"glass.inc\"\nglobal_settings { assumed_gamma 1 }\ncamera { location -4*z }\n"
               "light_source { <5, 5, -5>, 1 }\nsphere { 0, 1 pigment { Red } finish { phong 0.5 } }\n");
    here.write("scenes/inner/shiny.pov", shiny_scene);
    here.write("scenes/media.pov", std::string(shiny_scene) + "media { scattering { 1, 0.1 } }\n");
    here.write("scenes/bad.pov", "sphere { 0, 1 pigmnt { rgb 1 } }\n");
    const Outcome outcome = run({"versus", "scenes", "+W64", "+H48", "+A0.3", "-J", "+AM2", "+WT1"});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    const nlohmann::json all = results()["scenes"];
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0]["scene"], "scenes/agrees");
    EXPECT_EQ(all[0]["cause"], "agrees") << outcome.out;
    EXPECT_LT(all[0]["general"]["likeness"]["figures"]["rmse"], 0.001);  // without specular both shadings are one
    EXPECT_EQ(all[1]["cause"], "refused by both");
    EXPECT_THAT(all[1]["povray"]["message"].get<std::string>(),
                HasSubstr("line 1: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead"));
    EXPECT_EQ(all[2]["cause"], "agrees");
    EXPECT_GT(all[2]["general"]["likeness"]["figures"]["rmse"], 0.01);
    EXPECT_EQ(all[3]["cause"], "not modelled");
    EXPECT_GT(all[0]["povray"]["rays"], 64 * 48);
    EXPECT_THAT(all[0]["povray"]["command"], testing::Contains("+AM2"));
    const std::string before = here.read("versus-results/results.json");
    EXPECT_EQ(run({"versus", "scenes", "+W64", "+H48", "+A0.3", "-J", "+AM2", "+WT1", "-q"}).out, "");
    EXPECT_EQ(here.read("versus-results/results.json"), before);
}

TEST_F(Versus, PovrayReadsWhatAUserWouldHaveItRead) {
    if (std::system("command -v povray > /dev/null") != 0) GTEST_SKIP() << "POV-Ray is not installed";
    for (const char* folder : {"deep/x/y", "\u00e9 l", "named"}) std::filesystem::create_directories(folder);
    const std::string body = "camera { location -4*z }\nlight_source { <5, 5, -5>, 1 }\nsphere { 0, 1 pigment { C } finish { phong T } }\n";
    const std::string head = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";
    here.write("deep/x/y/far.pov", head + "#include \"../../c.inc\"\n#declare T = 0.5;\n" + body);
    here.write("deep/x/y/povray.ini", "+A0.1\n");  // for POV-Ray alone
    here.write("deep/c.inc", "#declare C = rgb <1, 0.2, 0.2>;\n");
    here.write("named/n.inc", "#declare C = rgb <0.3, 1, 0.2>;\n");
    here.write("\u00e9 l/m.inc", "#declare T = 0.25;\n");
    here.write("\u00e9 l/sc\u00e8ne 'a\" b.pov", head + "#include \"n.inc\"\n#include \"m.inc\"\n#debug S\n" + body);
    const std::string command = fmt::format(
        "RAYTRACE_LIBRARY_PATH=$PWD/named '{}' versus deep '\u00e9 l' -W 48 -H 36 -L '\u00e9 l' --define 'S=a b;[c]' -o 'out \u00e9' > out "
        "2> err",
        PROGRAM);
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << here.read("out") << here.read("err");
    const nlohmann::json all = results("out \u00e9")["scenes"];
    int with_links = 0;
    ASSERT_EQ(all.size(), 2u);
    for (const nlohmann::json& scene : all) {
        EXPECT_EQ(scene["cause"], "agrees") << scene.dump(1);
        // Each command makes its picture again.
        for (const char* maker : {"povray", "same", "general"}) {
            const std::filesystem::path path = scene["path"].get<std::string>();
            const std::string picture = fmt::format("out \u00e9/pictures/{}/{}.png", scene["scene"].get<std::string>(), maker);
            const std::string before = here.read(picture);
            std::filesystem::remove(picture);
            std::string again = fmt::format("cd {} &&", shell_word(path.parent_path().string()));
            for (const nlohmann::json& word : scene[maker]["command"]) again += " " + shell_word(word.get<std::string>());
            EXPECT_EQ(std::system((again + " > /dev/null 2>&1").c_str()), 0) << again;
            EXPECT_TRUE(here.has(picture)) << again;
            EXPECT_TRUE(std::string(maker) == "povray" || here.read(picture) == before);
            if (const std::size_t at = again.find("/tmp/raytrace-names-"); at != again.npos) {
                ++with_links;
                EXPECT_FALSE(std::filesystem::exists(again.substr(at, again.find(' ', at) - at))) << again;
            }
        }
    }
    EXPECT_EQ(with_links, 2);
}

TEST_F(Versus, PovrayTakesPathsThatAreLongerThanItsRoomForThem) {
    if (std::system("command -v povray > /dev/null") != 0) GTEST_SKIP() << "POV-Ray is not installed";
    const std::string folder(200, 'a');
    std::filesystem::create_directory(folder);
    here.write(folder + "/good.pov", shiny_scene);
    here.write(folder + "/bad.pov", "sphere { 0, 1 pigmnt { rgb 1 } }\n");
    const Outcome outcome = run({"versus", folder, "-W", "32", "-H", "24"});
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    const nlohmann::json all = results()["scenes"];
    EXPECT_EQ(all[0]["cause"], "refused by both");
    EXPECT_THAT(all[0]["povray"]["message"].get<std::string>(), HasSubstr("/" + folder + "/bad.pov' line 1: Parse Error: No matching }"));
    EXPECT_EQ(all[1]["cause"], "agrees");
}

}  // namespace
}  // namespace rt::versus_program_test
