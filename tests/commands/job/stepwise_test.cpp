// Pictures by error, in time and as previews, by the program itself. How long they take is not tested.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "commands/job/stepwise.h"
#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::stepwise_test {
namespace {

using test::Outcome;
using test::run;
using Files = std::vector<std::string>;

class Stepwise : public testing::Test {
protected:
    Stepwise() { here.write("a.pov", test::small_scene); }
    std::string error(std::vector<std::string> words) {
        words.insert(words.begin(), "a.pov");
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(here.files(), Files{"a.pov"});
        return outcome.err;
    }
    test::Workplace here;
};

TEST_F(Stepwise, APreviewEndsInTheBytesOfAPlainRun) {
    for (const Files& options : {Files{}, Files{"--ss=2"}, Files{"--crop=10,50,5,40"}, Files{"--max-error=0.01"}}) {
        Files words{"a.pov", "-W101", "-H67", "-q", "-o", "out.png"};
        words.insert(words.end(), options.begin(), options.end());
        ASSERT_EQ(run(words).status, 0);
        const std::string plain = here.read("out.png");
        words.emplace_back("--preview");
        EXPECT_EQ(run(words).status, 0);
        EXPECT_EQ(here.read("out.png"), plain);
        EXPECT_EQ(here.files(), (Files{"a.pov", "out.png"}));
    }
}

TEST_F(Stepwise, AnInterruptedPreviewLeavesAWholePicture) {
    const Outcome outcome = test::run_and_interrupt_at_file(
        {"a.pov", "--size=3000x3000", "--index=brute_force", "--ss=16", "-t2", "--preview", "-o", "out.png"}, "out.png", {SIGINT});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "raytrace: interrupted; the picture so far is in 'out.png'\n");
    EXPECT_EQ(here.files(), (Files{"a.pov", "out.png"}));
    EXPECT_EQ(read_image("out.png").width, 3000);
}

TEST_F(Stepwise, APreviewNeedsAFile) {
    const std::string rest = "' does not allow; give it a file\n",
                      start = "raytrace: --preview writes the picture again and again, which '";
    EXPECT_EQ(error({"--preview", "-o", "-"}), start + "-" + rest);
    EXPECT_EQ(error({"--preview", "-o", "/dev/null", "--format=png"}), start + "/dev/null" + rest);
}

TEST_F(Stepwise, TheSamplesAreChosenByOneOption) {
    const std::string rest = " and --ss or anti-aliasing (+A, --aa) both choose the samples of a pixel; give one of them\n";
    EXPECT_EQ(error({"--max-error=0.1", "--ss=2"}), "raytrace: --max-error" + rest);
    EXPECT_EQ(error({"--time=1", "--aa=2"}), "raytrace: --time" + rest);
}

TEST_F(Stepwise, ATimeThatIsTooShortStillMakesAPictureAndSaysHowMuchIsTraced) {
    const Outcome outcome = run({"a.pov", "--size=1000x1000", "--time=0.01", "-o", "out.png"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err,
                testing::ContainsRegex("^raytrace: [0-9.]+ s: 0.026 % of the pixels are traced, the others made up from them"));
    EXPECT_EQ(read_image("out.png").width, 1000);
}

TEST_F(Stepwise, ATimeEndsWhereNothingIsToGain) {
    const Outcome outcome = run({"a.pov", "--size=40x30", "--time=1000", "-o", "out.png"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, testing::ContainsRegex("^raytrace: [0-9.]+ s: [0-9.]+ samples a pixel, the error is estimated to be 0.0004"));
}

TEST(ReachedText, SaysWhatThereIs) {
    Convergence reached;
    reached.traced = 0.25;
    EXPECT_EQ(reached_text(reached, 1.5), "1.50 s: 25 % of the pixels are traced, the others made up from them");
    reached.traced = 1.0, reached.mean = 1.0;
    EXPECT_EQ(reached_text(reached, 1.5), "1.50 s: 1 samples a pixel");
    reached.mean = 12.34, reached.error = 0.00512;
    EXPECT_EQ(reached_text(reached, 2.0), "2.00 s: 12.3 samples a pixel, the error is estimated to be 0.0051");
}

}  // namespace
}  // namespace rt::stepwise_test
