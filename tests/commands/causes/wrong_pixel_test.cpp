#include "commands/causes/wrong_pixel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/commands/support.h"

namespace rt::test::wrong_pixel_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const char* const scene = R"(camera { location <0, 0, 5> up <0, 1, 0> right <1.3333, 0, 0> look_at <0, 0, 0> }
light_source { <5, 5, 5> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1 pigment { color rgb <1, 0.5, 0.25> } finish { ambient 0.2 diffuse 0.6 } }
)";
const std::vector<std::string> command{"render", "../resources/ball.pov", "32", "24", "-fresnel"};

TEST(PrintraysArguments, PutThePixelBehindTheSizeAndCountFromTheBottom) {
    EXPECT_THAT(printrays_arguments(command, 5, 3), ElementsAre("printrays", "../resources/ball.pov", "32", "24", "5", "20", "-fresnel"));
    EXPECT_THAT(printrays_arguments({"render", "-ss=2", "a.pov", "8", "6"}, 0, 5),
                ElementsAre("printrays", "-ss=2", "a.pov", "8", "6", "0", "0"));
}

TEST(PrintraysArguments, AreNoneForOtherCommands) {
    EXPECT_THAT(printrays_arguments({"raycast", "a.pov", "8", "6"}, 0, 0), IsEmpty());
    EXPECT_THAT(printrays_arguments({"render", "a.pov", "8"}, 0, 0), IsEmpty());
    EXPECT_THAT(printrays_arguments({"render", "a.pov", "8", "high"}, 0, 0), IsEmpty());
    EXPECT_THAT(printrays_arguments({"render", "a.pov", "8", "6", "-gi"}, 0, 0), IsEmpty());
    EXPECT_THAT(printrays_arguments({}, 0, 0), IsEmpty());
}

/// What we print ourselves of the pixel in the middle.
class ExplainPixel : public testing::Test {
protected:
    void SetUp() override {
        place.write("ball.pov", scene);
        printed = run({"printrays", "ball.pov", "32", "24", "16", "12"}).out;
        ASSERT_THAT(printed, HasSubstr("Iteration type"));
    }
    PixelVerdict explained(const std::string& text) const { return explain_pixel(command, ".", 16, 11, text); }
    std::string replaced(const std::string& field) const {
        std::string text = printed;
        const std::size_t line = text.find(field + ": {"), end = text.find('\n', line);
        return text.replace(line, end - line, field + ": {0.0000 0.0000 0.0000}");
    }

    Workplace place;
    std::string printed;
};

TEST_F(ExplainPixel, TheSameRaysAreSaidToBeThat) {
    const PixelVerdict verdict = explained(printed);
    EXPECT_FALSE(verdict.cause);
    EXPECT_THAT(verdict.lines, ElementsAre(HasSubstr("the same rays as ours")));
}

TEST_F(ExplainPixel, ADifferenceHasItsCause) {
    const PixelVerdict verdict = explained(replaced("Ambient"));
    ASSERT_TRUE(verdict.cause);
    EXPECT_EQ(*verdict.cause, Cause::missing_ambient);
    EXPECT_THAT(verdict.lines, testing::Contains(HasSubstr("first difference: ambient")));
    EXPECT_TRUE(agree("ambient missing", *verdict.cause));
    EXPECT_FALSE(agree("missing shadows", *verdict.cause));
}

TEST_F(ExplainPixel, WithoutARecordOursIsShown) {
    for (const std::string& text : {std::string(), std::string("unknown command printrays\n")}) {
        const PixelVerdict verdict = explained(text);
        EXPECT_FALSE(verdict.cause);
        EXPECT_THAT(verdict.lines.front(), HasSubstr("prints no rays"));
        EXPECT_THAT(verdict.lines, testing::Contains(HasSubstr("Iteration type: Primary")));
        EXPECT_LE(verdict.lines.size(), 42u);
    }
}

TEST_F(ExplainPixel, NothingIsSaidOfASceneThatIsNotThere) {
    EXPECT_THAT(explain_pixel({"render", "../resources/none.pov", "32", "24"}, ".", 1, 1, printed).lines, IsEmpty());
}

}  // namespace
}  // namespace rt::test::wrong_pixel_test
