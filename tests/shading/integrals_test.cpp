// Integrals over the hemisphere against closed forms and values of 30-digit quadrature.
#include "shading/integrals.h"

#include <gtest/gtest.h>

namespace rt::integrals_test {
namespace {

TEST(Integrals, normalised_distributions_integrate_to_one) {
    for (const double alpha : {1e-8, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.8, 1.0, 1.5})
        for (const Distribution kind : {Distribution::blinn, Distribution::beckmann, Distribution::ggx})
            EXPECT_NEAR(normalization(kind, alpha), 1.0, 1e-12) << static_cast<int>(kind) << " " << alpha;
}

TEST(Integrals, blinn_by_the_inverse_of_roughness_does_not) {
    // 2 / (r^3 (1 + 2 r)) with alpha = r^2.
    for (const double r : {0.1, 0.5, 0.89498, 1.0})
        EXPECT_NEAR(normalization(Distribution::blinn_inverse_roughness, r * r), 2.0 / (r * r * r * (1.0 + 2.0 * r)), 1e-10 / (r * r * r))
            << r;
}

TEST(Integrals, directional_albedo) {
    struct Row {
        Distribution D;
        Masking G;
        double alpha, at_1, at_half, at_tenth;
    };
    const Row rows[] = {{Distribution::ggx, Masking::ggx, 0.1, 0.988, 0.969, 0.873},
                        {Distribution::ggx, Masking::ggx, 1.0, 0.307, 0.409, 0.558},
                        {Distribution::ggx, Masking::ggx_hc, 0.5, 0.688, 0.698, 0.860},
                        {Distribution::ggx, Masking::none, 0.25, 0.941, 0.972, 1.784},
                        {Distribution::beckmann, Masking::beckmann, 0.5, 0.943, 0.869, 0.936},
                        {Distribution::beckmann, Masking::cook_torrance, 0.25, 0.999, 0.943, 0.961},
                        {Distribution::blinn, Masking::cook_torrance, 1.0, 0.375, 0.653, 0.931}};
    for (const Row& row : rows) {
        EXPECT_NEAR(directional_albedo(row.D, row.G, row.alpha, 1.0), row.at_1, 1e-3) << row.alpha;
        EXPECT_NEAR(directional_albedo(row.D, row.G, row.alpha, 0.5), row.at_half, 1e-3) << row.alpha;
        EXPECT_NEAR(directional_albedo(row.D, row.G, row.alpha, 0.1), row.at_tenth, 1e-3) << row.alpha;
    }
    // alpha 1 is D = 1/pi; without masking (1/pi) / (4 n.v) times pi 2 of the hemisphere of l = 1 / (2 n.v).
    EXPECT_NEAR(directional_albedo(Distribution::ggx, Masking::none, 1.0, 0.5), 1.0, 1e-4);
    EXPECT_NEAR(directional_albedo(Distribution::ggx, Masking::none, 1.0, 0.1), 5.0, 1e-3);
}

}  // namespace
}  // namespace rt::integrals_test
