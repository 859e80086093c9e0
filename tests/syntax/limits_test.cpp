// Every limit that can be set: what exceeds it says which it is, and how to allow more.
#include "syntax/limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "core/source.h"
#include "tests/syntax/read_scene.h"

namespace rt::limits_test {
namespace {

/// A scene that has more than `value` of something.
struct Excess {
    std::uint64_t value;
    std::string scene;
    std::string text;
};

const std::map<std::string, Excess> excesses{
    {"file", {10, "sphere { 0, 1 }", "File 't.pov' is larger than 10 bytes."}},
    {"memory", {1'000'000, "#while (1) sphere { 0, 1 } #end", "The scene takes more than 0.0 GB of memory."}},
    {"reread", {1000, "#while (1) #end", "Loops and macros have read more than 1000 bytes of text again."}},
    {"written", {10, "#fopen F \"f\" write #write (F, \"12345678901\")", "The scene writes more than 10 bytes."}},
    {"string", {10, "#declare S = concat(\"123456\", \"78901\");", "A string is longer than 10 bytes."}},
    {"includes", {2, "#include \"empty\" #include \"empty\" #include \"empty\"", "More than 2 files are included."}},
    {"include-depth", {3, "#include \"self\"", "Too many nested include files. More than 3 are open."}},
    {"macro-depth", {5, "#macro M() M() #end M()", "Macros call each other more than 5 deep."}},
    {"nesting", {4, "#declare A = (((((1)))));", "Blocks and parentheses are nested more than 4 deep."}},
    {"directive-nesting", {2, "#if (#if (#if (1) 1 #end) 1 #end) #end", "Directives stand inside each other more than 2 deep."}},
    {"array", {10, "#declare A = array[11];", "An array has more than 10 elements."}},
    {"picture", {10, "sphere { 0, 1 pigment { image_map { png \"p.png\" } } }", "The picture 'p.png' is too large."}},
    {"texture", {2, "#declare T = texture { } texture { } texture { }", "A texture has more than 2 pigments in its layers and cells."}},
    {"texture-depth",
     {1, "#declare P = pigment { checker pigment { checker rgb 1 rgb 0 } rgb 0 }",
      "The patterns of a texture are nested more than 1 deep."}},
    {"textures",
     {1, "sphere { 0, 1 pigment { checker rgb 1 rgb 0 } }",
      "The textures of the scene have more than 1 pigments beyond the first of each."}},
    {"parts",
     {1, "intersection { sphere { 0, 1 } sphere { 0, 2 } sphere { 0, 3 } }", "The sets of objects have more than 1 parts in all."}},
};

const Files files{{"empty", ""}, {"self", "#include \"self\""}};

TEST(SceneLimits, EachNamesItselfWhereItIsExceeded) {
    ASSERT_EQ(excesses.size(), scene_limits().size());
    for (const SceneLimit& limit : scene_limits()) {
        const Excess& excess = excesses.at(std::string(limit.name));
        ParseOptions options;
        options.read_picture = [](const std::string& path) -> std::optional<PictureFile> {
            throw LimitError(fmt::format("The picture '{}' is too large.", path));
        };
        set_value(limit, options, excess.value);
        EXPECT_EQ(value_of(limit, options), excess.value) << limit.name;
        const Outcome outcome = read_scene(excess.scene, options, files);
        EXPECT_TRUE(outcome.limit) << limit.name << outcome.error;
        EXPECT_THAT(outcome.error, testing::HasSubstr(fmt::format("{} --limit {}=N allows more.", excess.text, limit.name)));
    }
}

TEST(SceneLimits, ThePlaceIsShown) {
    ParseOptions options;
    options.max_string_bytes = 3;
    EXPECT_EQ(read_scene("\n#declare S = concat(\"ab\", \"cd\");", options).error,
              "File 't.pov' line 2: Parse Error: A string is longer than 3 bytes. --limit string=N allows more.\n"
              "   2 | #declare S = concat(\"ab\", \"cd\");\n"
              "     |              ^^^^^^^^^^^^^^^^^");
}

}  // namespace
}  // namespace rt::limits_test
