// Choices in `//! raytrace:` comments as every command meets them: the same message, the same exit status.
#include <gtest/gtest.h>

#include "tests/commands/support.h"

namespace rt {
namespace {

using test::Outcome;
using test::run;
using test::small_scene;

class ChoicesInScenes : public testing::Test {
protected:
    test::Workplace here;

    void state(const std::string& comment) { here.write("c.pov", small_scene + comment + "\n"); }
    Outcome render() { return run({"c.pov", "--size=8x6"}); }
};

TEST_F(ChoicesInScenes, BadOnesAreTheSameErrorForEveryCommand) {
    for (const char* comment : {"//! raytrace: shading=phong", "//! raytrace: shadng=povray", "//! raytrace: precision",
                                "//! raytrace: alpha=direct distances=far"}) {
        state(comment);
        const Outcome rendered = render();
        EXPECT_EQ(rendered.status, 1) << comment;
        EXPECT_EQ(rendered.err.find("File 'c.pov' line 6: Parse Error: "), 0u) << rendered.err;
        for (const char* command : {"requires", "sceneinfo"}) {
            const Outcome other = run({command, "c.pov"});
            EXPECT_EQ(other.status, 1) << command << " " << comment;
            EXPECT_EQ(other.err, rendered.err) << command;
            EXPECT_EQ(other.out, "") << command;
        }
    }
}

TEST_F(ChoicesInScenes, IncludedFilesAreCheckedToo) {
    here.write("c.inc", "\n//! raytrace: precision=perfect\n");
    state("#include \"c.inc\"");
    const Outcome rendered = render();
    EXPECT_EQ(rendered.status, 1);
    EXPECT_EQ(rendered.err.find("File 'c.inc' line 2: Parse Error: precision: 'perfect' is no precision; expected one of "), 0u)
        << rendered.err;
    const Outcome needs = run({"requires", "c.pov"});
    EXPECT_EQ(needs.status, 1);
    EXPECT_EQ(needs.err, rendered.err);
}

TEST_F(ChoicesInScenes, RequiresListsWhatRenderDoesNotSelect) {
    state("//! raytrace: precision=exact D=beckmann\nsphere { 0, 1 finish { //! raytrace: G=smith\n } }");
    EXPECT_EQ(render().status, 1);
    const Outcome needs = run({"requires", "c.pov"});
    EXPECT_EQ(needs.status, 0) << needs.err;
    EXPECT_NE(needs.out.find("  not modelled:\n"
                             "    c.pov:6:31: raytrace option 'D'\n"
                             "    c.pov:7:38: raytrace option 'G' inside finish\n"),
              std::string::npos)
        << needs.out;
}

TEST_F(ChoicesInScenes, OfAFinishAreNamedOnceHoweverOftenItIsUsed) {
    state("#declare F = finish { //! raytrace: alpha=direct\n }\nsphere { 0, 1 finish { F } }\nsphere { 1, 1 finish { F } }");
    const Outcome strict = render();
    EXPECT_EQ(strict.status, 1);
    EXPECT_EQ(strict.err.find("File 'c.pov' line 6: Parse Error: raytrace option 'alpha' inside finish is not available in this version\n"),
              0u)
        << strict.err;
    const Outcome lenient = run({"c.pov", "--size=8x6", "--lenient"});
    EXPECT_EQ(lenient.status, 0);
    const std::string words = "Parse Warning: raytrace option 'alpha' inside finish is not available in this version";
    const std::size_t first = lenient.err.find(words);
    ASSERT_NE(first, std::string::npos) << lenient.err;
    EXPECT_EQ(lenient.err.find(words, first + 1), std::string::npos) << lenient.err;
}

}  // namespace
}  // namespace rt
