// The rows of every table at oblique angles, beside the formulas as the papers print them. The vectors are of rational numbers, so that
// every cosine is known exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/commands/brdf/brdf_support.h"

namespace rt::brdf_rows_test {
namespace {

using test::Cells;
using test::evaluated;

constexpr double pi = 3.14159265358979323846;
constexpr double relative = 1e-13;

const Vec3 n = Vec3(2, 3, 6) / 7.0, l = Vec3(1, 2, 2) / 3.0, v = Vec3(-6, 2, 3) / 7.0;
constexpr double nl = 20.0 / 21.0, nv = 12.0 / 49.0, lv = 4.0 / 21.0;
// h = (l + v) / |l + v| and |l + v|^2 = 2 + 2 l.v.
const double s_length = std::sqrt(2.0 + 2.0 * lv), nh = (nl + nv) / s_length, vh = 0.5 * s_length;
const double tan2 = (1.0 - nh * nh) / (nh * nh);

double tan2_of(double c) { return (1.0 - c * c) / (c * c); }
double grooves(double nl, double nv, double nh, double vh) { return std::min({1.0, 2.0 * nh * nv / vh, 2.0 * nh * nl / vh}); }
double ggx_root(double c, double alpha) { return std::sqrt(1.0 + alpha * alpha * tan2_of(c)); }
/// 1 + Lambda of Smith's masking for Beckmann.
double beckmann_lambda1(double c, double alpha) {
    const double a = 1.0 / (alpha * std::sqrt(tan2_of(c)));
    return 0.5 * (1.0 + std::erf(a) + std::exp(-a * a) / (a * std::sqrt(pi)));
}
double beckmann(double c, double alpha) { return std::exp(-tan2_of(c) / (alpha * alpha)) / (pi * alpha * alpha * std::pow(c, 4.0)); }
double blinn(double c, double alpha) { return std::pow(c, 2.0 / (alpha * alpha) - 2.0) / (pi * alpha * alpha); }
double ggx(double c, double alpha) { return std::pow(alpha / (c * c * (alpha * alpha - 1.0) + 1.0), 2.0) / pi; }
double schlick(double f0, double c) { return f0 + (1.0 - f0) * std::pow(1.0 - c, 5.0); }
/// Fresnel 1823 by amplitudes.
double fresnel(std::complex<double> index, double c) {
    const std::complex<double> root = std::sqrt(index * index - (1.0 - c * c));
    const std::complex<double> r_s = (c - root) / (c + root), r_p = (index * index * c - root) / (index * index * c + root);
    return 0.5 * (std::norm(r_s) + std::norm(r_p));
}
double f0_of(double eta, double k) { return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k); }

void expect_values(const std::map<std::string, double>& got, const std::map<std::string, double>& want) {
    EXPECT_EQ(got.size(), want.size());
    for (const auto& [column, value] : want) EXPECT_NEAR(got.at(column), value, relative * std::fabs(value)) << column;
}

Cells directions(const Vec3& to_light, const Vec3& to_viewer) { return Cells().add("n", n).add("l", to_light).add("v", to_viewer); }

TEST(BrdfRows, D) {
    for (const double alpha : {0.35, 0.8, 1.7}) {
        const double D = beckmann(0.85, alpha);
        expect_values(evaluated("terms_D", Cells().add("alpha", alpha).add("nh", 0.85)),
                      {{"D_blinn", blinn(0.85, alpha)}, {"D_beckmann", D}, {"D_ggx", ggx(0.85, alpha)}, {"D_4m2", 0.25 * pi * D}});
    }
}

TEST(BrdfRows, G) {
    const double alpha = 0.7, l = 0.8, v = 0.3, h = 0.7, u = 0.6, four = 4.0 * l * v;
    const double ct = grooves(l, v, h, u), gl = ggx_root(l, alpha), gv = ggx_root(v, alpha);
    const double bl = beckmann_lambda1(l, alpha), bv = beckmann_lambda1(v, alpha), a = 1.0 / (alpha * std::sqrt(tan2_of(v)));
    ASSERT_LT(ct, 0.9);
    ASSERT_LT(a, 1.6);
    const double ggx_both = 4.0 / ((1.0 + gl) * (1.0 + gv)), ggx_hc = 2.0 / (gl + gv);
    expect_values(evaluated("terms_G", Cells().add("alpha", alpha).add("nl", l).add("nv", v).add("nh", h).add("vh", u)),
                  {{"G_ct", ct},
                   {"G1_ggx_v", 2.0 / (1.0 + gv)},
                   {"G1_ggx_l", 2.0 / (1.0 + gl)},
                   {"G_ggx", ggx_both},
                   {"G_ggx_hc", ggx_hc},
                   {"G1_beck_v", 1.0 / bv},
                   {"G_beck", 1.0 / (bl * bv)},
                   {"G_beck_hc", 1.0 / (bl + bv - 1.0)},
                   {"G1_beck_rat_v", (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a)},
                   {"Vis_ct", ct / four},
                   {"Vis_ggx", ggx_both / four},
                   {"Vis_ggx_hc", ggx_hc / four},
                   {"Vis_beck", 1.0 / (bl * bv) / four}});
}

TEST(BrdfRows, F) {
    const double eta = 0.8, k = 1.9, c = 0.7, f0 = f0_of(eta, 0.0), metal = f0_of(eta, k);
    expect_values(evaluated("terms_F", Cells().add("c", c).add("ior", eta).add("k", k)), {{"F0", f0},
                                                                                          {"F0k", metal},
                                                                                          {"F_schlick", schlick(f0, c)},
                                                                                          {"F_schlick1", f0 + (1.0 - f0) * (1.0 - c)},
                                                                                          {"F_dielectric", fresnel(eta, c)},
                                                                                          {"F_conductor", fresnel({eta, k}, c)},
                                                                                          {"F_schlick_k", schlick(metal, c)}});
}

TEST(BrdfRows, NothingIsReflectedByWhatLooksIntoTheSurface) {
    for (const auto& [column, value] : evaluated("terms_D", Cells().add("alpha", 1.5).add("nh", -0.5))) EXPECT_EQ(value, 0.0) << column;
    for (const char* below : {"nl", "nv"}) {
        const Cells row = Cells().add("alpha", 0.5).add("nl", 0.5).add("nv", 0.5).add("nh", 0.5).add("vh", 0.5);
        const auto values = evaluated("terms_G", row.with(below, -0.5));
        for (const char* column : {"G_ct", "G_ggx", "G_ggx_hc", "G_beck", "G_beck_hc", "Vis_ct", "Vis_ggx", "Vis_ggx_hc", "Vis_beck"})
            EXPECT_EQ(values.at(column), 0.0) << below << " " << column;
        EXPECT_EQ(values.at("G1_ggx_v") == 0.0, std::string(below) == "nv");
    }
}

Cells general(const Vec3& to_light, const Vec3& to_viewer) {
    return directions(to_light, to_viewer)
        .add("roughness", 0.7)
        .add("ior", 0.6)
        .add("k", 2.5)
        .add("ka", 0.1)
        .add("kd", 0.6)
        .add("s", 0.3)
        .add("lc", 1.7)
        .add("sigma", 0.6)
        .add("Dname", "beckmann")
        .add("Gname", "ggx-hc")
        .add("Fname", "conductor")
        .add("diffuse", "lambert");
}

TEST(BrdfRows, GeneralForm) {
    const double alpha = 0.49;
    const auto expect = [&](const Cells& row, double D, double G, double F, double rd, double nv) {
        const double rs = D * G * F / (4.0 * nl * nv), r = 0.1 + 1.7 * nl * (0.7 * rd + 0.3 * rs);
        for (const char* table : {"general_r", "contract"})
            expect_values(evaluated(table, row), {{"D", D}, {"G", G}, {"F", F}, {"rd", rd}, {"rs", rs}, {"r", r}});
    };
    const double hc = 2.0 / (ggx_root(nl, alpha) + ggx_root(nv, alpha)), metal = fresnel({0.6, 2.5}, vh);
    expect(general(l, v), beckmann(nh, alpha), hc, metal, 0.6, nv);
    expect(general(l, v).with("Dname", "ggx").with("diffuse", "none"), ggx(nh, alpha), hc, metal, 0.0, nv);
    const double ct = grooves(nl, nv, nh, vh);
    ASSERT_LT(ct, 0.9);
    expect(general(l, v).with("Dname", "blinn").with("Gname", "cook-torrance").with("Fname", "schlick"), blinn(nh, alpha), ct,
           schlick(f0_of(0.6, 2.5), vh), 0.6, nv);
    // Light and viewer on one side: l.v > n.l n.v, so that both parts of Oren and Nayar's term count.
    const double low = 4.0 / 49.0, u = 8.0 / 21.0 - nl * low, half = std::sqrt(2.0 + 16.0 / 21.0), c = (nl + low) / half;
    ASSERT_GT(u, 0.1);
    const double A = 1.0 - 0.36 / (2.0 * (0.36 + 0.33)), B = 0.45 * 0.36 / (0.36 + 0.09);
    const double G = 1.0 / (beckmann_lambda1(nl, alpha) * beckmann_lambda1(low, alpha));
    expect(general(l, Vec3(2, 6, -3) / 7.0).with("diffuse", "oren-nayar").with("Gname", "beckmann").with("Fname", "one"),
           beckmann(c, alpha), G, 1.0, 0.6 * (A + B * u / std::max(nl, low)), low);
}

TEST(BrdfRows, OfAnUnlitSurfaceTheAmbientLightRemains) {
    for (const char* table : {"general_r", "contract"})
        for (const auto& [to_light, to_viewer] : {std::pair{-l, v}, std::pair{l, -v}, std::pair{Vec3(0.0), v}, std::pair{l, Vec3(0.0)}})
            expect_values(evaluated(table, general(to_light, to_viewer)),
                          {{"D", 0.0}, {"G", 0.0}, {"F", 0.0}, {"rd", 0.0}, {"rs", 0.0}, {"r", 0.1}});
}

Cells effects(const Vec3& to_light) {
    return directions(to_light, v)
        .add("m", 0.6)
        .add("F0", 0.2)
        .add("ks", 0.9)
        .add("kd", 0.7)
        .add("ka", 0.3)
        .add("dc", 0.8)
        .add("il", 1.5)
        .add("power", 7.0)
        .add("dw", 0.05);
}

TEST(BrdfRows, Effects) {
    // Cook and Torrance with their halves inside of G: dw ks F D' G' / (2 m^2 pi n.v).
    const double D = std::exp(-tan2 / 0.36) / std::pow(nh, 4.0), G = std::min({0.5, nh * nv / vh, nh * nl / vh});
    const double lobe = 0.05 * 0.9 * D * G / (2.0 * 0.36 * pi * nv);
    const double linear = 0.2 + 0.8 * (1.0 - nv), fifth = schlick(0.2, nv), cube = 0.05 * 0.9 * fifth / (4.0 * 0.36 * pi * nv);
    std::map<std::string, double> want{{"ambient", 0.3 * 0.8},
                                       {"diffuse", 1.5 * 0.7 * nl * 0.8},
                                       {"phong_spec", 1.5 * 0.9 * std::pow(nh, 7.0)},
                                       {"ct_linear", lobe * linear},
                                       {"ct_simplified", lobe * fifth},
                                       {"ct_vh", lobe * schlick(0.2, vh)},
                                       {"cube", cube},
                                       {"F_linear", linear},
                                       {"F5_nv", fifth},
                                       {"cube_lit", 1.5 * cube}};
    expect_values(evaluated("seed0_effectsbrowser", effects(l)), want);
    for (const char* of_the_light : {"diffuse", "phong_spec", "ct_linear", "ct_simplified", "ct_vh"}) want[of_the_light] = 0.0;
    expect_values(evaluated("seed0_effectsbrowser", effects(-l)), want);
}

Cells gooch(const Vec3& to_light) {
    return directions(to_light, v).add("roughness", 0.8).add("ior", 1.6).add("kcool", 0.2).add("kwarm", 0.9).add("Dname", "ggx");
}

TEST(BrdfRows, Gooch) {
    const double alpha = 0.64, f0 = f0_of(1.6, 0.0), warmth = 0.5 * (1.0 + nl);
    const auto lobe = [&](double h, double u) { return ggx(h, alpha) * grooves(nl, nv, h, u) * schlick(f0, u) / (4.0 * nl * nv); };
    const double halfway = std::sqrt(0.5 * (1.0 + nv));  // cosine of half the angle from n to v
    expect_values(evaluated("seed2_gooch", gooch(l)), {{"k_spec", lobe(nh, vh)},
                                                       {"k_spec_literal", lobe(halfway, halfway)},
                                                       {"gooch", warmth * 0.9 + (1.0 - warmth) * 0.2},
                                                       {"gooch_literal", warmth * 0.2 + (1.0 - warmth) * 0.9}});
    expect_values(evaluated("seed2_gooch", gooch(-l)), {{"k_spec", 0.0},
                                                        {"k_spec_literal", 0.0},
                                                        {"gooch", (1.0 - warmth) * 0.9 + warmth * 0.2},
                                                        {"gooch_literal", (1.0 - warmth) * 0.2 + warmth * 0.9}});
}

Cells phong_lights(const std::string& light, const Vec3& lamp) {
    const Vec3 p(1, 2, 3);
    return Cells()
        .add("light", light)
        .add("n", n)
        .add("p", p)
        .add("e", p + 14.0 * v)
        .add("lp", lamp)
        .add("sd", Vec3(-1, -1, -3))
        .add("shininess", 4.0)
        .add("spot_exp", 5.0)
        .add("range", 6.5)
        .add("Ma", 0.5)
        .add("Ca", 0.4)
        .add("Md", 0.9)
        .add("Cd", 0.8)
        .add("Ms", 0.7)
        .add("Cs", 0.6);
}

TEST(BrdfRows, PhongUnderThreeLights) {
    // The lamp is 6 away along l; a parallel one shines along -l. r = 2 (n.l) n - l.
    const Vec3 place = Vec3(1, 2, 3) + 6.0 * l;
    const double rv = 2.0 * nl * nv - lv, Ld = 0.72 * nl, Ls = 0.42 * std::pow(rv, 4.0), att = 1.0 / (1.0 + 6.0 + 36.0);
    const double in_beam = 3.0 / std::sqrt(11.0), beam = std::pow(in_beam, 5.0);  // l.(1, 1, 3) = 3
    ASSERT_GT(rv, 0.2);
    const auto expect = [&](const Cells& row, double dist, double cos_spot, double att, double kspot) {
        expect_values(evaluated("seed3_phong_lights", row), {{"dist", dist},
                                                             {"cos_spot", cos_spot},
                                                             {"nl", nl},
                                                             {"La", 0.2},
                                                             {"Ld", Ld},
                                                             {"Ls", Ls},
                                                             {"Ls_seed", Ls},
                                                             {"att", att},
                                                             {"kspot", kspot},
                                                             {"total", 0.2 + kspot * att * (Ld + Ls)},
                                                             {"total_seed", kspot * att * (0.2 + Ld + Ls)}});
    };
    expect(phong_lights("parallel", -5.0 * l), 0.0, 1.0, 1.0, 1.0);
    expect(phong_lights("point", place), 6.0, 1.0, att, 1.0);
    expect(phong_lights("spot", place), 6.0, in_beam, att, beam);
    expect(phong_lights("point", place).with("range", 5.5), 6.0, 1.0, 0.0, 1.0);
    expect(phong_lights("point", place).with("range", "inf"), 6.0, 1.0, att, 1.0);
}

TEST(BrdfRows, PhongsHighlightEndsAtTheHorizonUnlessAsPrinted) {
    // Seen from within the surface's plane and lit from below it, r is on the viewer's side.
    const Vec3 below = Vec3(6, 2, -3) / 7.0;  // n.l = 0: 12 + 6 - 18
    const Vec3 to_light = unit(below - 0.1 * n), viewer = unit(-below + 0.1 * n);
    const Cells row = phong_lights("parallel", -to_light).with("ex", 1 + viewer.x).with("ey", 2 + viewer.y).with("ez", 3 + viewer.z);
    const double cos_l = dot(n, to_light), rv = dot(2.0 * cos_l * n - to_light, viewer);
    ASSERT_LT(cos_l, -0.05);
    ASSERT_GT(rv, 0.5);
    const auto values = evaluated("seed3_phong_lights", row);
    EXPECT_EQ(values.at("Ls"), 0.0);
    EXPECT_NEAR(values.at("Ls_seed"), 0.42 * std::pow(rv, 4.0), 1e-14);
    EXPECT_EQ(values.at("total"), 0.2);
}

Cells lecture(const Vec3& to_light) {
    return directions(to_light, v)
        .add("m", 0.6)
        .add("ratio", 1.8)
        .add("ka", 0.1)
        .add("ks", 0.3)
        .add("rho", 0.7)
        .add("Ia", 0.9)
        .add("Ii", 1.6);
}

TEST(BrdfRows, Lecture) {
    const double D = std::exp(-tan2 / 0.36) / (4.0 * 0.36 * std::pow(nh, 4.0)), G = grooves(nl, nv, nh, vh), F = fresnel(1.8, vh);
    const double spec = D * G * F / (pi * nv);
    const std::map<std::string, double> want{
        {"D", D}, {"G", G}, {"F", F}, {"spec", spec}, {"I", 0.9 * 0.1 + 1.6 * ((1.0 - 0.1 - 0.3) * 0.7 * nl + 0.3 * spec)}};
    expect_values(evaluated("seed4_lecture", lecture(l)), want);
    expect_values(evaluated("seed4_lecture", lecture(-l)), {{"D", 0.0}, {"G", 0.0}, {"F", 0.0}, {"spec", 0.0}, {"I", 0.9 * 0.1}});
    // Weights of more than all leave no diffuse light, not a negative one.
    const auto dark = evaluated("seed4_lecture", lecture(l).with("ka", 0.8).with("ks", 0.7));
    EXPECT_NEAR(dark.at("I"), 0.9 * 0.8 + 1.6 * 0.7 * spec, 1e-13);
}

}  // namespace
}  // namespace rt::brdf_rows_test
