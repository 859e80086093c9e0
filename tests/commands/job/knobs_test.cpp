// The table of knobs: every value is one of a render, and each is felt where it should be.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "commands/base/values.h"
#include "commands/job/job_steps.h"
#include "commands/job/knobs.h"
#include "commands/job/render_arguments.h"
#include "commands/job/text.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::knobs_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Words = std::vector<std::string>;

const std::string head =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -4> look_at 0 } light_source { <2, 3, -4> rgb 1 }\n";
const std::string plain_sphere = "sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } }\n";
const std::string shiny_sphere = "sphere { 0, 1 pigment { rgb 1 } finish { specular 0.5 roughness 0.3 } }\n";
const std::string mirrors =
    "plane { y, -1 pigment { rgb 0.5 } finish { reflection 0.6 } } sphere { 0, 1 pigment { rgb 1 } finish { reflection 0.7 } }\n";

/// A job with its scene and world, as `words` ask for it.
class Prepared {
public:
    Prepared(const std::string& scene_text, const Words& words, const Words& turned = {}) {
        here_.write("s.pov", scene_text);
        Words line{"s.pov", "--size=24x18"};
        line.insert(line.end(), words.begin(), words.end());
        std::string help;
        job = *parse_render_arguments(line, help);
        scene = read_scene(job, message_sink(true));
        for (const std::string& word : turned) turn(job, word);
        world = build_world(job, scene, message_sink(true));
    }

    std::vector<Pixel> pixels() const { return render(world, render_options(job, scene)).film.pixels; }

    Words felt() const {
        Words names;
        for (const Knob& knob : knobs())
            if (knob.felt({job, scene, world})) names.emplace_back(knob.name);
        return names;
    }

    RenderJob job;
    Scene scene;
    World world;

private:
    test::Workplace here_;
};

Words felt(const std::string& scene, const Words& words = {}) { return Prepared(scene, words).felt(); }

bool is_of_course(const KnobValue& value) { return value.words.starts_with("-gi"); }

TEST(Knobs, have_names_of_their_own_and_values_in_the_same_words) {
    Words names;
    for (const Knob& knob : knobs()) {
        names.emplace_back(knob.name);
        EXPECT_EQ(find_knob(knob.name), &knob);
        EXPECT_FALSE(knob.changes.empty()) << knob.name;
        EXPECT_GE(knob.values.size(), 2u) << knob.name;
        Words values, words;
        for (const KnobValue& value : knob.values) values.emplace_back(value.name), words.emplace_back(value.words);
        const bool has_plain = std::find(values.begin(), values.end(), knob.plain) != values.end();
        EXPECT_TRUE(knob.plain.empty() || has_plain) << knob.name;
        for (Words list : {values, words}) {
            std::sort(list.begin(), list.end());
            EXPECT_EQ(std::unique(list.begin(), list.end()), list.end()) << knob.name;
        }
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
    EXPECT_EQ(find_knob("volume"), nullptr);
}

TEST(Knobs, every_value_is_an_option_of_a_render_and_means_the_same_turned) {
    for (const Knob& knob : knobs()) {
        for (const KnobValue& value : knob.values) {
            if (is_of_course(value)) continue;
            const Prepared asked(head + shiny_sphere + mirrors, split(value.words, ' '));
            const Prepared turned(head + shiny_sphere + mirrors, {}, {std::string(knob.values.front().words), std::string(value.words)});
            EXPECT_EQ(asked.pixels(), turned.pixels()) << value.words;
        }
    }
}

TEST(Knobs, plain_values_are_those_of_a_plain_run) {
    const Prepared plain(head + shiny_sphere + mirrors, {});
    for (const Knob& knob : knobs()) {
        for (const KnobValue& value : knob.values) {
            if (value.name != knob.plain || is_of_course(value)) continue;
            const Prepared turned(head + shiny_sphere + mirrors, {}, {std::string(value.words)});
            EXPECT_EQ(plain.pixels(), turned.pixels()) << value.words;
        }
    }
}

TEST(Knobs, are_felt_where_the_scene_has_what_they_are_about) {
    EXPECT_THAT(felt(head + plain_sphere), ElementsAre("samples", "scale", "shadows"));
    EXPECT_THAT(felt(head + shiny_sphere), ElementsAre("samples", "scale", "shadows", "fresnel", "distribution", "masking", "specular-aa"));
    EXPECT_THAT(felt(head + shiny_sphere, {"--shading", "povray"}), ElementsAre("samples", "scale", "shadows"));
    EXPECT_THAT(felt(head + mirrors), ElementsAre("samples", "scale", "max-trace-level", "adc-bailout", "shadows"));
    const std::string triangle = "triangle { <-1, 0, 0>, <1, 0, 0>, <0, 1, 0> pigment { rgb 1 } }\n";
    EXPECT_THAT(felt(head + triangle), ElementsAre("samples", "scale", "shadows")) << "one triangle is asked without an index";
    EXPECT_THAT(felt(head + triangle, {"--index", "embree"}), ElementsAre("samples", "scale", "shadows", "precision"));
    EXPECT_THAT(felt(head + mirrors, {"--profile", "csc473"}), ElementsAre("samples", "scale", "max-trace-level"));
}

TEST(Knobs, of_shadows_are_felt_where_something_casts_one) {
    const auto scene = [](const std::string& light, const std::string& object) {
        return "#version 3.7; global_settings { assumed_gamma 1 } light_source { <2, 3, -4> rgb 1 " + light + " } sphere { 0, 1 " + object +
               " }";
    };
    EXPECT_THAT(felt(scene("", "")), ElementsAre("samples", "scale", "shadows"));
    EXPECT_THAT(felt(scene("shadowless", "")), ElementsAre("samples", "scale"));
    EXPECT_THAT(felt(scene("", "no_shadow")), ElementsAre("samples", "scale"));
    EXPECT_THAT(felt(scene("", ""), {"+Q3"}), ElementsAre("samples", "scale"));
    const std::string area = "area_light x, y, 3, 3 ";
    EXPECT_THAT(felt(scene(area, "")), ElementsAre("samples", "scale", "shadows", "light-samples"));
    EXPECT_THAT(felt(scene("area_light x, y, 1, 1", "")), ElementsAre("samples", "scale", "shadows"));
    EXPECT_THAT(felt(scene(area + "shadowless", "")), ElementsAre("samples", "scale"));
    EXPECT_THAT(felt(scene(area, ""), {"--shadows=none"}), ElementsAre("samples", "scale", "shadows"));
    EXPECT_THAT(felt(scene(area + "area_illumination", ""), {"+Q3"}), ElementsAre("samples", "scale", "light-samples"));
    EXPECT_THAT(felt(scene(area, ""), {"--light-samples=1"}), ElementsAre("samples", "scale", "shadows", "light-samples"));
}

TEST(Knobs, indirect_samples_are_of_the_course) {
    Prepared course(head + plain_sphere, {"--profile", "csc473"});
    ASSERT_TRUE(course.job.course);
    EXPECT_THAT(course.felt(), testing::Not(testing::Contains("indirect-samples")));
    turn(course.job, "-gi_samples=8,2");
    EXPECT_THAT(course.job.course->indirect_samples, ElementsAre(8, 2));
    EXPECT_THAT(course.felt(), testing::Contains("indirect-samples"));
    for (const KnobValue& value : find_knob("indirect-samples")->values) turn(course.job, value.words);
    RenderJob plain;
    EXPECT_THROW(turn(plain, "-gi_samples=8,2"), OptionError);
    EXPECT_THROW(turn(course.job, "-gi_samples=8,0"), OptionError);
}

TEST(Knobs, ways_to_sample_replace_each_other) {
    RenderJob job;
    turn(job, "--aa 2,0.1,4");
    turn(job, "--ss 2");
    EXPECT_EQ(job.sampling.method, Sampling::Method::grid);
    EXPECT_EQ(job.sampling.depth, 2);
    turn(job, "--F dielectric");
    EXPECT_EQ(job.sampling.method, Sampling::Method::grid);
    turn(job, "--ss 1");
    EXPECT_EQ(job.sampling.method, Sampling::Method::none);
    turn(job, "--aa 1,0.2,3");
    EXPECT_EQ(job.sampling.method, Sampling::Method::povray1);
    EXPECT_THAT(job.notes, IsEmpty());
}

TEST(Knobs, words_that_are_no_options_are_refused) {
    RenderJob job;
    for (const char* words : {"scene.pov", "--width 3", "--ss", "--ss many"}) EXPECT_THROW(turn(job, words), OptionError) << words;
}

TEST(Depth, of_the_command_line_replaces_the_scenes) {
    const std::string shallow = head + mirrors + "global_settings { max_trace_level 2 }";
    EXPECT_EQ(Prepared(head + mirrors, {"--max-trace-level=2"}).pixels(), Prepared(shallow, {}).pixels());
    EXPECT_NE(Prepared(head + mirrors, {}).pixels(), Prepared(shallow, {}).pixels());
    EXPECT_EQ(Prepared(shallow, {"--max-trace-level", "5"}).pixels(), Prepared(head + mirrors, {}).pixels());
    const std::string early = head + mirrors + "global_settings { adc_bailout 0.5 }";
    EXPECT_EQ(Prepared(head + mirrors, {"--adc-bailout=0.5"}).pixels(), Prepared(early, {}).pixels());
    EXPECT_NE(Prepared(head + mirrors, {}).pixels(), Prepared(early, {}).pixels());
}

TEST(Depth, under_the_courses_rules_counts_the_camera_ray_too) {
    Prepared course(head + mirrors, {"--profile=csc473", "--max-trace-level=3"});
    EXPECT_EQ(course.job.course->further_rays, 2);
    turn(course.job, "--max-trace-level 1");
    EXPECT_EQ(course.job.course->further_rays, 0);
    EXPECT_EQ(Prepared(head + mirrors, {"--profile=csc473"}).job.course->further_rays, 6);
}

const std::string boxes = "box { <-2, -1.2, -1>, <2, -1, 1> pigment { rgb 1 } } sphere { y, 0.4 pigment { rgb 1 } }\n";

std::string under_area_light(const std::string& counts) {
    return "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -4> look_at 0 } light_source { <0.2, 4, -1> rgb 1 " +
           counts + " } " + boxes;
}

TEST(LightSamples, are_as_if_the_scene_stated_so_few) {
    const std::string nine = under_area_light("area_light 2*x, 2*z, 9, 2 adaptive 1");
    const Prepared three(under_area_light("area_light 2*x, 2*z, 3, 2 adaptive 1"), {});
    EXPECT_EQ(Prepared(nine, {"--light-samples=3"}).pixels(), three.pixels());
    EXPECT_NE(Prepared(nine, {}).pixels(), three.pixels());
    EXPECT_EQ(Prepared(nine, {"--light-samples", "1"}).pixels(), Prepared(under_area_light(""), {}).pixels());
    EXPECT_EQ(Prepared(nine, {"--light-samples=3"}, {"--light-samples all"}).pixels(), Prepared(nine, {}).pixels());
}

double error_to(const std::vector<Pixel>& truth, const std::vector<Pixel>& pixels) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double d = double{std::fmin(1.0f, pixels[i].g)} - double{std::fmin(1.0f, truth[i].g)};
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(pixels.size()));
}

TEST(SpecularAa, brings_narrow_highlights_nearer_to_their_mean) {
    std::string balls =
        "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 0, -20> look_at 0 angle 30 }\n"
        "light_source { <9, 9, -20> rgb 1 } #default { finish { ambient 0 diffuse 0 specular 0.5 roughness 0.2 } }\n";
    for (int i = 0; i < 48; ++i)
        balls += fmt::format("sphere {{ <{}, {}, 0>, 0.55 pigment {{ rgb 1 }} }}\n", i % 8 * 1.3 - 4.5, i / 8 * 1.3 - 3.2);
    const std::vector<Pixel> truth = Prepared(balls, {"--ss=12"}).pixels(), plain = Prepared(balls, {}).pixels();
    EXPECT_EQ(Prepared(balls, {"--specular-aa=off"}).pixels(), plain);
    EXPECT_LT(error_to(truth, Prepared(balls, {"--specular-aa=on"}).pixels()), 0.75 * error_to(truth, plain));
    EXPECT_LT(error_to(truth, Prepared(balls, {"--ss=2", "--specular-aa=on"}).pixels()),
              0.75 * error_to(truth, Prepared(balls, {"--ss=2"}).pixels()));
}

TEST(SpecularAa, is_no_option_of_povrays_shading) {
    EXPECT_NO_THROW(Prepared(head + shiny_sphere, {"--shading=povray", "--specular-aa=off"}));
    try {
        Prepared(head + shiny_sphere, {"--shading=povray", "--specular-aa=on"});
        ADD_FAILURE();
    } catch (const OptionError& error) {
        EXPECT_STREQ(error.what(),
                     "--specular-aa goes with the general shading: POV-Ray's own highlights have no width that it could change");
    }
}

TEST(Shading, of_the_course_has_shadows_of_its_own) {
    for (const char* option : {"--adc-bailout=0.1", "--shadows=full", "--light-samples=2", "--specular-aa=off"}) {
        const std::string name = std::string(option).substr(0, std::string(option).find('='));
        try {
            Prepared(head + plain_sphere, {"--profile=csc473", option});
            ADD_FAILURE() << option;
        } catch (const OptionError& error) {
            EXPECT_EQ(error.what(), name + " goes with another shading, not with the course's rules");
        }
    }
}

TEST(Knobs, that_were_turned_are_told_in_the_picture) {
    const auto options = [](const Words& words) {
        const Prepared prepared(head + plain_sphere, words);
        return picture_metadata(prepared.job, prepared.scene).text.at(2).second;
    };
    EXPECT_THAT(options({"--shadows=opaque", "--light-samples=2", "--max-trace-level=3", "--adc-bailout=0.5", "--specular-aa=on"}),
                testing::EndsWith(" gamma=1 max-trace-level=3 adc-bailout=0.5 shadows=opaque light-samples=2 specular-aa=on"));
    EXPECT_THAT(options({}), testing::EndsWith(" gamma=1"));
}

TEST(Knobs, have_values_in_words_that_are_known) {
    const auto error_of = [](const char* words) -> std::string {
        RenderJob job;
        try {
            turn(job, words);
        } catch (const OptionError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(error_of("--shadows soft"), "'soft' is no kind of shadows; expected one of full, opaque, none");
    EXPECT_EQ(error_of("--light-samples 0"), "light-samples: 0 is outside 1 to 1000000");
    EXPECT_EQ(error_of("--light-samples few"), "light-samples: 'few' is no number");
}

}  // namespace
}  // namespace rt::knobs_test
