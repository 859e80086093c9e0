// No pixel without a number: tiles of pictures with every combination of terms at the extremes of geometry and parameters.
#include <gtest/gtest.h>

#include "shading/names.h"
#include "tests/trace/tracer_scene.h"
#include "trace/render.h"

namespace rt::finite_test {
namespace {

using namespace tracer_test;

constexpr double alphas[] = {0.0, 1e-8, 1e-150, 2.0, 1e6};
constexpr double indices[] = {1.0, 1e300, 0.5};

/// A row of small balls, a floor that the camera sees at grazing angles down to its horizon, and lamps: above, at grazing height, at the
/// camera, on the floor, on a ball, below.
Scene scene_of(const std::vector<Finish>& finishes) {
    Scene scene = scene_with({}, {}, Rgb(0.5));
    for (std::size_t i = 0; i < finishes.size(); ++i) {
        const double x = static_cast<double>(i) - 0.5 * static_cast<double>(finishes.size() - 1);
        scene.objects.push_back(object(Sphere{Vec3(x, 0.5, 0), 0.5}, texture(color(Rgb(0.8, 0.5, 0.0)), finishes[i])));
    }
    scene.objects.push_back(object(floor_plane(), texture(color(Rgb(0.3)), finishes.front())));
    for (const Vec3& lamp : {Vec3(2, 5, -3), Vec3(1e6, 1e-3, 0), Vec3(0, 0.2, -6), Vec3(0.3, 0.0, -1.0), Vec3(0, 1, 0), Vec3(0, -3, 0)})
        scene.lights.push_back(point_light(lamp));
    scene.camera.location = {0, 0.2, -6};
    scene.camera.direction = {0, 0, 1.5}, scene.camera.right = {static_cast<double>(finishes.size()), 0, 0}, scene.camera.up = {0, 1.2, 0};
    return scene;
}

/// Renders the finishes with `choose` and expects numbers that are not negative.
void expect_numbers(const std::vector<Finish>& finishes, const std::function<ModelChoice(const Finish&)>& choose, const std::string& what) {
    CompileOptions compile_options;
    compile_options.choose = choose;
    compile_options.threads = 1;
    const World world = compile(scene_of(finishes), compile_options, [](std::string_view) {});
    RenderOptions options;
    options.width = 16 * static_cast<int>(finishes.size()), options.height = 20;
    options.threads = 1;
    options.trace.adc_bailout = 0.0;
    const RenderResult result = render(world, options);
    EXPECT_EQ(result.non_finite, 0u) << what;
    for (const Pixel& p : result.film.pixels) ASSERT_TRUE(p.r >= 0.0f && p.g >= 0.0f && p.b >= 0.0f) << what;
}

/// One finish for each width and index; which one it is stands in phong_size, for want of a name.
std::vector<Finish> extremes() {
    std::vector<Finish> finishes;
    for (std::size_t i = 0; i < std::size(alphas) * std::size(indices); ++i) {
        finishes.push_back(plain(Rgb(0.1), 0.6));
        finishes.back().phong_size = static_cast<double>(i);
        finishes.back().metallic = i % 2 == 0 ? 0.0 : 1.0;
    }
    return finishes;
}

void set_extremes(const Finish& finish, ModelChoice& choice) {
    const auto i = static_cast<std::size_t>(finish.phong_size);
    choice.s = 0.5;
    choice.alpha = alphas[i % std::size(alphas)];
    choice.eta = Rgb(indices[i / std::size(alphas)]);
    choice.k = Rgb(0.0, 1e-300, choice.eta->b == 1.0 ? 1e300 : 3.0);
    choice.model.oren_nayar = OrenNayar(0.5);
}

class EveryTerm : public testing::TestWithParam<std::tuple<Distribution, Masking>> {};

TEST_P(EveryTerm, MakesNumbersWithEveryFresnelAndDiffuseTerm) {
    const auto [D, G] = GetParam();
    // Each diffuse term goes along with another kind of surroundings: what they add does not depend on each other.
    constexpr Surroundings envs[] = {Surroundings::mirror, Surroundings::fresnel, Surroundings::albedo, Surroundings::ct_effects};
    static_assert(std::size(envs) == std::tuple_size_v<decltype(diffuse_names)>);
    for (const auto& F : fresnel_names) {
        for (std::size_t i = 0; i < std::size(envs); ++i) {
            const auto choose = [&](const Finish& finish) {
                ModelChoice choice;
                choice.model.terms = {.D = D, .G = G, .F = F.value};
                choice.model.diffuse = diffuse_names[i].value;
                choice.model.env = envs[i];
                set_extremes(finish, choice);
                return choice;
            };
            expect_numbers(extremes(), choose, std::string(F.name) + " " + std::string(diffuse_names[i].name));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryTerm,
                         testing::Combine(testing::Values(Distribution::ggx, Distribution::beckmann, Distribution::blinn,
                                                          Distribution::blinn_inverse_roughness, Distribution::gaussian),
                                          testing::Values(Masking::ggx, Masking::ggx_hc, Masking::cook_torrance, Masking::beckmann,
                                                          Masking::beckmann_hc, Masking::beckmann_rational, Masking::none)));

TEST(EveryVariant, MakesNumbers) {
    const std::pair<std::string, std::function<void(ModelChoice&)>> variants[] = {
        {"phong", [](ModelChoice& c) { c.model.specular = SurfaceModel::Specular::phong, c.exponent = 1e30; }},
        {"phong without gate", [](ModelChoice& c) { c.model.specular = SurfaceModel::Specular::phong, c.model.phong_gate = false; }},
        {"phong clamped after",
         [](ModelChoice& c) { c.model.specular = SurfaceModel::Specular::phong, c.model.clamp_after = true, c.exponent = 2.5; }},
        {"blinn-phong", [](ModelChoice& c) { c.model.specular = SurfaceModel::Specular::blinn_phong, c.exponent = 1e300; }},
        {"raw", [](ModelChoice& c) { c.model.terms.without_cosine = true; }},
        {"clamped denominator", [](ModelChoice& c) { c.model.terms.clamped_denominator = true; }},
        {"half of n and v", [](ModelChoice& c) { c.model.terms.half_of_normal_and_view = true; }},
        {"fresnel at view", [](ModelChoice& c) { c.model.terms.fresnel_at_view = true; }},
        {"lecture", [](ModelChoice& c) { c.model.lecture = true, c.model.terms = lecture_terms(); }},
        {"per light", [](ModelChoice& c) { c.model.ambient_per_light = true, c.model.attenuate_ambient = true; }},
        {"factors", [](ModelChoice& c) { c.norm = 4.0, c.units = pi, c.dw = 1e300; }},
    };
    for (const auto& [name, change] : variants) {
        const auto choose = [&](const Finish& finish) {
            ModelChoice choice;
            set_extremes(finish, choice);
            change(choice);
            return choice;
        };
        expect_numbers(extremes(), choose, name);
    }
}

}  // namespace
}  // namespace rt::finite_test
