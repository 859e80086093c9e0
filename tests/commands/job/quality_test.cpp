// --quality: what a preset sets, and what is stronger than it.
#include "commands/job/quality.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/job/job_steps.h"
#include "commands/job/render_arguments.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::quality_test {
namespace {

using Words = std::vector<std::string>;

const std::string head =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -4> look_at 0 } light_source { <2, 3, -4> rgb 1 }\n";
const std::string sphere = "sphere { 0, 1 pigment { rgb 1 } finish { specular 0.5 roughness 0.3 reflection 0.3 } }\n";

class QualityOption : public testing::Test {
protected:
    test::Workplace here;

    /// A job with its scene read.
    RenderJob read(const std::string& scene, const Words& words) const {
        here.write("s.pov", scene);
        Words line{"s.pov"};
        line.insert(line.end(), words.begin(), words.end());
        std::string help;
        RenderJob job = *parse_render_arguments(line, help);
        read_scene(job, message_sink(true));
        return job;
    }
    static std::string settings(double level, double bailout) {
        return fmt::format("global_settings {{ max_trace_level {} adc_bailout {} }}\n", level, bailout);
    }
};

/// A job as a preset's words make it.
RenderJob turned(std::string_view quality) {
    RenderJob job;
    for (const QualityChoice& choice : quality_of_name(quality).choices) turn(job, words_of(choice));
    return job;
}

bool same_sampling(const Sampling& a, const Sampling& b) {
    return a.method == b.method && a.depth == b.depth && a.threshold == b.threshold && a.max_error == b.max_error;
}

TEST_F(QualityOption, SetsWhatThePresetSays) {
    for (const QualityPreset& preset : quality_presets()) {
        const double level = preset.cheap ? 256 : 1, bailout = preset.cheap ? 0.0 : 1.0;  // so that nothing is left to the scene
        const RenderJob job = read(head + settings(level, bailout) + sphere, {"--quality", std::string(preset.name)});
        const RenderJob wanted = turned(preset.name);
        EXPECT_TRUE(same_sampling(job.sampling, wanted.sampling)) << preset.name;
        EXPECT_EQ(job.max_trace_level, wanted.max_trace_level) << preset.name;
        EXPECT_EQ(job.adc_bailout, wanted.adc_bailout) << preset.name;
    }
}

TEST_F(QualityOption, IsNothingWithoutTheOption) {
    const RenderJob job = read(head + sphere, {});
    EXPECT_EQ(job.sampling.method, Sampling::Method::none);
    EXPECT_FALSE(job.max_trace_level);
    EXPECT_FALSE(job.adc_bailout);
    EXPECT_TRUE(job.model.empty());
}

TEST_F(QualityOption, OtherOptionsWinWhateverTheOrder) {
    for (const Words& words :
         {Words{"--quality=exact", "--ss=2", "--max-trace-level=3"}, Words{"--ss=2", "--max-trace-level", "3", "--quality=exact"}}) {
        const RenderJob job = read(head + sphere, words);
        EXPECT_EQ(job.sampling.method, Sampling::Method::grid);
        EXPECT_EQ(job.sampling.depth, 2);
        EXPECT_EQ(job.max_trace_level, 3);
        EXPECT_EQ(job.adc_bailout, turned("exact").adc_bailout) << "the rest is the preset's";
    }
    EXPECT_EQ(read(head + sphere, {"+A0.2", "--quality", "exact"}).sampling.method, Sampling::Method::povray1);
    EXPECT_TRUE(same_sampling(read(head + sphere, {"--quality=draft", "--quality=exact"}).sampling, turned("exact").sampling))
        << "the last one counts";
}

TEST_F(QualityOption, NeverGoesTheOtherWayFromTheScenesOwnValues) {
    const RenderJob draft = read(head + settings(1, 0.5) + sphere, {"--quality=draft"});
    EXPECT_FALSE(draft.max_trace_level);
    EXPECT_FALSE(draft.adc_bailout);
    const RenderJob exact = read(head + settings(256, 0.0) + sphere, {"--quality=exact"});
    EXPECT_FALSE(exact.max_trace_level);
    EXPECT_FALSE(exact.adc_bailout);
}

TEST_F(QualityOption, LeavesWhatAFinishChooses) {
    const std::string scene = head + "sphere { 0, 1 finish { specular 0.5 roughness 0.3 //! raytrace: F=schlick-f82\n } }\n" + sphere;
    const RenderJob job = read(scene, {"--quality=exact"});
    const Scene parsed = parse_file("s.pov", job.parse, message_sink(true));
    ASSERT_EQ(parsed.finish_options.size(), 1u);
    EXPECT_EQ(choice_for(parsed, parsed.finish_options[0], job.model).model.terms.F, Fresnel::schlick_f82);
    EXPECT_EQ(choice_for(parsed, {}, job.model).model.terms.F, Fresnel::conductor) << "where nothing is chosen";
    EXPECT_EQ(choice_for(parsed, parsed.finish_options[0], {{"F", "schlick"}}).model.terms.F, Fresnel::schlick) << "an option would win";
}

TEST_F(QualityOption, SaysNothingOfWhatHasNoEffect) {
    here.write("s.pov", head + "sphere { 0, 1 pigment { rgb 1 } }\n");
    const test::Outcome outcome = test::run({"s.pov", "--size=8x6", "--quality", "exact"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(test::run({"s.pov", "--size=8x6", "--F", "conductor"}).err, testing::HasSubstr("no effect here: --F"));
}

TEST_F(QualityOption, MistakesAreTold) {
    here.write("s.pov", head + sphere);
    EXPECT_EQ(test::run({"s.pov", "--quality", "best"}).err, "raytrace: 'best' is no quality; expected one of draft, fast, good, exact\n");
    const test::Outcome course = test::run({"render", "s.pov", "8", "6", "--quality", "good"});
    EXPECT_EQ(course.status, 1);
    EXPECT_EQ(course.err, "raytrace: --quality goes with another shading, not with the course's rules\n");
}

TEST(BesideScene, ComparesWhatGlobalSettingsState) {
    Scene scene;
    scene.settings.max_trace_level = 5, scene.settings.adc_bailout = 0.1;
    EXPECT_EQ(beside_scene("--max-trace-level 4", scene), BesideScene::coarser);
    EXPECT_EQ(beside_scene("--max-trace-level 5", scene), BesideScene::same);
    EXPECT_EQ(beside_scene("--max-trace-level 6", scene), BesideScene::finer);
    EXPECT_EQ(beside_scene("--adc-bailout 0.2", scene), BesideScene::coarser);
    EXPECT_EQ(beside_scene("--adc-bailout 0.05", scene), BesideScene::finer);
    EXPECT_EQ(beside_scene("--ss 3", scene), BesideScene::unrelated);
}

/// A share of the pixels is what the user chose; samples of it that are chosen by an error would be refused.
TEST_F(QualityOption, LeavesTheSamplesToAShareOfThePixels) {
    const RenderJob job = read(head + sphere, {"--quality", "good", "--scale", "2"});
    EXPECT_EQ(job.sampling.method, Sampling::Method::none);
    EXPECT_EQ(job.scale, 2);
    EXPECT_EQ(job.max_trace_level, turned("good").max_trace_level);
}

/// Pixels chosen by an error, a time or a preview are not those of a share, and "draft" gives way.
TEST_F(QualityOption, DraftGivesUpItsShareOfThePixelsWhereOthersChooseThem) {
    EXPECT_EQ(read(head + sphere, {"--quality", "draft"}).scale, 2);
    EXPECT_EQ(read(head + sphere, {"--quality", "draft", "--ss", "3"}).scale, 2);
    for (const Words& words : {Words{"--max-error", "0.01"}, Words{"--time", "1"}, Words{"--preview"}}) {
        Words all = words;
        all.insert(all.begin(), {"--quality", "draft"});
        EXPECT_EQ(read(head + sphere, all).scale, 1) << words.front();
    }
    EXPECT_EQ(read(head + sphere, {"--quality", "draft", "--scale", "1"}).scale, 1);
}

}  // namespace
}  // namespace rt::quality_test
