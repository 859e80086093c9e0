// Models of the shading catalogue as they come out of the tracer: one point of a floor, against the formulas as their texts print them.
#include <functional>

#include "shading/povray_finish.h"
#include "shading/surface_model.h"
#include "tests/trace/tracer_scene.h"

namespace rt::catalogue_test {
namespace {

using namespace tracer_test;

const Rgb albedo{0.8, 0.5, 0.3};
const Rgb ambient{0.05, 0.06, 0.07};
constexpr double diffuse = 0.7, specular = 0.4, roughness = 0.5, width = 0.25;

/// The point (0, 0, 0) seen from `v`, lit from `l` (both of any length; no shadow, no attenuation).
struct Case {
    Vec3 v{1.2, 2.0, -0.7};
    std::vector<Vec3> lamps{{-2.0, 5.0, 1.5}};
    LampRules rules{};
    std::optional<Vec3> spot_at{};  ///< the lamps are spotlights
    double tightness = 10.0;
    std::function<void(Finish&)> change = [](Finish&) {};
    Rgb global_ambient{1.0};
    std::uint64_t mutable shadow_rays = 0;  ///< of the last call

    Rgb traced(const ModelChoice& choice) const {
        Finish finish = plain(ambient, diffuse);
        finish.specular = specular;
        finish.roughness = roughness;
        change(finish);
        std::vector<Light> lights;
        for (const Vec3& lamp : lamps) {
            lights.push_back(point_light(lamp));
            if (!spot_at) continue;
            lights.back().type = Light::Type::spotlight;
            lights.back().point_at = *spot_at;
            lights.back().tightness = tightness;
        }
        Scene scene = scene_with({object(floor_plane(), texture(color(albedo), finish))}, lights);
        scene.settings.ambient_light = global_ambient;
        CompileOptions options;
        options.choose = [&](const Finish&) { return choice; };
        const World world = compile(scene, options, [](std::string_view) {});
        TraceOptions trace;
        trace.distances = Distances::povray;
        trace.lamps = rules;
        Tracer tracer(world, trace);
        const Rgb result = tracer.camera_ray({v, unit(-v)}).rgb;
        shadow_rays = tracer.counts().shadow;
        return result;
    }

    // The angles as the texts have them.
    static constexpr Vec3 n() { return {0, 1, 0}; }
    Vec3 l() const { return unit(lamps[0]); }
    Vec3 eye() const { return unit(v); }
    Vec3 h() const { return unit(l() + eye()); }
    double nl() const { return dot(n(), l()); }
    double nv() const { return dot(n(), eye()); }
    double nh() const { return dot(n(), h()); }
    double vh() const { return dot(eye(), h()); }
};

ModelChoice with(SurfaceModel::Specular kind) {
    ModelChoice choice;
    choice.model.specular = kind;
    choice.model.shares = false;
    return choice;
}

double schlick(double f0, double c) { return f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0); }

TEST(Catalogue, phong_and_blinn_phong) {
    const Case c;
    ModelChoice choice = with(SurfaceModel::Specular::phong);
    choice.exponent = 12.0;
    const Vec3 r = 2.0 * c.nl() * c.n() - c.l();
    const Rgb base = albedo * ambient + diffuse * c.nl() * albedo;
    EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(specular * std::pow(std::max(0.0, dot(r, c.eye())), 12.0)), 1e-12);
    choice.model.specular = SurfaceModel::Specular::blinn_phong;
    EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(specular * std::pow(c.nh(), 12.0)), 1e-12);
    choice.exponent.reset();  // from roughness: 2 / r^2 - 2
    EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(specular * std::pow(c.nh(), 6.0)), 1e-12);
    choice.model.specular = SurfaceModel::Specular::none;
    EXPECT_RGB_NEAR(c.traced(choice), base, 1e-12);
}

TEST(Catalogue, phong_without_its_gate_shines_on_the_far_side) {
    Case c;
    c.lamps = {{-3.0, -0.2, 2.0}};
    ModelChoice choice = with(SurfaceModel::Specular::phong);
    choice.exponent = 3.0;
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient, 1e-12);
    choice.model.phong_gate = false;
    const Vec3 r = 2.0 * c.nl() * c.n() - c.l();
    ASSERT_GT(dot(r, c.eye()), 0.1);
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient + Rgb(specular * std::pow(dot(r, c.eye()), 3.0)), 1e-12);
}

TEST(Catalogue, cook_torrance_with_other_terms) {
    const Case c;
    ModelChoice choice;
    choice.model.terms = {.D = Distribution::beckmann, .G = Masking::cook_torrance, .F = Fresnel::schlick};
    const double tan2 = 1.0 / sqr(c.nh()) - 1.0;
    const double D = std::exp(-tan2 / sqr(width)) / (pi * sqr(width) * std::pow(c.nh(), 4.0));
    const double G = std::min({1.0, 2.0 * c.nh() * c.nv() / c.vh(), 2.0 * c.nh() * c.nl() / c.vh()});
    const double lobe = specular * D * G / (4.0 * c.nv());
    const Rgb base = albedo * ambient + (1.0 - specular) * diffuse * c.nl() * albedo;
    EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(lobe * schlick(0.04, c.vh())), 1e-12);
    choice.f0 = Rgb(0.9, 0.6, 0.2);
    EXPECT_RGB_NEAR(c.traced(choice), base + lobe * Rgb(schlick(0.9, c.vh()), schlick(0.6, c.vh()), schlick(0.2, c.vh())), 1e-12);
    choice.model.terms.fresnel_at_view = true;
    EXPECT_RGB_NEAR(c.traced(choice), base + lobe * Rgb(schlick(0.9, c.nv()), schlick(0.6, c.nv()), schlick(0.2, c.nv())), 1e-12);
    choice.units = pi;
    choice.model.terms.F = Fresnel::one;
    EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(pi * lobe), 1e-12);
}

/// POV-Ray's least cosine of 1e-10 is for its own finish alone: at n.l = n.v = v.h = 1e-12 the lobe is D / (4 n.v), F = G = 1.
TEST(Catalogue, a_lamp_counts_at_any_positive_cosine) {
    const Case c{.v = {0.0, 1e-12, -1.0}, .lamps = {{0.0, 1e-12, 1.0}}};
    ModelChoice choice = with(SurfaceModel::Specular::microfacet);
    choice.model.terms.G = Masking::cook_torrance;
    const double lobe = specular / (pi * width * width) / 4e-12;
    EXPECT_NEAR(c.traced(choice).g / lobe, 1.0, 1e-9);
}

TEST(Catalogue, the_effects_form_and_the_lecture_as_printed) {
    const Case c;
    const double m = width, tan2 = 1.0 / sqr(c.nh()) - 1.0, dw = 0.5;
    const double D = std::exp(-tan2 / sqr(m)) / std::pow(c.nh(), 4.0);
    const double halved = std::min({0.5, c.nh() * c.nv() / c.vh(), c.nh() * c.nl() / c.vh()});
    ModelChoice choice = with(SurfaceModel::Specular::microfacet);
    choice.model.terms = effects_terms(1.0, false);
    choice.dw = dw;
    const Rgb base = albedo * ambient + diffuse * c.nl() * albedo;
    const double B = dw * specular / (2.0 * sqr(m) * pi);
    EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(B * schlick(0.04, c.nv()) * D * halved / c.nv()), 1e-12);

    choice = with(SurfaceModel::Specular::microfacet);
    choice.model.terms = lecture_terms();
    choice.model.lecture = true;
    const double cos = c.vh(), g = std::sqrt(1.5 * 1.5 + cos * cos - 1.0);
    const double F = 0.5 * sqr((g - cos) / (g + cos)) * (1.0 + sqr((cos * (g + cos) - 1.0) / (cos * (g - cos) + 1.0)));
    const Rgb weight(1.0 - grey(ambient) - specular);
    const Rgb want = albedo * ambient + weight * c.nl() * albedo + Rgb(specular * D / (4.0 * sqr(m)) * (2.0 * halved) * F / (pi * c.nv()));
    EXPECT_RGB_NEAR(c.traced(choice), want, 1e-12);
}

TEST(Catalogue, diffuse_terms) {
    Case c;
    ModelChoice choice = with(SurfaceModel::Specular::none);
    choice.model.diffuse = Diffuse::none;
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient, 1e-15);
    choice.model.diffuse = Diffuse::oren_nayar;
    choice.model.oren_nayar = OrenNayar(0.6);
    // Their angles: a the larger, b the smaller inclination.
    const double tl = std::acos(c.nl()), tv = std::acos(c.nv());
    const Vec3 pl = c.l() - c.nl() * c.n(), pv = c.eye() - c.nv() * c.n();
    const double cos_phi = dot(unit(pl), unit(pv)), s2 = 0.36;
    const double A = 1.0 - 0.5 * s2 / (s2 + 0.33), B = 0.45 * s2 / (s2 + 0.09);
    const double factor = A + B * std::max(0.0, cos_phi) * std::sin(std::max(tl, tv)) * std::tan(std::min(tl, tv));
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient + factor * diffuse * c.nl() * albedo, 1e-12);
}

TEST(Catalogue, gooch_is_the_mean_over_the_lamps_and_has_no_shadow) {
    Case c;
    c.lamps.push_back({3.0, -1.0, 0.5});  // below the floor: the cool side
    ModelChoice choice = with(SurfaceModel::Specular::none);
    choice.model.diffuse = Diffuse::gooch;
    const Rgb kd = diffuse * albedo, cool = Rgb(0, 0, 0.4) + 0.2 * kd, warm = Rgb(0.4, 0.4, 0) + 0.6 * kd;
    Rgb want = albedo * ambient;
    for (const Vec3& lamp : c.lamps) {
        const double x = 0.5 * (1.0 + unit(lamp).y);
        want += 0.5 * (x * warm + (1.0 - x) * cool);
    }
    EXPECT_RGB_NEAR(c.traced(choice), want, 1e-12);
    choice.model.gooch.as_printed = true;
    EXPECT_RGB_NEAR(c.traced(choice), 2.0 * albedo * ambient + cool + warm - want, 1e-12) << "the mirror image";
}

TEST(Catalogue, lamps_thin_out_by_the_law_and_spots_by_their_exponent) {
    Case c;
    const ModelChoice choice = with(SurfaceModel::Specular::none);
    const Rgb base = albedo * ambient, lit = diffuse * c.nl() * albedo;
    const double d = length(c.lamps[0]);
    const auto at = [&](Attenuation kind) {
        Case copy = c;
        copy.rules.law.kind = kind;
        copy.rules.law.constant = 0.5, copy.rules.law.linear = 0.2, copy.rules.law.quadratic = 0.1;
        return copy.traced(choice);
    };
    EXPECT_RGB_NEAR(at(Attenuation::none), base + lit, 1e-12);
    EXPECT_RGB_NEAR(at(Attenuation::one_d_d2), base + lit / (1.0 + d + d * d), 1e-12);
    EXPECT_RGB_NEAR(at(Attenuation::polynomial), base + lit / (0.5 + 0.2 * d + 0.1 * d * d), 1e-12);
    EXPECT_RGB_NEAR(at(Attenuation::inverse_square), base + lit / (d * d), 1e-12);
    c.rules.law.range = d * (1.0 + 1e-12);
    EXPECT_RGB_NEAR(c.traced(choice), base + lit, 1e-12) << "lit at the range itself";
    c.rules.law.range = d * (1.0 - 1e-12);
    EXPECT_RGB_NEAR(c.traced(choice), base, 1e-12);
    c.rules = {};
    c.spot_at = Vec3(0.7, 0.0, -0.3);
    c.rules.exponent_spots = true;
    const double k = std::pow(dot(unit(*c.spot_at - c.lamps[0]), -c.l()), 10.0);
    EXPECT_RGB_NEAR(c.traced(choice), base + k * lit, 1e-12);
}

TEST(Catalogue, spots_clamped_after_the_power_as_printed) {
    Case c;
    const ModelChoice choice = with(SurfaceModel::Specular::none);
    const Rgb base = albedo * ambient, lit = diffuse * c.nl() * albedo;
    c.rules.exponent_spots = true;
    c.spot_at = 2.0 * c.lamps[0] - Vec3(0.7, 0.0, -0.3);  // shines away
    const double cos = dot(unit(*c.spot_at - c.lamps[0]), -c.l());
    ASSERT_LT(cos, -0.9);
    EXPECT_RGB_NEAR(c.traced(choice), base, 1e-15);
    c.rules.clamp_after = true;
    EXPECT_RGB_NEAR(c.traced(choice), base + std::pow(cos, 10.0) * lit, 1e-12) << "an even exponent lights behind";
    for (const double without : {9.0, 2.5}) {
        c.tightness = without;
        EXPECT_RGB_NEAR(c.traced(choice), base, 1e-15) << without;
    }
    c.spot_at = Vec3(0.7, 0.0, -0.3);
    c.tightness = 10.0;
    EXPECT_RGB_NEAR(c.traced(choice), base + std::pow(-cos, 10.0) * lit, 1e-12) << "before it nothing changes";
}

TEST(Catalogue, ambient_light_from_every_lamp) {
    Case c;
    c.lamps.push_back({1.0, 2.0, 3.0});
    ModelChoice choice = with(SurfaceModel::Specular::none);
    const Rgb once = c.traced(choice);
    choice.model.ambient_per_light = true;
    EXPECT_RGB_NEAR(c.traced(choice), once + albedo * ambient, 1e-12);
    // Emission is no ambient light, and the scene's own ambient light tints that of the lamps.
    c.change = [](Finish& finish) { finish.emission = Rgb(0.25); };
    c.global_ambient = Rgb(0.0, 0.5, 2.0);
    EXPECT_RGB_NEAR(c.traced(choice), once + albedo * (2.0 * c.global_ambient * ambient - ambient + 0.25), 1e-12);
}

/// A share of 0 takes POV-Ray's own highlight away as well, whatever else is in the scene.
TEST(Catalogue, no_highlight_where_the_model_has_none) {
    const Case c;
    const Rgb base = albedo * ambient + diffuse * c.nl() * albedo;
    ModelChoice choice;
    choice.s = 0.0;
    EXPECT_RGB_NEAR(c.traced(choice), base, 1e-12);
    choice = with(SurfaceModel::Specular::none);
    choice.s = 0.0;
    EXPECT_RGB_NEAR(c.traced(choice), base, 1e-12);
}

TEST(Catalogue, only_shares_end_at_one) {
    Case c;
    c.change = [](Finish& finish) { finish.specular = 3.0; };
    ModelChoice choice = with(SurfaceModel::Specular::blinn_phong);
    choice.exponent = 12.0;
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient + diffuse * c.nl() * albedo + Rgb(3.0 * std::pow(c.nh(), 12.0)), 1e-12);
    choice = {};
    const Rgb all = c.traced(choice);
    choice.s = 1.0;
    EXPECT_EQ(all, c.traced(choice));
}

TEST(Catalogue, the_lecture_lights_no_surface_from_behind) {
    Case c;
    c.lamps = {{-2.0, -5.0, 1.5}};
    ModelChoice choice = with(SurfaceModel::Specular::microfacet);
    choice.model.lecture = true;
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient, 1e-15);
}

/// 2 / alpha - 2 with an infinite width or none: the highlight is all of s in the mirror direction, or everywhere.
TEST(Catalogue, exponents_of_extreme_widths) {
    Case c;
    c.lamps = {{-1.2, 2.0, 0.7}};
    ASSERT_NEAR(c.nh(), 1.0, 1e-15);
    const Rgb base = albedo * ambient + diffuse * c.nl() * albedo;
    for (const auto kind : {SurfaceModel::Specular::phong, SurfaceModel::Specular::blinn_phong}) {
        ModelChoice choice = with(kind);
        choice.alpha = 1e6;
        EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(specular), 1e-12);
        choice.alpha.reset();
        c.change = [](Finish& finish) { finish.roughness = 0.0; };
        const Rgb narrow = c.traced(choice) - base;
        EXPECT_TRUE(narrow.r >= -1e-12 && narrow.r <= specular + 1e-12) << narrow.r;
        choice.alpha = 0.1;  // 18
        c.v = {1.2, 1.0, -0.7};
        const double cos = kind == SurfaceModel::Specular::phong ? dot(2.0 * c.nl() * c.n() - c.l(), c.eye()) : c.nh();
        EXPECT_RGB_NEAR(c.traced(choice), base + Rgb(specular * std::pow(cos, 18.0)), 1e-12) << "a stated alpha, not the roughness";
        c = Case{.lamps = {{-1.2, 2.0, 0.7}}};
    }
}

TEST(Catalogue, phong_lobes_are_tinted_as_povray_tints_its_own) {
    Case c;
    ModelChoice choice = with(SurfaceModel::Specular::blinn_phong);
    const Rgb base = albedo * ambient + diffuse * c.nl() * albedo, white = c.traced(choice) - base;
    c.change = [](Finish& finish) { finish.metallic = 1.0; };
    const Rgb tinted = c.traced(choice) - base;
    EXPECT_RGB_NEAR(tinted, white * metallic_tint(albedo, 1.0, c.nl()), 1e-12);
    EXPECT_LT(tinted.b, 0.9 * tinted.r);
}

TEST(Catalogue, the_gate_of_phong_holds_for_the_power_as_printed_and_is_not_povrays) {
    Case c;
    c.lamps = {{-3.0, -0.2, 2.0}};
    ModelChoice choice = with(SurfaceModel::Specular::phong);
    choice.exponent = 4.0;
    choice.model.clamp_after = true;
    EXPECT_RGB_NEAR(c.traced(choice), albedo * ambient, 1e-15);
    choice.model.clamp_after = false;
    choice.model.phong_gate = false;
    const Rgb ungated = c.traced(choice);
    EXPECT_GT(ungated.r, albedo.r * ambient.r);
    c.change = [](Finish& finish) { finish.phong = 0.8; };
    EXPECT_EQ(c.traced(choice), ungated) << "POV-Ray's own phong stays on its side";
}

TEST(Catalogue, no_shadow_rays_for_light_that_has_no_term) {
    Case c;
    ModelChoice choice = with(SurfaceModel::Specular::none);
    c.traced(choice);
    EXPECT_EQ(c.shadow_rays, 1u);
    for (const Diffuse kind : {Diffuse::none, Diffuse::gooch}) {
        choice.model.diffuse = kind;
        c.traced(choice);
        EXPECT_EQ(c.shadow_rays, 0u);
    }
    choice = {};
    choice.model.diffuse = Diffuse::none;
    choice.s = 0.0;
    c.traced(choice);
    EXPECT_EQ(c.shadow_rays, 0u);
}

TEST(Catalogue, a_lamp_at_the_point_or_a_wild_sigma_is_no_number_lost) {
    Case c;
    for (const double distance : {0.0, 5e-324, 1e-200}) {
        const double factor = attenuation({.kind = Attenuation::polynomial, .constant = 0.0, .linear = 0.0}, distance);
        EXPECT_TRUE(factor >= 0.0 && factor <= brightest) << distance;
    }
    EXPECT_EQ(attenuation({.kind = Attenuation::one_d_d2}, 0.0), 1.0);
    ModelChoice choice = with(SurfaceModel::Specular::none);
    choice.model.diffuse = Diffuse::oren_nayar;
    choice.model.oren_nayar = OrenNayar(1e200);
    const Rgb wild = c.traced(choice);
    choice.model.oren_nayar = OrenNayar(1e9);
    EXPECT_RGB_NEAR(wild, c.traced(choice), 1e-12);
}

}  // namespace
}  // namespace rt::catalogue_test
