// Light summed anew is the tracer's where no rule is broken, and what a rule's absence makes of it where one is.
#include "commands/causes/reshading.h"

#include <gtest/gtest.h>

#include "commands/causes/broken_paths.h"
#include "commands/job/course_scene.h"
#include "syntax/parser.h"
#include "trace/camera.h"
#include "trace/tracer.h"
#include "world/compile.h"

namespace rt::reshading_test {
namespace {

/// Glass, a mirror, a transformed box and sphere, both sides of triangles, and shadows of two lamps.
const char* const text = R"(camera { location <0, 1.5, 9> up <0, 1, 0> right <1.3333, 0, 0> look_at <0, 0.3, 0> }
light_source { <6, 8, 9> color rgb <0.9, 0.8, 0.7> }
light_source { <-8, 5, 3> color rgb <0.3, 0.4, 0.6> }
plane { <0, 1, 0>, -1 pigment { color rgb <0.4, 0.6, 0.5> } finish { ambient 0.2 diffuse 0.6 reflection 0.3 } }
sphere { <0.4, 0.3, 3>, 0.8 pigment { color rgbf <0.9, 0.95, 1, 0.8> } finish { ambient 0.1 diffuse 0.3 specular 0.6 roughness 0.2 ior 1.4 } }
sphere { <-1.8, 0.2, 0>, 1.1 pigment { color rgb <0.9, 0.8, 0.3> } finish { ambient 0.1 diffuse 0.5 specular 0.7 roughness 0.25 reflection 0.5 } }
box { <-0.7, -0.7, -0.7>, <0.7, 0.7, 0.7> pigment { color rgb <0.8, 0.3, 0.3> } finish { ambient 0.2 diffuse 0.7 specular 0.4 roughness 0.4 }
  scale <1, 1.5, 0.6> rotate <20, 40, 10> translate <2, 0.4, -0.5> }
sphere { <0, 0, 0>, 0.6 pigment { color rgb <0.3, 0.9, 0.8> } finish { ambient 0.2 diffuse 0.7 specular 0.3 roughness 0.3 }
  scale <1.6, 0.7, 1> rotate <0, 10, 35> translate <2.6, 2.2, 1> }
triangle { <-4, 2, 1>, <-3, 4, 1.2>, <-2, 2.2, 1> pigment { color rgb <0.9, 0.3, 0.9> } finish { ambient 0.1 diffuse 0.8 } }
triangle { <-3, 0, -2>, <3, 0, -3>, <0, 4, -2.5> pigment { color rgb <0.3, 0.3, 0.9> } finish { ambient 0.1 diffuse 0.8 } }
)";

CompileOptions course_options() {
    CompileOptions options;
    options.profile = Profile::csc473;
    return options;
}

CourseRules rules(bool CourseRules::*chosen) {
    CourseRules rules;
    rules.*chosen = true;
    return rules;
}

class ReshadingTest : public testing::TestWithParam<CourseRules> {
protected:
    void SetUp() override {
        ParseOptions options;
        read_as_course(options);
        const MessageSink silent = [](std::string_view) {};
        scene = parse_text({"scene.pov", text}, options, silent);
        world = compile(scene, course_options(), silent);
        TraceOptions trace;
        trace.course = GetParam();
        Tracer tracer(world, trace);
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x) {
                rays.push_back(camera_ray(world.camera, x + 0.5, y + 0.5, 32, 24));
                light.push_back(tracer.camera_ray(rays.back(), logs.emplace_back()).rgb);
            }
    }
    ShadedScene shaded() const { return {scene, world, GetParam()}; }
    /// Most that any ray's light changes.
    double change(const Reshading& how) const {
        double most = 0.0;
        for (std::size_t i = 0; i < logs.size(); ++i) most = std::max(most, length(reshaded(shaded(), logs[i], how) - light[i]));
        return most;
    }
    double change(const PathRules& rules) const {
        double most = 0.0;
        for (std::size_t i = 0; i < rays.size(); ++i)
            most = std::max(most, length(reshaded(shaded(), follow_broken(shaded(), rules, rays[i]), {}) - light[i]));
        return most;
    }

    Scene scene;
    World world;
    std::vector<Ray> rays;
    std::vector<RayLog> logs;
    std::vector<Rgb> light;
};

TEST_P(ReshadingTest, WithoutAMistakeItIsTheTracersLight) {
    EXPECT_LT(change(Reshading{}), 1e-12);
    EXPECT_LT(change(PathRules{}), 1e-9);
}

TEST_P(ReshadingTest, EveryBrokenRuleOfShadingShows) {
    using R = Reshading;
    const R broken[] = {{.ambient = 0.0},
                        {.diffuse = 0.5},
                        {.specular = 0.0},
                        {.reflection = 0.0},
                        {.refraction = 0.0},
                        {.deepest = 1},
                        {.shadows = R::Shadows::none},
                        {.shadows = R::Shadows::everywhere},
                        {.lamps = R::Lamps::first},
                        {.lamps = R::Lamps::white},
                        {.lamps = R::Lamps::faded},
                        {.cosine = R::Cosine::negative_too},
                        {.cosine = R::Cosine::absolute},
                        {.cosine = R::Cosine::none},
                        {.cosine = R::Cosine::times_distance},
                        {.lobe = R::Lobe::other_model},
                        {.lobe = R::Lobe::times_n_dot_l},
                        {.exponent_scale = 4.0},
                        {.normal = R::Normal::to_viewer},
                        {.normal = R::Normal::triangles_turned},
                        {.normal = R::Normal::by_matrix},
                        {.normal = R::Normal::in_object_space},
                        {.normal = R::Normal::not_unit},
                        {.ambient_for_each_lamp = true},
                        {.without_pigment = true},
                        {.untinted_mirrors = true},
                        {.local_unscaled = true},
                        {.hidden_lamps = 1},
                        {.shown_lamps = 3}};
    for (const R& how : broken) EXPECT_GT(change(how), 0.005) << "case " << &how - broken;
    if (!GetParam().beers) {
        EXPECT_GT(change({.unfiltered = true}), 0.01);
    }
}

TEST_P(ReshadingTest, EveryBrokenRuleOfPathsShows) {
    const PathRules broken[] = {
        {.normal = Reshading::Normal::by_matrix}, {.offset = 0.0}, {.offset = -0.001}, {.side_ignored = true}, {.mirror_reversed = true},
        {.distances_in_object_space = true}};
    for (const PathRules& rules : broken) EXPECT_GT(change(rules), 0.01) << "case " << &rules - broken;
}

INSTANTIATE_TEST_SUITE_P(, ReshadingTest,
                         testing::Values(CourseRules{}, rules(&CourseRules::cook_torrance), rules(&CourseRules::fresnel),
                                         rules(&CourseRules::beers)));

}  // namespace
}  // namespace rt::reshading_test
