#include "shading/albedo.h"

namespace rt {

AlbedoTable::AlbedoTable(const MicrofacetTerms& terms, const Interface (&channels)[3], double alpha) {
    const MicrofacetTerms plain{.D = terms.D, .G = terms.G, .F = terms.F};
    constexpr double grazing = 1e-4;  // instead of 0, where there is no albedo
    for (int i = 0; i <= intervals; ++i)
        nodes_[static_cast<std::size_t>(i)] = node(plain, channels, alpha, i == 0 ? grazing : sqr(static_cast<double>(i) / intervals));
}

/// Sum over the normals of GGX that the viewer sees, each the half vector of v and one l (Dupuy, Benyoub 2023, "Sampling Visible GGX
/// Normals with Spherical Caps"): their density leaves D / D_ggx G / G1 F to be averaged. The points are a lattice, so the sum is always
/// the same.
AlbedoTable::Node AlbedoTable::node(const MicrofacetTerms& terms, const Interface (&channels)[3], double alpha, double n_dot_v) const {
    constexpr int count = 1024;
    constexpr double golden = 0.6180339887498949;
    const Vec3 n(0, 0, 1), v(std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v)), 0.0, n_dot_v);
    const Incline incline_v = incline(n, v);
    const Vec3 stretched = unit(Vec3(alpha * v.x, 0.0, v.z));
    const double root = smith_ggx_root(incline_v, alpha);
    Node sum{Rgb(0.0), Rgb(0.0)};
    for (int i = 0; i < count; ++i) {
        const double z = (1.0 - (i + 0.5) / count) * (1.0 + stretched.z) - stretched.z;
        const double phi = pi * (golden * i - std::floor(golden * i));  // the other half is its mirror image
        const double sine = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
        const Vec3 h = Vec3(sine * std::cos(phi), sine * std::sin(phi), z) + stretched;
        const Vec3 m = unit(Vec3(alpha * h.x, alpha * h.y, h.z));
        const double v_dot_m = dot(v, m);
        HalfGeometry g;
        if (!(v_dot_m > 0.0) || !half_geometry(n, 2.0 * v_dot_m * m - v, v, incline_v, g)) continue;
        const double density = D_ggx(g.cos2_h, g.sin2_h, alpha) / (2.0 * (n_dot_v + root));  // of l, per solid angle
        const double share = microfacet_lobe(terms, g, alpha) / density;
        for (int channel = 0; channel < 3; ++channel) {
            if (channel > 0 && channels[channel] == channels[0]) {
                sum.tinted[channel] = sum.tinted[0], sum.untinted[channel] = sum.untinted[0];
                continue;
            }
            Interface x = channels[channel];
            sum.tinted[channel] += share * F(terms.F, x, g.v_dot_h);
            x.f0 = 0.0;
            sum.untinted[channel] += share * F(terms.F, x, g.v_dot_h);
        }
    }
    return {sum.tinted / static_cast<double>(count), sum.untinted / static_cast<double>(count)};
}

double AlbedoTable::at(int channel, double n_dot_v, double tint) const {
    const double place = std::sqrt(std::clamp(n_dot_v, 0.0, 1.0)) * intervals;
    const int i = std::min(static_cast<int>(place), intervals - 1);
    const double f = place - i;
    const Node &low = nodes_[static_cast<std::size_t>(i)], &high = nodes_[static_cast<std::size_t>(i) + 1];
    const double tinted = (1.0 - f) * low.tinted[channel] + f * high.tinted[channel];
    const double untinted = (1.0 - f) * low.untinted[channel] + f * high.untinted[channel];
    return untinted + tint * (tinted - untinted);
}

}  // namespace rt
