// Renders of a trade that are given up.
#include "commands/trade/trade_scene.h"

#include <gtest/gtest.h>

#include "commands/job/render_arguments.h"
#include "tests/commands/support.h"

namespace rt::trade_scene_test {
namespace {

TEST(TradeScene, GivesUpSamplingByErrorThatTakesTooLong) {
    const test::Workplace here;
    here.write("s.pov", "#version 3.7; global_settings { assumed_gamma 1 } light_source { -9, 1 } sphere { 3*z, 1 pigment { rgb 1 } }\n");
    std::string help;
    const std::atomic<bool> stop = false;
    const TradeScene scene(
        *parse_render_arguments({"s.pov", "--size=16x12"}, help), [](std::string_view) {}, stop);
    const RenderJob by_error = scene.job_of({"--max-error 0.001"});
    const World world = scene.build(by_error);
    EXPECT_FALSE(scene.trace_within(0.0, world, by_error));
    EXPECT_TRUE(scene.trace_within(1e6, world, by_error));
    EXPECT_TRUE(scene.trace_within(0.0, world, scene.job_of({"--ss 2"}))) << "its time is known before";
}

}  // namespace
}  // namespace rt::trade_scene_test
