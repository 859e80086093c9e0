// The program itself, on small scenes: exit status, streams, files.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::program_test {
namespace {

using test::Outcome;
using test::run;
using test::small_scene;

class Program : public testing::Test {
protected:
    Program() { here.write("a.pov", small_scene); }
    test::Workplace here;
};

TEST_F(Program, ASceneAloneBecomesAPictureBesideUs) {
    const Outcome outcome = run({"a.pov"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(here.files(), (std::vector<std::string>{"a.png", "a.pov"}));
    const StoredImage image = read_image("a.png");
    EXPECT_EQ(image.width, 800);
    EXPECT_EQ(image.height, 600);
}

TEST_F(Program, EveryDialectRendersTheSamePixels) {
    ASSERT_EQ(run({"a.pov", "-W", "40", "-H", "30", "-o", "gnu.png"}).status, 0);
    ASSERT_EQ(run({"+Ia", "+W40", "+H30", "+Opov.png", "-D"}).status, 0);
    here.write("a.ini", "Input_File_Name=a.pov\nWidth=40\nHeight=30\nOutput_File_Name=ini.png\n");
    ASSERT_EQ(run({"a.ini"}).status, 0);
    EXPECT_EQ(here.read("gnu.png"), here.read("pov.png"));
    EXPECT_EQ(here.read("gnu.png"), here.read("ini.png"));
}

TEST_F(Program, ThreadsAndRegionsLeaveThePixelsAlone) {
    ASSERT_EQ(run({"a.pov", "--size=40x30", "-t1", "-o", "one.png", "--aa=1"}).status, 0);
    ASSERT_EQ(run({"a.pov", "--size=40x30", "-t7", "-o", "seven.png", "--aa=1"}).status, 0);
    EXPECT_EQ(here.read("one.png"), here.read("seven.png"));
    ASSERT_EQ(run({"a.pov", "--size=40x30", "--crop=15,22,10,20", "-o", "part.png", "--aa=1"}).status, 0);
    const StoredImage whole = read_image("one.png");
    const StoredImage part = read_image("part.png");
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto i = static_cast<std::size_t>((y * 40 + x) * 3 + c);
                const bool inside = x >= 15 && x < 22 && y >= 10 && y < 20;
                ASSERT_EQ(part.values[i], inside ? whole.values[i] : 0.0f) << x << ", " << y;
            }
}

TEST_F(Program, MistakesEndWithStatusOneAndNoFile) {
    Outcome outcome = run({"none.pov"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("none.pov"), std::string::npos);
    outcome = run({"a.pov", "+W0"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "raytrace: width: 0 is outside 1 to 1000000\n");
    EXPECT_EQ(run({}).status, 1);
    here.write("bad.pov", "sphere { <0, 0, 0>, 1 pigmnt { rgb 1 } }\n");
    outcome = run({"bad.pov"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err,
              "File 'bad.pov' line 1: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead\n"
              "   1 | sphere { <0, 0, 0>, 1 pigmnt { rgb 1 } }\n"
              "     |                       ^^^^^^\n");
    EXPECT_EQ(here.files(), (std::vector<std::string>{"a.pov", "bad.pov"}));
}

TEST_F(Program, TellsItsVersion) {
    EXPECT_EQ(run({"version"}).out.find("raytrace "), 0u);
    EXPECT_EQ(run({"--version"}).status, 0);
}

TEST_F(Program, APictureBeyondTheMemoryIsALimit) {
    const Outcome outcome = run({"a.pov", "+W1000000", "+H1000000"});
    EXPECT_EQ(outcome.status, 4);
    EXPECT_EQ(outcome.err.find("raytrace: a picture of 1000000 x 1000000 pixels needs 24000.0 GB of memory; this machine has "), 0u);
}

TEST_F(Program, AnUnwritableFolderIsStatusThree) {
    const Outcome outcome = run({"a.pov", "--size=8x8", "-o", "nowhere/out.png"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.err.find("nowhere/out.png"), std::string::npos);
    std::filesystem::create_directory("taken.png");
    EXPECT_EQ(run({"a.pov", "--size=8x8", "-o", "taken.png"}).status, 3);
}

// It would take hours to find out after the picture is traced.
TEST_F(Program, AnUnwritableFolderIsFoundBeforeTheWorkBegins) {
    EXPECT_EQ(run({"a.pov", "--size=15000x15000", "--ss=64", "-o", "nowhere/out.png"}).status, 3);
}

TEST_F(Program, MessagesThatCannotBeWrittenCostNoPicture) {
    here.write("warns.pov", std::string(small_scene) + "\n#warning \"careful\"\n");
    for (const char* stderr_to : {"2>/dev/full", "2>&-"}) {
        std::filesystem::remove("w.png");
        EXPECT_EQ(std::system(fmt::format("'{}' warns.pov --size=8x8 --stats -o w.png {}", PROGRAM, stderr_to).c_str()), 0) << stderr_to;
        EXPECT_TRUE(here.has("w.png")) << stderr_to;
        EXPECT_EQ(WEXITSTATUS(std::system(fmt::format("'{}' nosuch.pov {}", PROGRAM, stderr_to).c_str())), 1) << stderr_to;
    }
}

TEST_F(Program, CompareSaysFourWhenItCannotWrite) {
    ASSERT_EQ(run({"a.pov", "--size=8x8", "-o", "a.png"}).status, 0);
    EXPECT_EQ(run({"compare", "a.png", "a.png", "-o", "nowhere/d.png"}).status, 4);
}

TEST_F(Program, AFullDiskIsStatusThree) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const Outcome picture = run({"a.pov", "--size=64x64", "+O-"}, "/dev/full");
    EXPECT_EQ(picture.status, 3) << picture.err;
    EXPECT_NE(picture.err.find("No space left on device"), std::string::npos) << picture.err;
    EXPECT_EQ(run({"requires", "a.pov"}, "/dev/full").status, 3);
    EXPECT_EQ(run({"--help"}, "/dev/full").status, 3);
}

TEST_F(Program, AFileThatMayNotGrowIsStatusThree) {
    rlimit usual{};
    getrlimit(RLIMIT_FSIZE, &usual);
    const rlimit small{1000, usual.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const Outcome outcome = run({"a.pov", "--size=400x300", "-o", "out.png"});
    setrlimit(RLIMIT_FSIZE, &usual);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err, "raytrace: Cannot write 'out.png': File too large\n");
    EXPECT_EQ(here.files(), (std::vector<std::string>{"a.pov"}));
}

TEST_F(Program, AClosedPipeIsStatusThree) {
    ASSERT_EQ(mkfifo("pipe", 0600), 0);
    std::thread reader([] { std::ifstream("pipe").get(); });  // takes a byte and closes
    const Outcome outcome = run({"a.pov", "--size=1500x1500", "+O-", "+FP"}, "pipe");
    reader.join();
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("Broken pipe"), std::string::npos) << outcome.err;
}

TEST_F(Program, ThePictureMayGoToStandardOutput) {
    ASSERT_EQ(run({"a.pov", "--size=8x6", "-o", "a.png"}).status, 0);
    const Outcome outcome = run({"a.pov", "--size=8x6", "+O-"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, here.read("a.png"));
    EXPECT_EQ(run({"a.pov", "--size=8x6", "+O-", "+FP"}).out.substr(0, 3), "P6\n");
}

TEST_F(Program, WithoutAFileNothingIsWritten) {
    EXPECT_EQ(run({"a.pov", "--size=8x6", "-F"}).status, 0);
    EXPECT_EQ(here.files(), (std::vector<std::string>{"a.pov"}));
}

TEST_F(Program, ThePictureSaysHowItWasMade) {
    ASSERT_EQ(run({"a.pov", "--size=8x6", "--shading=povray"}).status, 0);
    const std::string png = here.read("a.png");
    for (const std::string& text : {std::string("Software\0raytrace ", 18), std::string("Scene\0a.pov", 11),
                                    std::string("Options\0size=8x6 profile=povray shading=povray distances=povray", 63)})
        EXPECT_NE(png.find(text), std::string::npos) << text;
}

TEST_F(Program, NotesAreSaidOnceAndNotWhenQuiet) {
    const Outcome outcome = run({"a.pov", "--size=8x6", "+A0.1", "+X", "Display_Gamma=2.2"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err,
              "raytrace: note: anti-aliasing is rendered without jitter, as with -J\n"
              "raytrace: note: ignored, without a meaning here: +X Display_Gamma=2.2\n");
    EXPECT_EQ(run({"a.pov", "--size=8x6", "+A0.1", "+X", "-q"}).err, "");
}

TEST_F(Program, SceneMessagesGoToStandardErrorUnlessQuiet) {
    here.write("m.pov", std::string(small_scene) + "#debug \"hello\\n\"\n#warning \"careful\"\n");
    const Outcome outcome = run({"m.pov", "--size=8x6"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("hello\n"), std::string::npos);
    EXPECT_NE(outcome.err.find("File 'm.pov' line 7: Parse Warning: careful"), std::string::npos) << outcome.err;
    EXPECT_EQ(run({"m.pov", "--size=8x6", "-q"}).err, "");
}

TEST_F(Program, StatsTellPhasesAndRays) {
    const Outcome outcome = run({"a.pov", "--size=8x6", "--stats"});
    EXPECT_EQ(outcome.status, 0);
    for (const char* word :
         {"time: parse ", ", build ", ", trace ", ", write ", "scene: 1 objects, 0 triangles, 1 lights\n", "  camera                48  ",
          "  shadow", "memory: peak ", "threads: ", "gamma: working space 1, file srgb\n", "non-finite pixels: 0\n"})
        EXPECT_NE(outcome.err.find(word), std::string::npos) << word << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

TEST_F(Program, CtrlCKeepsWhatIsFinishedAndTheOldPicture) {
    here.write("out.png", "old");
    const Outcome outcome =
        test::run_and_interrupt({"a.pov", "--size=4000x4000", "-ss=16", "-t2", "--index=brute_force", "-o", "out.png"}, {SIGINT});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "raytrace: interrupted; what was finished is in 'out.partial.png'\n");
    EXPECT_EQ(here.read("out.png"), "old");
    EXPECT_EQ(here.files(), (std::vector<std::string>{"a.pov", "out.partial.png", "out.png"}));
    EXPECT_EQ(read_image("out.partial.png").width, 4000);
}

TEST_F(Program, ASecondCtrlCEndsAtOnce) {
    const Outcome outcome = test::run_and_interrupt({"a.pov", "--size=4000x4000", "-ss=64", "-t2", "--index=brute_force", "-o", "out.png"},
                                                    {SIGINT, SIGTERM});  // two of one kind could arrive as one
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "\nraytrace: interrupted\n");
    EXPECT_EQ(here.files(), (std::vector<std::string>{"a.pov"}));
}

TEST_F(Program, RequiresListsWhatASceneNeeds) {
    here.write("b.pov", std::string(small_scene) + "plane { y, -1 pigment { checker rgb 0, rgb 1 } }\nmedia { scattering { 1 rgb 1 } }\n");
    const Outcome outcome = run({"requires", "b.pov"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "b.pov\n"
              "  objects:   2 (1 plane, 1 sphere)\n"
              "  triangles: 0\n"
              "  lights:    1 point\n"
              "  camera:    perspective\n"
              "  gamma:     1\n"
              "  language:  3.7\n"
              "  features:  checker\n"
              "  includes:  none\n"
              "  not modelled:\n"
              "    b.pov:7:1: media\n");
    const Outcome json = run({"requires", "--json", "a.pov", "b.pov"});
    EXPECT_EQ(json.status, 0);
    EXPECT_NE(json.out.find("\"line\": 7"), std::string::npos);
    const Outcome mixed = run({"requires", "none.pov", "a.pov"});
    EXPECT_EQ(mixed.status, 1);
    EXPECT_EQ(mixed.out.find("none.pov\n  error: "), 0u) << mixed.out;
    EXPECT_NE(mixed.out.find("\na.pov\n  objects: "), std::string::npos) << mixed.out;
}

TEST_F(Program, CompareHasTheExitCodesOfIdiff) {
    ASSERT_EQ(run({"a.pov", "--size=8x6", "-o", "one.png"}).status, 0);
    ASSERT_EQ(run({"a.pov", "--size=8x6", "-o", "two.png", "--file-gamma=1"}).status, 0);
    ASSERT_EQ(run({"a.pov", "--size=8x8", "-o", "big.png"}).status, 0);
    EXPECT_EQ(run({"compare", "one.png", "one.png"}).status, 0);
    EXPECT_EQ(run({"compare", "one.png", "two.png"}).status, 2);
    EXPECT_EQ(run({"compare", "one.png", "two.png", "-fail", "1"}).status, 1);
    EXPECT_EQ(run({"compare", "one.png", "two.png", "--fail=1", "-warn", "1"}).status, 0);
    EXPECT_EQ(run({"compare", "one.png", "two.png", "-failpercent", "100", "-warnpercent", "100"}).status, 0);
    EXPECT_EQ(run({"compare", "one.png", "big.png"}).status, 3);
    EXPECT_EQ(run({"compare", "one.png", "none.png"}).status, 4);
    EXPECT_EQ(run({"compare", "one.png"}).status, 4);
    EXPECT_EQ(run({"compare", "one.png", "two.png", "--fial=1"}).status, 4);
    const Outcome outcome = run({"compare", "one.png", "two.png", "--json", "--output", "diff.png", "--scale", "4", "--fuzz", "3%"});
    EXPECT_NE(outcome.out.find("\"fuzz_percent\": 3.0"), std::string::npos);
    EXPECT_EQ(read_image("diff.png").width, 8);
}

TEST_F(Program, TheCourseRendersSilentlyToItsOwnName) {
    here.write("old.pov", "camera { location <0, 0, -5> }\nsphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }\n");
    EXPECT_NE(run({"old.pov", "--size=12x9"}).err, "");  // a scene without #version has warnings ...
    const Outcome old = run({"render", "old.pov", "12", "9"});
    EXPECT_EQ(old.out + old.err, "");  // ... which the course must not see
    const Outcome outcome = run({"render", "a.pov", "12", "9"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
    const std::string picture = here.read("output.png");
    EXPECT_EQ(read_image("output.png").height, 9);
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"render", "a.pov", "12", "9", "-fresnl"},
                                                                                       {"render", "a.pov", "12", "9", "-gi=3"},
                                                                                       {"render", "a.pov", "12"},
                                                                                       {"render", "a.pov", "0", "9"},
                                                                                       {"render", "none.pov", "12", "9"}}) {
        const Outcome refused = run(words);
        EXPECT_EQ(refused.status, 1);
        EXPECT_EQ(refused.out, "");
        EXPECT_EQ(here.read("output.png"), picture);
    }
    EXPECT_EQ(run({"render", "a.pov", "12", "9", "-fresnl"}).err, "raytrace: unknown option '-fresnl'; did you mean '-fresnel'?\n");
    EXPECT_EQ(run({"render", "a.pov", "12", "9", "-ss=2"}).status, 0);
    EXPECT_NE(here.read("output.png"), picture);
}

/// Inputs and expected texts of the course lie beside the project where they exist at all.
TEST_F(Program, SceneInfoIsTheCoursesText) {
    const std::filesystem::path data = std::filesystem::path(PROJECT_ROOT).parent_path() / "shared" / "csc473";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "the course's files are not beside the project";
    const auto text = [&](const char* name) { return here.read((data / "tests" / "p1" / name).string()); };
    EXPECT_EQ(run({"sceneinfo", (data / "inputs" / "simple.pov").string()}).out, text("test6.out"));
    EXPECT_EQ(run({"sceneinfo", (data / "inputs" / "spheres.pov").string()}).out, text("test7.out"));
}

}  // namespace
}  // namespace rt::program_test
