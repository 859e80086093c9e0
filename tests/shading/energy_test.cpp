// Integrals over the hemisphere: projected area of the facets, and how much of it masking lets a viewer see (the weak white furnace).
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "shading/terms.h"

namespace rt::energy_test {
namespace {

/// D of tan^2.
double D_of(Distribution kind, double t, double alpha) { return D(kind, 1.0 / (1.0 + t), t / (1.0 + t), alpha); }

/// Integral of D cos over the hemisphere with tan^2 = alpha^2 e^y: pi dt / (1 + t)^2 and the trapezoid rule in y.
double projected_area(Distribution kind, double alpha) {
    constexpr double step = 0.05;
    double sum = 0.0;
    for (double y = -40.0; y < 650.0; y += step) {
        const double t = alpha * alpha * std::exp(y);
        sum += D_of(kind, t, alpha) * pi * (t / (1.0 + t)) / (1.0 + t) * step;
    }
    return sum;
}

TEST(Energy, DistributionsAreNormalised) {
    for (const double alpha : {1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.8, 1.0, 1.5, 3.0}) {
        // Blinn's power is negative above 1, and the integral is 1 all the same.
        for (const Distribution kind : {Distribution::blinn, Distribution::beckmann, Distribution::ggx})
            EXPECT_NEAR(projected_area(kind, alpha), 1.0, 1e-12) << static_cast<int>(kind) << " " << alpha;
    }
}

TEST(Energy, BlinnByInverseRoughnessHasTheAreaOfItsPower) {
    for (const double r : {0.1, 0.5, 0.89498, 1.0}) {
        const double area = 2.0 / (r * r * r * (1.0 + 2.0 * r));
        EXPECT_NEAR(projected_area(Distribution::blinn_inverse_roughness, r * r) / area, 1.0, 1e-12) << r;
    }
    EXPECT_NEAR(projected_area(Distribution::blinn_inverse_roughness, 0.89498 * 0.89498), 1.0, 1e-4);
    EXPECT_NEAR(projected_area(Distribution::blinn_inverse_roughness, 0.01), 1667.0, 0.5);
}

/// Nodes and weights of Gauss and Legendre on 0..1, by Newton's method.
struct Gauss {
    std::array<double, 12> x{}, w{};
    Gauss() {
        const int n = static_cast<int>(x.size());
        for (int i = 0; i < n; ++i) {
            double z = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 0.0;
            for (int pass = 0; pass < 50; ++pass) {
                double p = 1.0, before = 0.0;
                for (int k = 1; k <= n; ++k) {
                    const double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
                    before = p;
                    p = next;
                }
                slope = n * (z * p - before) / (z * z - 1.0);
                z -= p / slope;
            }
            x[static_cast<std::size_t>(i)] = 0.5 * (1.0 + z);
            w[static_cast<std::size_t>(i)] = 1.0 / ((1.0 - z * z) * slope * slope);
        }
    }
    double integral(double a, double b, const auto& f) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += w[i] * f(a + (b - a) * x[i]);
        return sum * (b - a);
    }
};

/// (1 / n.v) times the integral of D(m) G1(v, m) max(v.m, 0), where G1 is what G says of the pair (v, v) for the grooves and of (n, v)
/// for Smith's. The kinks in both angles are ends of panels.
double furnace(Distribution distribution, Masking masking, double alpha, double n_dot_v) {
    static const Gauss gauss;
    const Incline v = incline(n_dot_v);
    const double tan_v = std::sqrt(v.sin2) / v.cos;
    HalfGeometry g;
    g.v = v;
    g.l = masking == Masking::cook_torrance ? v : Incline{1.0, 0.0};
    const auto ring = [&](double y) {
        const double t = alpha * alpha * std::exp(y), c = 1.0 / std::sqrt(1.0 + t), reach = std::sqrt(t) * tan_v;
        const auto at = [&](double angle) {
            const double over = 1.0 + reach * std::cos(angle);  // v.m / (n.v n.m)
            if (over <= 0.0) return 0.0;
            g.v_dot_h = over * v.cos * c;
            g.n_dot_s = 2.0 * g.v_dot_h * c;
            g.s_dot_s = 4.0 * g.v_dot_h * g.v_dot_h;
            return G(masking, g, alpha) * over;
        };
        const double kink = reach > 1.0 ? std::acos(1.0 / reach) : pi / 2;
        const double mean = gauss.integral(0.0, kink, at) + gauss.integral(kink, pi - kink, at) + gauss.integral(pi - kink, pi, at);
        return D_of(distribution, t, alpha) * t / sqr(1.0 + t) * mean;
    };
    const double edge = v.sin2 > 0.0 ? -2.0 * std::log(alpha * tan_v) : 0.0;  // where a facet first turns away from the viewer
    double sum = 0.0;
    for (int panel = 0; panel < 50; ++panel)
        sum += gauss.integral(edge + panel, edge + panel + 1, ring) + gauss.integral(edge - panel - 1, edge - panel, ring);
    return sum;
}

TEST(Energy, MaskingShowsTheFacetsItWasMadeFor) {
    for (const double alpha : {0.05, 0.25, 0.5, 1.0})
        for (const double n_dot_v : {1.0, 0.5, 0.1, 0.02}) {
            // The grooves belong to every distribution: each facet has its mirror image about n.
            for (const Distribution kind : {Distribution::blinn, Distribution::beckmann, Distribution::ggx})
                EXPECT_NEAR(furnace(kind, Masking::cook_torrance, alpha, n_dot_v), 1.0, 1e-6) << alpha << " " << n_dot_v;
            EXPECT_NEAR(furnace(Distribution::ggx, Masking::ggx, alpha, n_dot_v), 1.0, 1e-6) << alpha << " " << n_dot_v;
            EXPECT_NEAR(furnace(Distribution::beckmann, Masking::beckmann, alpha, n_dot_v), 1.0, 1e-6) << alpha << " " << n_dot_v;
            EXPECT_NEAR(furnace(Distribution::beckmann, Masking::beckmann_rational, alpha, n_dot_v), 1.0, 4e-3) << alpha << " " << n_dot_v;
        }
}

/// Smith's masking under a distribution that it was not made for loses or gains: known to three digits.
TEST(Energy, MaskingOfAnotherDistributionIsOff) {
    struct Case {
        Distribution D;
        double alpha;
        Masking G;
        std::array<double, 4> seen;  ///< at n.v = 1, 0.5, 0.1, 0.02
    };
    const std::vector<Case> cases{{Distribution::ggx, 0.05, Masking::beckmann, {1.000, 1.002, 1.058, 1.404}},
                                  {Distribution::ggx, 0.5, Masking::beckmann, {1.000, 1.146, 1.550, 1.720}},
                                  {Distribution::ggx, 1.0, Masking::beckmann, {1.000, 1.312, 1.649, 1.746}},
                                  {Distribution::beckmann, 0.05, Masking::ggx, {1.000, 0.998, 0.945, 0.712}},
                                  {Distribution::beckmann, 0.5, Masking::ggx, {1.000, 0.872, 0.645, 0.581}},
                                  {Distribution::beckmann, 1.0, Masking::ggx, {1.000, 0.762, 0.606, 0.573}},
                                  {Distribution::blinn, 0.25, Masking::ggx, {1.000, 0.957, 0.722, 0.611}},
                                  {Distribution::blinn, 0.25, Masking::beckmann, {1.000, 1.000, 1.012, 1.021}},
                                  {Distribution::blinn, 0.5, Masking::ggx, {1.000, 0.885, 0.695, 0.640}},
                                  {Distribution::blinn, 0.5, Masking::beckmann, {1.000, 1.015, 1.076, 1.101}}};
    constexpr std::array cosines{1.0, 0.5, 0.1, 0.02};
    for (const Case& c : cases)
        for (std::size_t i = 0; i < cosines.size(); ++i)
            EXPECT_NEAR(furnace(c.D, c.G, c.alpha, cosines[i]), c.seen[i], 6e-4)
                << static_cast<int>(c.D) << " " << static_cast<int>(c.G) << " " << c.alpha << " " << cosines[i];
}

}  // namespace
}  // namespace rt::energy_test
