// The table of directional albedo against the quadrature that takes its time.
#include "shading/albedo.h"

#include <gtest/gtest.h>

#include <string>

#include "shading/integrals.h"
#include "shading/surface_model.h"

namespace rt::albedo_test {
namespace {

// What albedo.h promises: the table is linear between 49 nodes at n.v = (i/48)^2. That is 0.002 where the albedo is smooth; between the
// first nodes, below 0.05, V-grooves on rough surfaces bend it more, and 0.025 is what one interval leaves of that.
constexpr double promised = 0.002, promised_at_grazing = 0.025;

/// Largest error over cosines that are no nodes, relative where the albedo exceeds 1.
double error_of(const MicrofacetTerms& terms, const Interface& x, double alpha, const std::vector<double>& cosines) {
    const Interface channels[3] = {x, x, x};
    const AlbedoTable table(terms, channels, alpha);
    double worst = 0.0;
    for (const double n_dot_v : cosines) {
        const double want = directional_albedo(terms, x, alpha, n_dot_v);
        worst = std::max(worst, std::fabs(table.at(0, n_dot_v, 1.0) - want) / std::max(1.0, want));
    }
    return worst;
}

TEST(Albedo, MeetsTheIntegral) {
    for (const Distribution D : {Distribution::ggx, Distribution::beckmann, Distribution::blinn}) {
        for (const Masking G : {Masking::ggx, Masking::cook_torrance, Masking::beckmann_hc}) {
            for (const double alpha : {0.01, 0.1, 0.4, 1.0}) {
                const MicrofacetTerms terms{.D = D, .G = G};
                const std::string which = std::to_string(static_cast<int>(D)) + " " + std::to_string(static_cast<int>(G));
                EXPECT_LT(error_of(terms, interface_of(1.5), alpha, {0.06, 0.13, 0.37, 0.91}), promised) << which << " " << alpha;
                EXPECT_LT(error_of(terms, interface_of(1.5), alpha, {0.004, 0.011, 0.03}), promised_at_grazing) << which << " " << alpha;
            }
        }
    }
}

TEST(Albedo, MeetsItForEveryFresnelTerm) {
    const Interface gold = interface_of(0.375, 2.386);
    for (const Fresnel F : {Fresnel::one, Fresnel::constant, Fresnel::schlick, Fresnel::schlick_linear, Fresnel::schlick_f82,
                            Fresnel::dielectric, Fresnel::conductor}) {
        const MicrofacetTerms terms{.F = F};
        EXPECT_LT(error_of(terms, F == Fresnel::dielectric ? interface_of(1.5) : gold, 0.25, {0.06, 0.2, 0.6, 0.97}), promised)
            << static_cast<int>(F);
    }
}

TEST(Albedo, OfAMirrorIsFresnels) {
    // F itself at the nodes, (i/48)^2, and straight lines between them: 0.96 c (1 - c)^3 / 230 from (1 - c)^5, below 5e-4.
    const Interface x = interface_of(1.5), channels[3] = {x, x, x};
    const AlbedoTable table({}, channels, AlbedoTable::least_alpha);
    for (const double cos : {0.02, 0.2, 0.5, 0.8, 1.0}) EXPECT_NEAR(table.at(1, cos, 1.0), F_schlick(x.f0, cos), 5e-4) << cos;
}

TEST(Albedo, IsLinearInF0) {
    // Both are the same sums of a thousand terms or so: rounding only.
    Interface x = interface_of(2.0), half = x;
    half.f0 = 0.5 * x.f0;
    const AlbedoTable table({}, {x, x, x}, 0.2), other({}, {half, half, half}, 0.2);
    for (const double cos : {0.1, 0.5, 0.9}) EXPECT_NEAR(table.at(2, cos, 0.5), other.at(2, cos, 1.0), 1e-12) << cos;
}

TEST(Albedo, IsFiniteForEveryWidth) {
    const Interface x = interface_of(1.5), channels[3] = {x, x, x};
    for (const Distribution D :
         {Distribution::ggx, Distribution::beckmann, Distribution::blinn, Distribution::blinn_inverse_roughness, Distribution::gaussian}) {
        for (const double alpha : {AlbedoTable::least_alpha, 1e-3, 2.0, 1e6, 1e160}) {
            const AlbedoTable table({.D = D, .G = Masking::none}, channels, alpha);
            for (const double cos : {1e-140, 1e-5, 0.5, 1.0}) {
                const double E = table.at(0, cos, 1.0);
                EXPECT_TRUE(std::isfinite(E) && E >= 0.0) << static_cast<int>(D) << " " << alpha << " " << cos << ": " << E;
            }
        }
    }
}

SurfaceModel model_of(Surroundings env, double alpha = 0.2) {
    SurfaceModel model;
    for (Interface& x : model.interface) x = interface_of(1.5);
    model.env = env;
    model.alpha = alpha;
    model.s = 0.5;
    return model;
}

TEST(SurroundingsWeight, IsNothingAtTheHorizonAndBelow) {
    for (const Surroundings env : {Surroundings::mirror, Surroundings::fresnel, Surroundings::albedo, Surroundings::ct_effects})
        for (const double cos : {0.0, -0.5, std::nan("")}) EXPECT_EQ(surroundings_weight(model_of(env), cos, false, Rgb(1.0)), Rgb(0.0));
    EXPECT_EQ(surroundings_weight(model_of(Surroundings::finish), 0.5, false, Rgb(1.0)), Rgb(0.0));
}

TEST(SurroundingsWeight, InsideReflectsAsOutsideAtTheAngleBehind) {
    SurfaceModel model = model_of(Surroundings::fresnel);
    model.s = 1.0;
    for (const Fresnel F : {Fresnel::dielectric, Fresnel::schlick}) {
        model.terms.F = F;
        const double sin_outside = 0.6, sin_inside = sin_outside / 1.5, cos_inside = std::sqrt(1.0 - sin_inside * sin_inside);
        EXPECT_NEAR(surroundings_weight(model, cos_inside, true, Rgb(1.0)).g, surroundings_weight(model, 0.8, false, Rgb(1.0)).g, 1e-15);
        EXPECT_EQ(surroundings_weight(model, 0.7, true, Rgb(1.0)), Rgb(1.0)) << "sin 0.714 is beyond 1 / 1.5: total";
    }
    // The exact term knows the inner side by itself, from the inverse index.
    model.terms.F = Fresnel::dielectric;
    EXPECT_NEAR(surroundings_weight(model, 0.9, true, Rgb(1.0)).r, F_dielectric(1.0 / 1.5, 0.9), 1e-15);
}

TEST(SurroundingsWeight, OfTheEffectsFormIsAsPrintedUpToItsLimit) {
    SurfaceModel model = model_of(Surroundings::ct_effects, 0.001);
    model.env_dw = 1e-4;
    const double want = 1e-4 * 0.5 * (0.04 + 0.96 * std::pow(0.4, 5.0)) / (4.0 * 1e-6 * pi * 0.6);
    EXPECT_NEAR(surroundings_weight(model, 0.6, false, Rgb(1.0)).g, want, 1e-14);
    ASSERT_GT(want, 0.2);
    model.env_limit = 0.2;
    EXPECT_EQ(surroundings_weight(model, 0.6, false, Rgb(1.0)), Rgb(0.2));
    model.env_limit = largest_lobe;
    for (const double alpha : {0.0, 1e-160, 1e-150, 1e-75, 1e160})
        for (const double cos : {1e-149, 1e-9, 1.0})
            for (const double dw : {0.0, 1e-4, 1e300}) {
                model.alpha = alpha, model.env_dw = dw;
                const double weight = surroundings_weight(model, cos, false, Rgb(1.0)).r;
                EXPECT_TRUE(weight >= 0.0 && weight <= largest_lobe) << alpha << " " << cos << " " << dw << ": " << weight;
            }
}

}  // namespace
}  // namespace rt::albedo_test
