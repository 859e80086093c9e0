// raytrace requires with many scenes: whole texts, and scenes that do harm.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/commands/support.h"

namespace rt::requires_test {
namespace {

using test::Outcome;
using test::run;

class Requires : public testing::Test {
protected:
    Requires() {
        std::filesystem::create_directories("set/inner");
        std::filesystem::create_directories("set/.hidden");
        here.write("set/whole.pov", head + "sphere { 0, 1 pigment { rgb 1 } }\n");
        here.write("set/inner/smoke.pov", head + "media { }\n");
        here.write("set/light.pov", head + "#include \"lamp.inc\"\nglobal_settings { radiosity { } }\n");
        here.write("set/lamp.inc", "media { } media { }\n");
        here.write("set/broken.pov", head + "sphere { 0, 1 pigmnt { } }\n");
        here.write("set/lost.pov", "#include \"nowhere.inc\"\n");
        here.write("set/.hidden/none.pov", "nothing");
        here.write("set/notes.txt", "nothing");
    }
    std::string head = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";
    test::Workplace here;
};

/// The lines of a scene that has nothing of note.
std::string needs(const std::string& scene, const std::string& objects, const std::string& includes, const std::string& missing) {
    return scene + "\n  objects:   " + objects + "\n  triangles: 0\n  lights:    none\n  camera:    perspective\n  gamma:     1\n" +
           "  language:  3.7\n  features:  none\n  includes:  " + includes + "\n  not modelled:" + missing + "\n";
}

TEST_F(Requires, ListsEverySceneOfAFolderAndWhatIsMissingInAll) {
    const Outcome outcome = run({"requires", "set"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(
        outcome.out,
        "set/broken.pov\n"
        "  error: File 'set/broken.pov' line 3: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead\n" +
            needs("set/inner/smoke.pov", "0 (none)", "none", "\n    set/inner/smoke.pov:3:1: media") +
            needs("set/light.pov", "0 (none)", "set/lamp.inc",
                  "\n    set/lamp.inc:1:1: media\n    set/lamp.inc:1:11: media\n    set/light.pov:4:19: radiosity") +
            "set/lost.pov\n"
            "  error: File 'set/lost.pov' line 1: Parse Error: Cannot open include file nowhere.inc.\n" +
            needs("set/whole.pov", "1 (1 sphere)", "none", " nothing") +
            "what is not modelled, by gain         scenes that ask for it    for nothing else\n"
            "  media                                                     2                   1\n"
            "  radiosity                                                 1                   0\n"
            "one after the other                          scenes completed         then complete\n"
            "  media                                                     1              2 of 5\n"
            "  radiosity                                                 1              3 of 5\n"
            "1 of 5 scenes miss nothing, 2 miss something, 2 could not be read\n");
    EXPECT_EQ(outcome.err,
              "File 'set/broken.pov' line 3: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead\n"
              "   3 | sphere { 0, 1 pigmnt { } }\n"
              "     |               ^^^^^^\n"
              "File 'set/lost.pov' line 1: Parse Error: Cannot open include file nowhere.inc.\n"
              "   1 | #include \"nowhere.inc\"\n"
              "     |          ^^^^^^^^^^^^^\n");
}

TEST_F(Requires, TheSameAsJson) {
    const Outcome outcome = run({"requires", "--json", "set/broken.pov", "set/inner", "set/whole.pov"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, R"({
  "format": "raytrace requires 1",
  "summary": {
    "complete": 1,
    "incomplete": 1,
    "unread": 1
  },
  "missing": [
    {
      "name": "media",
      "scenes": 1,
      "only_this": 1
    }
  ],
  "order": [
    {
      "name": "media",
      "completes": 1
    }
  ],
  "scenes": [
    {
      "scene": "set/broken.pov",
      "error": "File 'set/broken.pov' line 3: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead\n   3 | sphere { 0, 1 pigmnt { } }\n     |               ^^^^^^",
      "status": 1
    },
    {
      "scene": "set/inner/smoke.pov",
      "objects": 0,
      "shapes": {},
      "triangles": 0,
      "lights": {},
      "camera": "perspective",
      "gamma": "1",
      "language_version": 3.7,
      "features": [],
      "includes": [],
      "not_modelled": [
        {
          "name": "media",
          "file": "set/inner/smoke.pov",
          "line": 3,
          "column": 1
        }
      ]
    },
    {
      "scene": "set/whole.pov",
      "objects": 1,
      "shapes": {
        "sphere": 1
      },
      "triangles": 0,
      "lights": {},
      "camera": "perspective",
      "gamma": "1",
      "language_version": 3.7,
      "features": [],
      "includes": [],
      "not_modelled": []
    }
  ]
}
)");
}

TEST_F(Requires, ReadsThePicturesOfAScene) {
    ASSERT_EQ(run({"set/whole.pov", "--size=4x3", "-o", "set/picture.png"}).status, 0);
    here.write("set/laid.pov", head + "plane { z, 1 pigment { image_map { png \"picture.png\" } } }\n");
    const Outcome outcome = run({"requires", "set/laid.pov"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("features:  image_map\n"), std::string::npos) << outcome.out;
}

TEST_F(Requires, ASceneThatTakesTooLongIsListedAndTheOthersGoOn) {
    here.write("slow.pov", head + "#while (1) #declare a = sin(1); #end\n");
    const Outcome outcome = run({"requires", "slow.pov", "set/whole.pov", "--timeout", "0.3"});
    EXPECT_EQ(outcome.status, 4);
    EXPECT_EQ(outcome.out, "slow.pov\n  error: raytrace: slow.pov: reading it takes more than 0.3 s\n" +
                               needs("set/whole.pov", "1 (1 sphere)", "none", " nothing") +
                               "1 of 2 scenes miss nothing, 0 miss something, 1 could not be read\n");
    EXPECT_EQ(outcome.err, "raytrace: slow.pov: reading it takes more than 0.3 s\n");
}

TEST_F(Requires, ALimitOfTheLanguageIsListedToo) {
    here.write("deep.pov", head + "#macro m() m() #end\nm()\n");
    const Outcome outcome = run({"requires", "deep.pov", "set/whole.pov"});
    EXPECT_EQ(outcome.status, 4);
    EXPECT_NE(outcome.out.find("deep.pov\n  error: "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("1 of 2 scenes miss nothing, 0 miss something, 1 could not be read\n"), std::string::npos) << outcome.out;
}

TEST_F(Requires, FoldersWithoutScenesAreMistakes) {
    std::filesystem::create_directory("empty");
    const Outcome outcome = run({"requires", "empty", "set/whole.pov"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "raytrace: there is no scene (*.pov) in the folder 'empty'\n");
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(run({"requires", "set", "--timeout", "0"}).err, "raytrace: timeout: 0 is outside 0.01 to 1000000\n");
}

TEST_F(Requires, HelpTellsOfIt) {
    const Outcome help = run({"help", "requires"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.out, run({"requires", "--help"}).out);
    EXPECT_NE(help.out.find("Usage: raytrace requires [OPTION...] SCENE|FOLDER...\n"), std::string::npos);
    EXPECT_NE(help.out.find("--timeout S"), std::string::npos);
}

}  // namespace
}  // namespace rt::requires_test
