// The program's pictures of pov/extremes/ against a second renderer with 113 bits.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/extremes/judgement.h"

namespace extremes_test {
namespace {

using rt::extremes::Judgement;
using rt::extremes::wrong;

class Extremes : public testing::TestWithParam<std::string> {};

TEST_P(Extremes, EveryPixelIsWithinOneStepOfTheTruth) {
    const Judgement judgement = rt::extremes::judge(GetParam());
    // Along a highlight without width, in one pixel of one scene, the limit of all widths is infinite: there it is a convention that lamps
    // which are points add nothing.
    const int spikes = judgement.name == "aligned_0" ? 1 : 0;
    EXPECT_EQ(wrong(judgement.textbook, judgement.truth).pixels, spikes) << "two forms of the same terms differ in 113 bits";
    EXPECT_EQ(judgement.truth.non_finite, 0);
    EXPECT_EQ(judgement.ours.non_finite, 0);
    EXPECT_EQ(wrong(judgement.ours, judgement.truth).pixels, 0) << "at most " << wrong(judgement.ours, judgement.truth).steps << " steps";
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Extremes, testing::ValuesIn(rt::extremes::scenes()), name_of);

TEST(Extremes, APixelThatIsNoNumberIsNotRightThoughItIsBlackAsTheTruth) {
    Judgement judgement;
    judgement.ours = judgement.truth = {1, 1, {0, 0, 0}, 0};
    EXPECT_TRUE(rt::extremes::right(judgement));
    judgement.ours.non_finite = 1;
    EXPECT_FALSE(rt::extremes::right(judgement));
    judgement.ours = {1, 1, {0, 2, 0}, 0};
    EXPECT_FALSE(rt::extremes::right(judgement));
}

/// What these scenes ask is not easy, and the comparison can fail: textbook formulas in single precision do.
TEST(Extremes, TextbookFormulasInSinglePrecisionFail) {
    for (const std::string name : {"lobe_ggx", "graze_both_ggx_cook-torrance", "index_0.5", "glass_1e6"}) {
        const Judgement judgement = rt::extremes::judge(std::string(PROJECT_ROOT) + "/pov/extremes/" + name + ".pov");
        EXPECT_GT(wrong(judgement.naive_single, judgement.truth).pixels, 500) << name;
    }
    EXPECT_GE(rt::extremes::scenes().size(), 30u);
}

}  // namespace
}  // namespace extremes_test
