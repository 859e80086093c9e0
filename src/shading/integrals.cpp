#include "shading/integrals.h"

namespace rt {

double normalization(Distribution kind, double alpha) {
    // With tan^2 = alpha^2 e^y the measure (n.m) d omega becomes pi t / (1 + t)^2 dy, and the sum converges geometrically. The tail of
    // Blinn's wide lobes falls as e^(-y / alpha^2) only.
    constexpr double step = 0.02;
    const double last = 80.0 + 40.0 * alpha * alpha;
    double sum = 0.0;
    for (double y = -80.0; y < last; y += step) {
        const double t = alpha * alpha * std::exp(y);
        sum += D(kind, 1.0 / (1.0 + t), t / (1.0 + t), alpha) * (pi * t / sqr(1.0 + t));
    }
    return sum * step;
}

double directional_albedo(Distribution kind, Masking masking, double alpha, double n_dot_v) {
    return directional_albedo({.D = kind, .G = masking, .F = Fresnel::one}, Interface{}, alpha, n_dot_v);
}

double directional_albedo(const MicrofacetTerms& chosen, const Interface& x, double alpha, double n_dot_v) {
    constexpr int rings = 1024, spokes = 256;
    const Vec3 n(0, 0, 1), v(std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v)), 0.0, n_dot_v);
    const Incline incline_v = incline(n, v);
    const MicrofacetTerms terms{.D = chosen.D, .G = chosen.G};
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        // Normals m of GGX by the inverse of its distribution at 1 - w^2: the square takes away the singularity 1 / n.m at the horizon. The
        // half of the spokes that y mirrors is left out.
        const double w = 1.0 - (i + 0.5) / rings, tan2 = alpha * alpha * (1.0 - w) * (1.0 + w) / (w * w);
        const double cos2 = 1.0 / (1.0 + tan2), sin2 = tan2 / (1.0 + tan2), density = D_ggx(cos2, sin2, alpha) * std::sqrt(cos2);
        // Turned a little from ring to ring, so that the horizon does not cut all rings alike.
        const double turn = 0.6180339887498949 * i - std::floor(0.6180339887498949 * i);
        for (int j = 0; j < spokes; ++j) {
            const double phi = pi * (j + turn) / spokes;
            const Vec3 m(std::sqrt(sin2) * std::cos(phi), std::sqrt(sin2) * std::sin(phi), std::sqrt(cos2));
            const double v_dot_m = dot(v, m);
            if (!(v_dot_m > 0.0)) continue;
            HalfGeometry g;
            if (half_geometry(n, 2.0 * v_dot_m * m - v, v, incline_v, g))
                sum += microfacet_lobe(terms, g, alpha) * F(chosen.F, x, g.v_dot_h) * 8.0 * w * v_dot_m / density;
        }
    }
    return sum / (rings * spokes);
}

}  // namespace rt
