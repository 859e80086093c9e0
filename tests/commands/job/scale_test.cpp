// --scale, by the program itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::scale_test {
namespace {

using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

class Scale : public testing::Test {
protected:
    Scale() { here.write("a.pov", test::small_scene); }
    static Words with(Words words, const Words& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    std::string error(const Words& options) {
        const Outcome outcome = run(with({"a.pov"}, options));
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(here.files(), Words{"a.pov"});
        return outcome.err;
    }
    StoredImage picture(const Words& options) {
        const Outcome outcome = run(with({"a.pov", "-W61", "-H47", "-o", "out.ppm"}, options));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return read_image("out.ppm");
    }
    test::Workplace here;
};

TEST_F(Scale, ThePictureHasTheSizeThatWasAskedForAndIsLikeTheWholeOne) {
    const StoredImage whole = picture({}), scaled = picture({"--scale=2"});
    EXPECT_EQ(scaled.width, 61);
    EXPECT_EQ(scaled.height, 47);
    EXPECT_NE(scaled.values, whole.values);
    double difference = 0.0;
    for (std::size_t i = 0; i < whole.values.size(); ++i) difference += std::abs(whole.values[i] - scaled.values[i]);
    EXPECT_LT(difference / static_cast<double>(whole.values.size()), 4.0) << "of 255";
    EXPECT_EQ(picture({"--scale", "1"}).values, whole.values);
}

TEST_F(Scale, GoesWithSamplesAndPartsAndAnyNumberOfThreads) {
    for (const Words& options : {Words{}, Words{"--ss=2"}, Words{"--aa=1,0.1,3"}, Words{"--aa=2,0.1,3"}, Words{"--crop=10,50,5,40"}}) {
        const StoredImage one = picture(with({"--scale=3", "-t1"}, options));
        EXPECT_EQ(picture(with({"--scale=3", "-t5"}, options)).values, one.values);
    }
    const StoredImage whole = picture({"--scale=3"}), part = picture({"--scale=3", "--crop=10,50,5,40"});
    for (int y = 5; y < 40; ++y)
        for (int x = 10 * 3; x < 50 * 3; ++x) ASSERT_EQ(part.values[y * 61 * 3 + x], whole.values[y * 61 * 3 + x]) << x << ", " << y;
}

TEST_F(Scale, ThePictureSaysSo) {
    EXPECT_EQ(run({"a.pov", "-W61", "-H47", "--scale=3", "-o", "out.png"}).status, 0);
    EXPECT_THAT(here.read("out.png"), testing::HasSubstr(" aa=none gamma=1 scale=3"));
    EXPECT_EQ(run({"a.pov", "-W61", "-H47", "--scale=1", "-o", "out.png"}).status, 0);
    EXPECT_THAT(here.read("out.png"), testing::Not(testing::HasSubstr("scale=")));
}

TEST_F(Scale, MistakesAreNamed) {
    EXPECT_EQ(error({"--scale=0"}), "raytrace: scale: 0 is outside 1 to 64\n");
    EXPECT_EQ(error({"--scale=65"}), "raytrace: scale: 65 is outside 1 to 64\n");
    EXPECT_EQ(error({"--scale=1.5"}), "raytrace: scale: expected a whole number, not '1.5'\n");
    EXPECT_EQ(error({"--scale=half"}), "raytrace: scale: 'half' is no number\n");
}

TEST_F(Scale, WhatIsTracedIsChosenByOneOption) {
    const std::string rest = " and --scale both choose which pixels are traced; give one of them\n";
    EXPECT_EQ(error({"--scale=2", "--max-error=0.1"}), "raytrace: --max-error" + rest);
    EXPECT_EQ(error({"--scale=2", "--time=1"}), "raytrace: --time" + rest);
    EXPECT_EQ(error({"--preview", "--scale=2"}), "raytrace: --preview" + rest);
    picture({"--scale=1", "--preview"});
}

TEST_F(Scale, GoesWithTheCoursesPicturesButNotWithTheirPixels) {
    EXPECT_EQ(run({"render", "a.pov", "40", "30", "--scale=2"}).status, 0);
    EXPECT_EQ(read_image("output.png").width, 40);
    for (const std::string command : {"pixelray", "firsthit", "pixelcolor", "printrays", "pixeltrace"})
        EXPECT_EQ(run({command, "a.pov", "40", "30", "4", "3", "--scale=2"}).err,
                  "raytrace: option '--scale' goes with render and raycast: " + command + " writes no picture\n");
}

}  // namespace
}  // namespace rt::scale_test
