// Which scenes are compared, and which files they may read.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "commands/versus/scene_files.h"
#include "commands/versus/versus_scenes.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::versus_scenes_test {
namespace {

using testing::ElementsAre;

TEST(VersusScenes, NamesAndWhatIsLeftOut) {
    const test::Workplace here;
    std::filesystem::create_directories("a/inner"), std::filesystem::create_directories("a/.hidden"),
        std::filesystem::create_directories("a/out");
    std::filesystem::create_directories("b/a");
    for (const char* name : {"a/x.pov", "a/inner/y.POV", "a/.hidden/z.pov", "a/out/w.pov", "a/n.inc", "b/a/x.pov"}) here.write(name, "x");
    const std::string out = std::filesystem::canonical("a/out").string();
    const auto names = [&](const std::vector<std::string>& arguments, const std::string& only = "") {
        std::vector<std::string> list;
        for (const VersusScene& scene : scenes_of(arguments, only, out)) list.push_back(scene.name);
        return list;
    };
    EXPECT_THAT(names({"a"}), ElementsAre("a/inner/y", "a/x"));
    EXPECT_THAT(names({"a/x.pov", "a/x", "b/a", "a/"}), ElementsAre("x", "a/x", "a/inner/y"));
    EXPECT_THAT(names({"a/x.pov", "b/a/x.pov", "a/inner/y.POV"}), ElementsAre(testing::EndsWith("/a/x"), "b/a/x", "y"));
    EXPECT_THAT(names({"a"}, "^a/x"), ElementsAre("a/x"));
    const auto message = [&](const std::vector<std::string>& arguments, const std::string& only) {
        try {
            names(arguments, only);
        } catch (const OptionError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message({"no\nwhere"}, ""), "there is no scene or folder 'no?where'");
    EXPECT_EQ(message({"a/.hidden/.."}, "q"), "--only: no scene's name matches 'q'");
    EXPECT_EQ(message({"a"}, "("), "--only: '(' is no regular expression");
    std::filesystem::create_directory("empty");
    EXPECT_EQ(message({"empty"}, ""), "there is no scene (*.pov) in the folder 'empty'");
    EXPECT_EQ(message({"/dev/zero"}, ""), "'/dev/zero' is neither a scene nor a folder");
    here.write("a/\xff \u00e9.pov", "x");
    EXPECT_THAT(names({"a"}), ElementsAre("a/inner/y", "a/x", "a/%FF %C3%A9"));
}

TEST(SceneFiles, WhatASceneNamesCountsWhereverItLies) {
    const test::Workplace here;
    std::filesystem::create_directories("a/inner"), std::filesystem::create_directory("lib");
    here.write("a/inner/x.pov", "// it isn\"t\n#include \"../n\"\nimage_map { png \"map\" } // \"not/there\"\n");
    here.write("a/n.inc", "#fopen F \"data.txt\" read"), here.write("a/data.txt", "1"), here.write("lib/map.png", "p");
    const std::string scene = std::filesystem::canonical("a/inner/x.pov").string(), lib = std::filesystem::canonical("lib").string();
    const auto files = [&] { return files_of_scene(scene, {lib}, {}, {}); };
    std::string before = files().fingerprint;
    EXPECT_TRUE(files().complete);
    const auto changes = [&](const std::string& name, const std::string& text) {
        here.write(name, text);
        const std::string after = files().fingerprint;
        const bool changed = after != before;
        before = after;
        return changed;
    };
    EXPECT_FALSE(changes("a/inner/other.txt", "nobody reads it"));
    EXPECT_TRUE(changes("a/data.txt", "2"));
    EXPECT_TRUE(changes("lib/map.png", "q"));
    EXPECT_TRUE(changes("a/inner/map.png", "found first"));
    std::filesystem::create_directory("a/inner/not");
    EXPECT_TRUE(changes("a/inner/not/there", "now it is"));
    EXPECT_TRUE(changes("a/n.inc", "\"../lib/map.png\""));
    EXPECT_TRUE(changes("lib/map.png", "r"));  // no longer first, but named
    EXPECT_TRUE(changes("a/n.inc", "#fopen F concat(\"da\", \"ta.txt\") read"));
    EXPECT_FALSE(files().complete);
}

TEST(SceneFiles, WhatIsTooMuchOrNeverEndsIsNotRead) {
    const test::Workplace here;
    const auto is_complete = [&](const std::string& text) {
        here.write("a.pov", text);
        return files_of_scene(std::filesystem::absolute("a.pov").string(), {}, {}, {}).complete;
    };
    EXPECT_TRUE(is_complete("\"b\""));
    EXPECT_FALSE(is_complete("\"/proc/kmsg\""));
    EXPECT_FALSE(is_complete("\"/sys/kernel/mm/transparent_hugepage/enabled\""));
    here.write("large", ""), std::filesystem::resize_file("large", (1u << 26) + 1);
    EXPECT_FALSE(is_complete("\"large\""));  // a text that is not looked through
    std::filesystem::resize_file("large", 1ull << 40);
    EXPECT_FALSE(is_complete("\"large\""));
    std::string names;
    for (int i = 0; i < 2'001; ++i) names += fmt::format("\"{}\" ", i);
    EXPECT_FALSE(is_complete(names));
    EXPECT_TRUE(is_complete(names.substr(0, names.size() / 2)));
}

}  // namespace
}  // namespace rt::versus_scenes_test
