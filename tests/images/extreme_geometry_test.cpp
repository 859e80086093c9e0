// The program's pictures of pov/extremes/geometry/ against a reference with 113 bits.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/extremes/geometry/verdict.h"

namespace extreme_geometry_test {
namespace {

using namespace rt::extremes;

std::string path_of(const std::string& name) { return std::string(PROJECT_ROOT) + "/pov/extremes/geometry/" + name + ".pov"; }

class Geometry : public testing::TestWithParam<std::string> {};

TEST_P(Geometry, IsTracedAsFarAsDoublesGo) {
    const Verdict verdict = verdict_of_ours(GetParam());
    const std::string& name = verdict.truth.name;
    for (std::size_t i = 0; i < settings.size(); ++i) EXPECT_EQ(verdict.ours[i].non_finite, 0) << settings[i].name;
    for (const std::size_t i : {exact_scaled, fast_scaled})
        EXPECT_LE(count(verdict.ours[i], verdict.truth).wrong, known_wrong(name, i)) << settings[i].name;
    EXPECT_TRUE(right(verdict));
    // Of two scenes much is a tie: surfaces in one plane, a lamp on a sphere.
    EXPECT_LE(verdict.truth.unstable, name == "decals" ? 1200 : name == "touching_0" ? 1200 : 5);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
    std::string name = std::filesystem::path(info.param).stem();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Geometry, testing::ValuesIn(geometry_scenes()), name_of);

/// Other formulas in doubles make the reference's pictures where they can.
TEST(GeometryReference, AgreesWithTextbookFormulasWhereThoseHold) {
    for (const std::string name : {"scale_1", "moved_1e8", "needles_1e3", "shells_1e-3", "touching_1e-3", "mirrors_parallel"}) {
        const Truth truth = truth_of(path_of(name));
        EXPECT_EQ(count(textbook_double(path_of(name)), truth).wrong, 0) << name;
    }
}

/// The comparison can fail: POV-Ray's absolute lengths do not fit these.
TEST(GeometryReference, TellsWhatAbsoluteLengthsMiss) {
    const Verdict far = verdict_of_ours(path_of("scale_1e9"));
    const Count count_far = count(far.ours[2], far.truth);
    EXPECT_EQ(count_far.wrong, 3008);
    EXPECT_EQ(count_far.lost, 7);
    EXPECT_EQ(count_far.speckles, 0);
    const Verdict close = verdict_of_ours(path_of("sheets_1e-6"));
    EXPECT_GT(count(close.ours[2], close.truth).wrong, 200);
}

/// A picture of 5 x 3 pixels of one grey, which shows one object but for the last row.
Truth grey_truth() {
    Truth truth{"grey", {5, 3, std::vector<std::uint8_t>(45, 100), 0}, std::vector<bool>(15, true), 0, {}, 1};
    for (int i = 0; i < 15; ++i) truth.objects.push_back(i < 10 ? 0 : 1);
    return truth;
}

TEST(GeometryCount, OfWrongPixelsThoseAmongRightOnesAreSpeckles) {
    const Truth truth = grey_truth();
    Bytes picture = truth.picture;
    picture.values[3 * 7] = 101;
    EXPECT_EQ(count(picture, truth).wrong, 0);
    picture.values[3 * 7] = 110;
    Count c = count(picture, truth);
    EXPECT_EQ(c.wrong, 1);
    EXPECT_EQ(c.steps, 10);
    EXPECT_EQ(c.speckles, 1);
    EXPECT_EQ(c.lost, 0);
    for (int i = 0; i < 8; ++i) picture.values[3 * i + 1] = 0;
    c = count(picture, truth);
    EXPECT_EQ(c.wrong, 8);
    EXPECT_EQ(c.steps, 100);
    EXPECT_EQ(c.lost, 1);
    EXPECT_LT(c.speckles, 3);
}

TEST(GeometryCount, UnstablePixelsAreCountedApart) {
    Truth truth = grey_truth();
    truth.stable[3] = false;
    Bytes picture = truth.picture;
    picture.values[9] = 0;
    const Count c = count(picture, truth);
    EXPECT_EQ(c.wrong, 0);
    EXPECT_EQ(c.unstable, 1);
}

TEST(GeometryCount, APixelThatIsNoNumberIsNotRight) {
    Verdict verdict;
    verdict.truth = grey_truth();
    verdict.ours.fill(verdict.truth.picture);
    EXPECT_TRUE(right(verdict));
    verdict.ours[3].non_finite = 1;
    EXPECT_FALSE(right(verdict));
    verdict.ours[3].non_finite = 0;
    verdict.ours[exact_scaled].values[0] = 0;
    EXPECT_FALSE(right(verdict));
}

}  // namespace
}  // namespace extreme_geometry_test
