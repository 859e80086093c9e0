// What holds whatever the values are: nothing infinite or negative, reciprocity, invariance under rotation, forms that are one function.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <random>

#include "shading/models.h"
#include "shading/optics.h"

namespace rt::properties_test {
namespace {

constexpr double u = 0x1p-53;
constexpr std::array all_D{Distribution::blinn, Distribution::blinn_inverse_roughness, Distribution::beckmann, Distribution::ggx,
                           Distribution::gaussian};
constexpr std::array all_G{Masking::cook_torrance,     Masking::ggx, Masking::ggx_hc, Masking::beckmann, Masking::beckmann_hc,
                           Masking::beckmann_rational, Masking::none};
constexpr std::array all_F{Fresnel::one,         Fresnel::constant,   Fresnel::schlick,  Fresnel::schlick_linear,
                           Fresnel::schlick_f82, Fresnel::dielectric, Fresnel::conductor};

/// Random and degenerate inputs; the same sequence on every run.
class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    double power_of_ten(double a, double b) { return std::pow(10.0, uniform(a, b)); }
    int choice(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
    double of(std::initializer_list<double> values) { return values.begin()[choice(static_cast<int>(values.size()))]; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            if (dot(v, v) > 0.01 && dot(v, v) < 1.0) return unit(v);
        }
    }
    Vec3 above(const Vec3& n) {
        const Vec3 v = direction();
        return dot(n, v) < 0.0 ? -v : v;
    }
    /// At a cosine to the z axis between 1 and the least subnormal number.
    Vec3 grazing() {
        const double c = choice(4) ? power_of_ten(-323.3, 0.0) : of({5e-324, 1e-310, 2.3e-308, 1.01e-150, 1e-151});
        const double angle = uniform(0, 2 * pi), s = std::sqrt(1 - c * c);
        return {s * std::cos(angle), s * std::sin(angle), c};
    }
    void directions(Vec3& n, Vec3& l, Vec3& v) {
        n = direction(), l = above(n), v = above(n);
        const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
        switch (choice(12)) {
            case 0:
                n = {0, 0, 1}, l = grazing(), v = grazing();
                break;
            case 1:  // nearly opposite, both at grazing
                n = {0, 0, 1}, l = grazing(), v = Vec3(-l.x, -l.y, power_of_ten(-323, 0));
                break;
            case 2:
                v = l;
                break;
            case 3:
                l = v = n;
                break;
            case 4:
                v = -l;
                break;
            case 5:  // close to the mirror direction
                v = unit(reflect(-l, n) + power_of_ten(-17, -1) * direction());
                break;
            case 6:
                (choice(2) ? l : v) = choice(2) ? Vec3(0.0) : Vec3(of({nan, inf, -inf}), 0.5, 0.5);
                break;
            case 7:
                n = choice(2) ? Vec3(0.0) : Vec3(nan, 0, 1);
                break;
            case 8:
                l = direction(), v = direction();
                break;
            default:
                break;
        }
    }
    double alpha() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return choice(3) ? power_of_ten(-10, 1)
                         : of({0.0, 5e-324, 1e-200, 1e-150, 1.1e-150, 1e-80, 1e-16, 1.0, 2.0, 1e3, 1e80, 1e150, 1e200, nan});
    }
    Interface interface() {
        const double eta =
            choice(2) ? power_of_ten(-1, 1) : of({1.0, 1.0 + 1e-6, 1.0 - 1e-16, 1e-9, 1e-200, 0.5, 1e6, 1e152, 1e154, 1e308});
        return interface_of(eta, choice(2) ? 0.0 : of({1e-320, 1e-12, 0.1, 1.0, 5.0, 1e6, 1e152, 1e160, 1e308}));
    }

private:
    std::mt19937_64 random_;
};

/// 10,000 inputs for each of the 980 combinations of D, G, F and diffuse term; a hundred times as many where RAYTRACE_DEEP is set.
TEST(ShadingProperties, NoCombinationIsEverNegativeOrNotFinite) {
    const int inputs = std::getenv("RAYTRACE_DEEP") ? 1'000'000 : 10'000;
    Draw draw(11);
    int lit = 0;
    for (int i = 0; i < inputs; ++i) {
        Vec3 n, l, v;
        draw.directions(n, l, v);
        const double alpha = draw.alpha(), s = draw.of({0.0, 0.3, 1.0}), sigma = draw.of({0.0, 0.3, 1.5, 1e9, 1e-200});
        const Interface x = draw.interface();
        HalfGeometry g;
        if (!half_geometry(n, l, v, incline(n, v), g)) continue;
        ++lit;
        ASSERT_LE(g.v_dot_h, 1.0);  // the square root alone may round above
        const std::array diffuse{1.0, OrenNayar(sigma)(g.l.cos, g.v.cos, dot(l, v)), gooch(g.l.cos, 0.1, 0.9), 0.0};
        std::array<double, all_F.size()> reflectances{};
        for (std::size_t f = 0; f < all_F.size(); ++f) {
            reflectances[f] = reflectance({.F = all_F[f]}, x, g);
            ASSERT_TRUE(reflectances[f] >= 0.0 && reflectances[f] <= 1.0) << f << " " << x.eta << " " << x.k << " " << g.v_dot_h;
        }
        for (const Distribution D : all_D)
            for (const Masking G : all_G) {
                const double lobe = microfacet_lobe({.D = D, .G = G}, g, alpha);
                ASSERT_TRUE(rt::G(G, g, alpha) >= 0.0 && rt::G(G, g, alpha) <= 1.0) << static_cast<int>(G) << " " << alpha;
                for (const double F : reflectances)
                    for (const double rd : diffuse) {
                        const double r = 2.0 * (g.l.cos * (1.0 - s) * rd + s * (lobe * F));
                        ASSERT_TRUE(std::isfinite(r) && r >= 0.0)
                            << static_cast<int>(D) << " " << static_cast<int>(G) << " alpha " << alpha << " cosines " << g.l.cos << " "
                            << g.v.cos << " lobe " << lobe << " F " << F << " rd " << rd;
                    }
            }
    }
    EXPECT_GT(lit, inputs / 2);
}

TEST(ShadingProperties, ReciprocalBitForBit) {
    Draw draw(12);
    int lit = 0;
    for (int i = 0; i < 20000; ++i) {
        Vec3 n, l, v;
        draw.directions(n, l, v);
        const double alpha = draw.alpha();
        const Interface x = draw.interface();
        HalfGeometry a, b;
        ASSERT_EQ(half_geometry(n, l, v, incline(n, v), a), half_geometry(n, v, l, incline(n, l), b));
        if (!half_geometry(n, l, v, incline(n, v), a)) continue;
        ++lit;
        for (const Distribution D : all_D)
            for (const Masking G : all_G) {
                const MicrofacetTerms terms{.D = D, .G = G, .without_cosine = true};
                ASSERT_EQ(microfacet_lobe(terms, a, alpha), microfacet_lobe(terms, b, alpha)) << static_cast<int>(D) << static_cast<int>(G);
            }
        for (const Fresnel F : all_F) ASSERT_EQ(reflectance({.F = F}, x, a), reflectance({.F = F}, x, b));
        const OrenNayar rough(0.6);
        ASSERT_EQ(rough(a.l.cos, a.v.cos, dot(l, v)), rough(b.l.cos, b.v.cos, dot(v, l)));
        ASSERT_EQ(blinn_phong(a, 20.0), blinn_phong(b, 20.0));
    }
    EXPECT_GT(lit, 10000);
}

TEST(ShadingProperties, FormsThatAreNotReciprocalAreNot) {
    const Vec3 n(0, 0, 1), l(0.6, 0, 0.8), v(0, std::sqrt(1 - 0.01), 0.1);
    HalfGeometry a, b;
    ASSERT_TRUE(half_geometry(n, l, v, incline(n, v), a) && half_geometry(n, v, l, incline(n, l), b));
    const Interface x = interface_of(1.5);
    const MicrofacetTerms at_view{.fresnel_at_view = true};
    EXPECT_GT(reflectance(at_view, x, a), 3.0 * reflectance(at_view, x, b));
    const Vec3 low(0, std::sqrt(1 - 1e-4), 0.01);  // below 1/16 the clamped denominator darkens
    ASSERT_TRUE(half_geometry(n, l, low, incline(n, low), a) && half_geometry(n, low, l, incline(n, l), b));
    const MicrofacetTerms clamped{.clamped_denominator = true, .without_cosine = true};
    EXPECT_NEAR(microfacet_lobe(clamped, b, 0.3) / microfacet_lobe(clamped, a, 0.3), 6.25, 1e-12);
    halve_normal_and_view(n, low, a);
    halve_normal_and_view(n, l, b);
    EXPECT_GT(std::fabs(microfacet_lobe({}, a, 0.3) / microfacet_lobe({}, b, 0.3) - 1.0), 0.5);
}

/// A rotation of all three directions changes the value by roundings only, times the slope of the value.
TEST(ShadingProperties, RotationsChangeNothing) {
    Draw draw(13);
    int turned_rows = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 n = draw.direction(), l = draw.above(n), v = i % 2 ? draw.above(n) : unit(reflect(-l, n) + 0.05 * draw.direction());
        const double alpha = draw.power_of_ten(-2, 0.3);
        const Vec3 x = draw.direction(), y = unit(cross(x, draw.direction())), z = cross(x, y);
        const auto turned = [&](const Vec3& a) { return a.x * x + a.y * y + a.z * z; };
        HalfGeometry a, b;
        if (!half_geometry(n, l, v, incline(n, v), a) || a.l.cos < 1e-3 || a.v.cos < 1e-3) continue;
        ++turned_rows;
        ASSERT_TRUE(half_geometry(turned(n), turned(l), turned(v), incline(turned(n), turned(v)), b));
        // d ln D / d angle is at most 2 tan (1 + tan^2) / alpha^2 + 4 tan; the angle of h moves by an ulp over |s|, those of l and v by
        // one.
        const double tan2 = a.sin2_h / a.cos2_h, slope = (2.0 / sqr(alpha) + 4.0) * (std::sqrt(tan2) + u / alpha) * (1.0 + tan2);
        const double tolerance =
            8.0 * u * (32.0 + slope / a.v_dot_h + 4.0 / a.l.cos + 4.0 / a.v.cos + 4.0 / a.v_dot_h / std::sqrt(a.cos2_h));
        for (const Distribution D : all_D)
            for (const Masking G : all_G) {
                if (G == Masking::beckmann_rational) continue;  // its jump at a = 1.6 may fall between the two
                const double one = microfacet_lobe({.D = D, .G = G}, a, alpha), other = microfacet_lobe({.D = D, .G = G}, b, alpha);
                ASSERT_LE(std::fabs(one - other), tolerance * one + 1e-290) << static_cast<int>(D) << static_cast<int>(G) << " " << alpha;
            }
    }
    EXPECT_GT(turned_rows, 19500);
}

// ---- one function in several prints; h and its cosines as the texts have them, at angles where those forms keep their digits ----

struct Printed {
    double nl, nv, nh, vh;
    Printed(const Vec3& n, const Vec3& l, const Vec3& v) : nl(dot(n, l)), nv(dot(n, v)), nh(dot(n, unit(l + v))), vh(dot(v, unit(l + v))) {}
    double G() const { return std::min({1.0, 2 * nh * nv / vh, 2 * nh * nl / vh}); }
};

void each_ordinary_pair(unsigned seed, const auto& test) {
    Draw draw(seed);
    int pairs = 0;
    while (pairs < 1000) {
        const Vec3 n = draw.direction(), l = draw.above(n), v = draw.above(n);
        HalfGeometry g;
        if (!half_geometry(n, l, v, incline(n, v), g) || g.l.cos < 0.05 || g.v.cos < 0.05 || g.v_dot_h < 0.1) continue;
        ++pairs;
        test(n, l, v, g, draw.uniform(0.3, 1.0));
    }
}

TEST(Equivalences, TheThreePrintsOfCookAndTorranceAreOneFunction) {
    each_ordinary_pair(21, [](const Vec3& n, const Vec3& l, const Vec3& v, const HalfGeometry& g, double m) {
        const Printed p(n, l, v);
        const double tan2 = (1 - p.nh * p.nh) / (p.nh * p.nh), D = std::exp(-tan2 / (m * m)) / (4 * m * m * std::pow(p.nh, 4));
        const double lecture = D * p.G() / (pi * p.nv);
        const double halved = std::exp((1 / (m * m)) * (1 - 1 / (p.nh * p.nh))) / std::pow(p.nh, 4) *
                              std::min({0.5, p.nh * p.nv / p.vh, p.nh * p.nl / p.vh}) / (2 * m * m * pi) / p.nv;
        const double ours = microfacet_lobe({.D = Distribution::beckmann, .G = Masking::cook_torrance}, g, m);
        EXPECT_NEAR(ours / lecture, 1.0, 1e-11);
        EXPECT_NEAR(ours / halved, 1.0, 1e-11);
        EXPECT_DOUBLE_EQ(microfacet_lobe(lecture_terms(), g, m), ours);
        EXPECT_DOUBLE_EQ(microfacet_lobe(effects_terms(1e-4, false), g, m), 1e-4 * ours);
    });
}

TEST(Equivalences, CosinesOfTheHalfVectorAndTheGrooves) {
    each_ordinary_pair(22, [](const Vec3& n, const Vec3& l, const Vec3& v, const HalfGeometry& g, double) {
        const Printed p(n, l, v);
        EXPECT_NEAR(g.v_dot_h, p.vh, 1e-14);
        EXPECT_NEAR(g.v_dot_h, dot(l, unit(l + v)), 1e-14);
        EXPECT_NEAR(g.cos2_h, sqr(p.nh), 1e-14);
        EXPECT_NEAR(g.sin2_h, 1 - sqr(p.nh), 1e-14);
        EXPECT_NEAR(G(Masking::cook_torrance, g, 0.5), p.G(), 1e-13);
    });
}

TEST(Equivalences, FresnelByAmplitudesIsFresnelByTheLecture) {
    Draw draw(23);
    for (int i = 0; i < 1000; ++i) {
        const double c = draw.uniform(0.01, 1.0), eta = draw.uniform(1.05, 4.0), cos_t = std::sqrt(1 - (1 - c * c) / (eta * eta));
        const double rs = (c - eta * cos_t) / (c + eta * cos_t), rp = (eta * c - cos_t) / (eta * c + cos_t);
        EXPECT_NEAR(F_dielectric(eta, c), 0.5 * (rs * rs + rp * rp), 1e-14);
        EXPECT_NEAR(F_dielectric(eta, c), fresnel_reflectance(eta, c), 1e-14);
        EXPECT_EQ(F_conductor(eta, 0.0, c), F_dielectric(eta, c));
        EXPECT_NEAR(F_conductor(eta, 1e-9, c), F_dielectric(eta, c), 1e-8);
    }
}

TEST(Equivalences, SchlickOfAMetalIsTheUncorrectedMetalFormula) {
    Draw draw(24);
    for (int i = 0; i < 1000; ++i) {
        const double c = draw.uniform(0.0, 1.0), eta = draw.uniform(0.1, 4.0), k = draw.uniform(0.0, 9.0), x = 1 - c;
        const double metal = (sqr(eta - 1) + 4 * eta * x * x * x * x * x + k * k) / (sqr(eta + 1) + k * k);
        EXPECT_NEAR(F(Fresnel::schlick, interface_of(eta, k), c), metal, 4e-15);
    }
}

/// As alpha goes to 0 what a lobe gathers from a uniform surrounding goes to F(n.v).
TEST(Equivalences, ANarrowLobeIsAMirrorWeightedByFresnel) {
    const Vec3 n(0, 0, 1), v(0.8, 0, 0.6);
    const Interface x = interface_of(1.5);
    const MicrofacetTerms terms{.F = Fresnel::dielectric};
    constexpr double alpha = 1e-4, step = 0.05;
    double sum = 0.0;
    for (double y = -30.0; y < 25.0; y += step)  // tan^2 = alpha^2 e^y
        for (int k = 0; k < 32; ++k) {
            const double t = sqr(alpha) * std::exp(y), angle = 2 * pi * (k + 0.5) / 32, c = 1.0 / std::sqrt(1.0 + t);
            const Vec3 m(std::sqrt(t) * c * std::cos(angle), std::sqrt(t) * c * std::sin(angle), c);
            const Vec3 l = reflect(-v, m);
            HalfGeometry g;
            if (dot(v, m) <= 0.0 || !half_geometry(n, l, v, incline(n, v), g)) continue;
            const double solid_angle = pi * t / sqr(1.0 + t) / c * step / 32;  // of m
            sum += microfacet_lobe(terms, g, alpha) * reflectance(terms, x, g) * 4.0 * dot(v, m) * solid_angle;
        }
    EXPECT_NEAR(sum, F_dielectric(1.5, 0.6), 1e-5);
}

TEST(ShadingProperties, DistributionsFallFromTheirPeak) {
    for (const double alpha : {0.01, 0.1, 0.5, 0.7})
        for (const Distribution kind : {Distribution::blinn, Distribution::beckmann, Distribution::ggx}) {
            double before = D(kind, 1.0, 0.0, alpha);
            for (double t = 1e-3; t < 4.0; t += 1e-3) {
                const double tan2 = sqr(t * alpha), now = D(kind, 1 / (1 + tan2), tan2 / (1 + tan2), alpha);
                EXPECT_LT(now, before) << static_cast<int>(kind) << " " << alpha << " " << t;
                before = now;
            }
        }
    // Beckmann beyond alpha = 1/sqrt 2 has its peak at tan^2 = 2 alpha^2 - 1, 1.47 times the value at the normal for alpha 1.
    EXPECT_NEAR(D_beckmann(0.5, 0.5, 1.0) / D_beckmann(1.0, 0.0, 1.0), 4 * std::exp(-1.0), 1e-14);
}

}  // namespace
}  // namespace rt::properties_test
