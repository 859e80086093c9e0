// Every D, G and F of the catalogue against 80-digit values, at ordinary and at extreme inputs.
#include "shading/terms.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/shading/csv.h"

namespace rt::terms_test {
namespace {

using testing_csv::Table;
constexpr double u = 0x1p-53;

const std::map<std::string, Distribution> distributions{{"blinn", Distribution::blinn},
                                                        {"blinn-inverse-roughness", Distribution::blinn_inverse_roughness},
                                                        {"beckmann", Distribution::beckmann},
                                                        {"ggx", Distribution::ggx},
                                                        {"gaussian", Distribution::gaussian}};
const std::map<std::string, Masking> maskings{{"cook-torrance", Masking::cook_torrance},
                                              {"ggx", Masking::ggx},
                                              {"ggx-hc", Masking::ggx_hc},
                                              {"beckmann", Masking::beckmann},
                                              {"beckmann-hc", Masking::beckmann_hc},
                                              {"beckmann-rational", Masking::beckmann_rational},
                                              {"none", Masking::none}};
const std::map<std::string, Fresnel> fresnels{{"one", Fresnel::one},
                                              {"constant", Fresnel::constant},
                                              {"schlick", Fresnel::schlick},
                                              {"schlick-linear", Fresnel::schlick_linear},
                                              {"schlick-f82", Fresnel::schlick_f82},
                                              {"dielectric", Fresnel::dielectric},
                                              {"conductor", Fresnel::conductor}};

class GoldenTerms : public ::testing::Test {
protected:
    const Table t{PROJECT_ROOT "/tests/golden/terms.csv"};
    /// Calls `test` with every row of a term and its name; expects 60 rows for each of `names`.
    void each(const std::string& term, const auto& names, const auto& test) const {
        std::map<std::string, int> rows;
        for (std::size_t i = 0; i < t.size(); ++i) {
            if (t.text(i, "term") != term) continue;
            ++rows[t.text(i, "name")];
            test(i, names.at(t.text(i, "name")));
        }
        for (const auto& [name, kind] : names) EXPECT_EQ(rows[name], 60) << name;
    }
    void near(std::size_t row, double got, double want, double relative, double absolute) const {
        const bool equal = got == want || std::fabs(got - want) <= relative * std::fabs(want) + absolute;
        EXPECT_TRUE(equal) << "row " << row << " " << t.text(row, "name") << ": " << got << " instead of " << want << ", "
                           << std::fabs(got / want - 1.0) / relative << " times the tolerance";
    }
};

TEST_F(GoldenTerms, D) {
    each("D", distributions, [&](std::size_t i, Distribution kind) {
        const double alpha = t.number(i, "alpha"), want = t.number(i, "value");
        const Incline h = incline(t.number(i, "nh"));
        const double steepness = want > 0.0 ? std::fabs(std::log(want)) + h.sin2 / sqr(h.cos) / alpha / alpha : 0.0;
        near(i, D(kind, sqr(h.cos), h.sin2, alpha), want, u * (32 + 4 * steepness), 1e-300);
    });
}

TEST_F(GoldenTerms, G) {
    each("G", maskings, [&](std::size_t i, Masking kind) {
        HalfGeometry g;
        g.l = incline(t.number(i, "nl"));
        g.v = incline(t.number(i, "nv"));
        const double nh = t.number(i, "nh"), vh = t.number(i, "vh");
        g.v_dot_h = vh;
        g.n_dot_s = nh * (2.0 * vh);  // |s| = 2 v.h
        g.s_dot_s = sqr(2.0 * vh);
        near(i, G(kind, g, t.number(i, "alpha")), t.number(i, "value"), 256 * u, 1e-300);
        near(i, visibility(kind, g, t.number(i, "alpha")), t.number(i, "V"), 256 * u, 1e-300);
    });
}

TEST_F(GoldenTerms, F) {
    each("F", fresnels, [&](std::size_t i, Fresnel kind) {
        const Interface x = interface_of(t.number(i, "eta"), t.number(i, "k"));
        // schlick-f82 is a difference of reflectances: its error is one of numbers up to 1.
        near(i, F(kind, x, t.number(i, "vh")), t.number(i, "value"), 256 * u, kind == Fresnel::schlick_f82 ? 256 * u : 1e-300);
    });
}

TEST(Fresnel, the_modulus_keeps_its_digits_where_squares_leave_the_range) {
    for (const double size : {1e-320, 1e-300, 1e-160, 1e-139, 1e-10, 1.0, 1e100, 1e149, 1e151, 1e200, 1e300})
        for (const double share : {0.0, 1e-200, 1e-9, 0.3, 1.0}) {
            const double want = std::hypot(size, size * share);
            EXPECT_NEAR(modulus(size, -size * share), want, 2.0 * (std::nextafter(want, HUGE_VAL) - want)) << size << ' ' << share;
            EXPECT_EQ(modulus(size * share, size), modulus(size, size * share));
        }
    EXPECT_EQ(modulus(0.0, 0.0), 0.0);
}

}  // namespace
}  // namespace rt::terms_test
