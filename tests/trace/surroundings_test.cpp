// Mirror rays whose weight the catalogue chooses: one point of a floor under a sky of one colour.
#include <fmt/format.h>

#include "shading/integrals.h"
#include "tests/trace/tracer_scene.h"

namespace rt::surroundings_test {
namespace {

using namespace tracer_test;

const Rgb sky{0.3, 0.5, 0.9};
const Rgb albedo{0.8, 0.5, 0.3};

/// The floor at the origin, seen from `v`; no lamps, no ambient light: what comes back is mirrored sky.
struct Floor {
    ModelChoice choice;
    Finish finish = plain();
    Vec3 v{1.2, 2.0, -0.7};
    TraceOptions options;
    std::vector<std::string> warnings{};
    Features features{};
    RayCounts counts{};

    explicit Floor(Surroundings env) {
        choice.model.env = env;
        choice.model.shares = false;
        choice.s = 0.5;
        choice.alpha = 0.2;
        options.distances = Distances::povray;
        options.adc_bailout = 0.0;
    }
    World world() {
        CompileOptions compile_options;
        compile_options.choose = [this](const Finish&) { return choice; };
        return compile(scene_with({object(floor_plane(), texture(color(albedo), finish))}, {}, sky), compile_options,
                       [this](std::string_view text) { warnings.emplace_back(text); });
    }
    Rgb seen() {
        const World made = world();
        features = made.features;
        Tracer tracer(made, options);
        const Rgb light = tracer.camera_ray({v, unit(-v)}).rgb;
        counts = tracer.counts();
        return light;
    }
    double cos() const { return unit(v).y; }
};

double schlick(double f0, double c) { return f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0); }

TEST(Environment, mirror_takes_ks_of_it) {
    Floor floor(Surroundings::mirror);
    EXPECT_RGB_NEAR(floor.seen(), 0.5 * sky, 1e-15);
    EXPECT_EQ(floor.counts.reflected, 1u);
    EXPECT_TRUE(floor.features.reflects);
}

TEST(Environment, fresnel_weighs_it_by_the_models_term_and_the_channels_index) {
    Floor floor(Surroundings::fresnel);
    EXPECT_RGB_NEAR(floor.seen(), 0.5 * schlick(0.04, floor.cos()) * sky, 1e-15);
    floor.choice.f0 = Rgb(0.9, 0.6, 0.2);
    const Rgb by_channel(schlick(0.9, floor.cos()), schlick(0.6, floor.cos()), schlick(0.2, floor.cos()));
    EXPECT_RGB_NEAR(floor.seen(), 0.5 * by_channel * sky, 1e-15);
    floor.choice.f0.reset();
    floor.choice.eta = Rgb(0.143, 0.375, 1.442), floor.choice.k = Rgb(3.983, 2.386, 1.603);
    floor.choice.model.terms.F = Fresnel::conductor;
    const Rgb gold(F_conductor(0.143, 3.983, floor.cos()), F_conductor(0.375, 2.386, floor.cos()), F_conductor(1.442, 1.603, floor.cos()));
    EXPECT_RGB_NEAR(floor.seen(), 0.5 * gold * sky, 1e-15);
}

TEST(Environment, metallic_tints_the_reflectance_at_normal_incidence) {
    for (const Surroundings env : {Surroundings::fresnel, Surroundings::albedo}) {
        Floor floor(env);
        floor.choice.alpha = 1e-4;
        floor.choice.f0 = Rgb(0.8);
        floor.finish.metallic = 1.0;
        const Rgb want(schlick(0.8 * 0.8, floor.cos()), schlick(0.8 * 0.5, floor.cos()), schlick(0.8 * 0.3, floor.cos()));
        EXPECT_RGB_NEAR(floor.seen(), 0.5 * want * sky, env == Surroundings::albedo ? 1e-3 : 1e-15);
    }
}

TEST(Environment, albedo_weighs_it_by_the_integral_of_the_lobe) {
    Floor floor(Surroundings::albedo);
    for (const double alpha : {0.04, 0.5}) {
        floor.choice.alpha = alpha;
        const double E = directional_albedo({}, interface_of(1.5), alpha, floor.cos());
        EXPECT_RGB_NEAR(floor.seen(), 0.5 * E * sky, 1e-3);
    }
    floor.choice.alpha = 0.0;
    EXPECT_RGB_NEAR(floor.seen(), 0.5 * schlick(0.04, floor.cos()) * sky, 1e-15) << "the limit is Fresnel's mirror";
}

TEST(Environment, effects_form_as_printed_and_cut) {
    Floor floor(Surroundings::ct_effects);
    floor.choice.dw = 0.5;
    const double weight = 0.5 * 0.5 * schlick(0.04, floor.cos()) / (4.0 * 0.04 * pi * floor.cos());
    EXPECT_RGB_NEAR(floor.seen(), weight * sky, 1e-15);
    floor.choice.model.env_limit = 0.01;
    ASSERT_GT(weight, 0.01);
    EXPECT_RGB_NEAR(floor.seen(), 0.01 * sky, 1e-15);
}

TEST(Environment, replaces_the_finishs_own_reflection_and_says_so_once) {
    Floor floor(Surroundings::fresnel);
    floor.finish.reflection.min = floor.finish.reflection.max = Rgb(0.7);
    floor.finish.reflection.exponent = 2.0;
    EXPECT_RGB_NEAR(floor.seen(), 0.5 * schlick(0.04, floor.cos()) * sky, 1e-15);
    ASSERT_EQ(floor.warnings.size(), 1u);
    EXPECT_NE(floor.warnings[0].find("The choice of 'env' replaces the 'reflection' of the finish"), std::string::npos);
    floor.choice.model.env = Surroundings::finish;
    floor.finish.reflection.exponent = 1.0;
    EXPECT_RGB_NEAR(floor.seen(), 0.7 * sky, 1e-15);
    EXPECT_EQ(floor.warnings.size(), 1u);
}

TEST(Environment, costs_no_ray_where_nothing_is_highlighted) {
    Floor floor(Surroundings::mirror);
    floor.choice.s = 0.0;
    EXPECT_EQ(floor.seen(), Rgb(0.0));
    EXPECT_EQ(floor.counts.reflected, 0u);
    EXPECT_FALSE(floor.features.reflects);
}

TEST(Environment, ends_where_its_weight_is_below_the_bailout) {
    Floor floor(Surroundings::mirror);
    floor.choice.s = 0.1;
    floor.options.adc_bailout = 0.09;
    EXPECT_RGB_NEAR(floor.seen(), 0.1 * sky, 1e-15);
    floor.options.adc_bailout = 0.11;
    EXPECT_EQ(floor.seen(), Rgb(0.0));
    floor.options.adc_bailout = 0.0;
    floor.options.max_trace_level = 1;
    EXPECT_EQ(floor.seen(), Rgb(0.0));
}

TEST(Environment, is_in_the_log_as_a_reflected_ray) {
    Floor floor(Surroundings::mirror);
    const World world = floor.world();
    Tracer tracer(world, floor.options);
    RayLog log;
    const Radiance light = tracer.camera_ray({floor.v, unit(-floor.v)}, log);
    ASSERT_EQ(log.nodes.size(), 2u);
    EXPECT_EQ(log.nodes[1].kind, RayNode::Kind::reflected);
    EXPECT_EQ(log.nodes[1].factor, Rgb(0.5));
    EXPECT_EQ(log.nodes[1].exponent, 1.0);
    EXPECT_RGB_NEAR(log.nodes[0].reflection, light.rgb, 1e-15);
}

TEST(Environment, of_a_mirror_without_width_shows_the_scene) {
    // A ball of emission 1 above the floor, in the mirror direction of the view.
    Floor floor(Surroundings::fresnel);
    floor.choice.alpha = 0.0, floor.choice.s = 1.0, floor.choice.f0 = Rgb(0.98);
    Finish glow = plain();
    glow.emission = Rgb(1.0);
    CompileOptions compile_options;
    compile_options.choose = [&](const Finish& f) { return f.emission == Rgb(0.0) ? floor.choice : ModelChoice{}; };
    const Vec3 above(-floor.v.x, floor.v.y, -floor.v.z);
    const World world = compile(scene_with({object(floor_plane(), texture(color(albedo), plain())),
                                            object(Sphere{above, 0.5}, texture(color(Rgb(0.2, 0.4, 0.6)), glow))},
                                           {point_light({1.0, 5.0, 1.0})}, sky),
                                compile_options, [](std::string_view) {});
    Tracer tracer(world, floor.options);
    EXPECT_RGB_NEAR(tracer.camera_ray({floor.v, unit(-floor.v)}).rgb, schlick(0.98, floor.cos()) * Rgb(0.2, 0.4, 0.6), 1e-12);
}

TEST(Environment, behind_glass_reflects_totally_beyond_the_critical_angle_only) {
    // From inside a glass ball, head on: F of the inner side is that of the outer one.
    Floor floor(Surroundings::fresnel);
    floor.choice.s = 1.0;
    Interior glass;
    glass.ior = 1.5;
    Scene scene = scene_with({object(Sphere{Vec3(0.0), 1.0}, texture(color(Rgb(1.0), 0.0, 1.0), plain()), glass)}, {}, sky);
    CompileOptions compile_options;
    compile_options.choose = [&](const Finish&) { return floor.choice; };
    const World world = compile(scene, compile_options, [](std::string_view) {});
    Tracer tracer(world, floor.options);
    RayLog log;
    tracer.camera_ray({Vec3(0, 0, -5), unit(Vec3(0.1, 0.0, 1.0))}, log);
    const double sin_outside = 5.0 * 0.1 / std::sqrt(1.01), F = schlick(0.04, std::sqrt(1.0 - sqr(sin_outside)));
    int reflected = 0;
    for (const RayNode& node : log.nodes) {
        if (node.kind != RayNode::Kind::reflected) continue;
        ++reflected;
        EXPECT_NEAR(node.factor.g, F, 1e-12) << "outside and, at the angle behind, inside";
    }
    EXPECT_GE(reflected, 3);
}

}  // namespace
}  // namespace rt::surroundings_test
