// Frames: which there are, what the clock says, what their pictures are called; and the program's own.
#include "commands/job/animation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::animation_test {
namespace {

using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

Animation frames(int initial, int final) { return chosen_animation({.initial_frame = initial, .final_frame = final}).value(); }

std::string subset(int initial, int final, std::optional<double> start, std::optional<double> end) {
    const AnimationDraft draft{.initial_frame = initial, .final_frame = final, .subset_start = start, .subset_end = end};
    const Animation chosen = chosen_animation(draft).value();
    return std::to_string(chosen.first) + "-" + std::to_string(chosen.last);
}

TEST(Animation, OneFrameIsNone) {
    EXPECT_FALSE(chosen_animation({}));
    EXPECT_FALSE(chosen_animation({.initial_frame = 1, .final_frame = 1}));
    EXPECT_FALSE(chosen_animation({.initial_frame = 0, .final_frame = 0}));
    EXPECT_FALSE(chosen_animation({.initial_clock = 1.0, .final_clock = 2.0, .cyclic = true}));
    EXPECT_TRUE(chosen_animation({.initial_frame = 2, .final_frame = 2}));
    EXPECT_TRUE(chosen_animation({.final_frame = 2}));
    EXPECT_TRUE(chosen_animation({.initial_frame = 0}));
}

/// As POV-Ray does, measured, but for shares where the first frame is not 1: there POV-Ray counts from 0.
TEST(Animation, ASubsetIsOfFramesOrShares) {
    EXPECT_EQ(subset(0, 10, 3.0, 4.0), "3-4");
    EXPECT_EQ(subset(1, 10, 0.5, 0.7), "5-7");
    EXPECT_EQ(subset(1, 7, 0.5, std::nullopt), "3-7");
    EXPECT_EQ(subset(1, 7, std::nullopt, 0.5), "1-3");
    EXPECT_EQ(subset(1, 4, 0.0, 2.0), "1-2");
    EXPECT_EQ(subset(5, 8, 1.0, 6.0), "5-6");
    EXPECT_EQ(subset(11, 20, 0.5, 0.7), "15-17");
}

TEST(Animation, TheClockGoesFromItsFirstToItsLastValue) {
    const AnimationDraft draft{.initial_frame = 2, .final_frame = 4, .initial_clock = 2.0, .final_clock = 4.0};
    Animation animation = chosen_animation(draft).value();
    ParseOptions parse;
    set_frame(parse, animation, 3);
    EXPECT_TRUE(parse.frame.clock_on);
    EXPECT_EQ(parse.frame.number, 3);
    EXPECT_EQ(parse.frame.initial_frame, 2);
    EXPECT_EQ(parse.frame.final_frame, 4);
    EXPECT_EQ(parse.frame.initial_clock, 2.0);
    EXPECT_EQ(parse.frame.final_clock, 4.0);
    EXPECT_EQ(parse.frame.clock_delta, 1.0);
    EXPECT_EQ(parse.clock, 3.0);
    animation.cyclic = true;
    set_frame(parse, animation, 4);
    EXPECT_EQ(parse.frame.final_frame, 5);
    EXPECT_EQ(parse.frame.clock_delta, 2.0 / 3.0);
    EXPECT_EQ(parse.clock, 2.0 + 2.0 * (2.0 / 3.0));
}

TEST(Animation, ALoneFrameHasTheInitialClock) {
    ParseOptions parse;
    set_frame(parse, chosen_animation({.initial_frame = 9, .final_frame = 9, .initial_clock = 0.5}).value(), 9);
    EXPECT_EQ(parse.clock, 0.5);
    EXPECT_EQ(parse.frame.clock_delta, 0.0);
}

TEST(Animation, PicturesAreNumberedWithTheDigitsOfTheLast) {
    EXPECT_EQ(frame_name("out.png", frames(1, 9), 3), "out3.png");
    EXPECT_EQ(frame_name("a/b.c/out.png", frames(0, 100), 7), "a/b.c/out007.png");
    EXPECT_EQ(frame_name("-", frames(1, 9), 3), "-");
    EXPECT_EQ(frame_name("/dev/stdout", frames(1, 9), 3), "/dev/stdout");
    EXPECT_EQ(frame_name("", frames(1, 9), 3), "");
}

class Frames : public testing::Test {
protected:
    Frames() {
        here.write("a.pov",
                   "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#debug concat(str(frame_number, 0, 0), \" \", str(clock, 0, 2), "
                   "\" \", str(clock_delta, 0, 2), \" \", str(clock_on, 0, 0), \"\\n\")\ncamera { location -4*z look_at 0 }\n"
                   "sphere { clock*x, 1 pigment { rgb 1 } finish { ambient 1 } }\n");
    }
    test::Workplace here;
};

TEST_F(Frames, EachIsTheScenesPictureAtItsClock) {
    const Outcome film = run({"+Ia.pov", "+W16", "+H12", "+KFF3", "-D"});
    EXPECT_EQ(film.status, 0);
    EXPECT_EQ(film.err,
              "raytrace: frame 1 (1 of 3)\n1 0.00 0.50 1\nraytrace: frame 2 (2 of 3)\n2 0.50 0.50 1\nraytrace: frame 3 (3 of 3)\n"
              "3 1.00 0.50 1\n");
    EXPECT_EQ(here.files(), (Words{"a.pov", "a1.png", "a2.png", "a3.png"}));
    EXPECT_EQ(run({"a.pov", "-W16", "-H12", "--clock=0.5", "-o", "alone.png", "-q"}).status, 0);
    EXPECT_EQ(run({"compare", "alone.png", "a2.png"}).status, 0);
    EXPECT_NE(run({"compare", "alone.png", "a3.png"}).status, 0);
}

TEST_F(Frames, PartOfThemHasTheSameNumbers) {
    EXPECT_EQ(run({"a.pov", "-W16", "-H12", "+KFF12", "+SF9", "+EF10", "-o", "film.ppm", "-q"}).status, 0);
    EXPECT_EQ(here.files(), (Words{"a.pov", "film09.ppm", "film10.ppm"}));
}

TEST_F(Frames, AStepLeavesSomeOut) {
    const Outcome film = run({"a.pov", "-W16", "-H12", "+KFF6", "+SF2", "Frame_Step=3", "-o", "film.ppm"});
    EXPECT_EQ(film.err, "raytrace: frame 2 (1 of 2)\n2 0.20 0.20 1\nraytrace: frame 5 (2 of 2)\n5 0.80 0.20 1\n");
    EXPECT_EQ(here.files(), (Words{"a.pov", "film2.ppm", "film5.ppm"}));
    EXPECT_EQ(run({"a.pov", "+KFF6", "Frame_Step=0"}).err, "raytrace: frame step: 0 is outside 1 to 1073741824\n");
}

TEST_F(Frames, AMistakeInOneEndsThem) {
    here.write("b.pov", "#version 3.7;\ncamera { location -4*z look_at 0 }\n#if (frame_number = 2) #error \"two\" #end\n");
    const Outcome film = run({"b.pov", "-W16", "-H12", "+KFF3", "-q"});
    EXPECT_EQ(film.status, 1);
    EXPECT_THAT(film.err, testing::HasSubstr("Parse Error: Parse halted by #error directive: two"));
    EXPECT_EQ(here.files(), (Words{"a.pov", "b.pov", "b1.png"}));
}

TEST_F(Frames, OtherCommandsHaveOnePicture) {
    for (const Words& words : {Words{"trade", "a.pov", "+KFF3"}, Words{"render", "a.pov", "16", "12", "--final-frame", "3"}})
        EXPECT_THAT(run(words).err,
                    testing::HasSubstr("an animation's frames are rendered by raytrace SCENE alone; elsewhere +Kx sets the clock"));
    EXPECT_EQ(run({"requires", "a.pov", "+KFF3", "-q"}).status, 0);
}

}  // namespace
}  // namespace rt::animation_test
