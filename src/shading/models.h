// Models made of the terms: what one light of colour 1 adds to one channel, n.l included unless a model has none.
#pragma once

#include "shading/terms.h"

namespace rt {

/// The terms of a microfacet lobe and the variants that texts print. The default is the normalised form with the half vector of l and v.
struct MicrofacetTerms {
    Distribution D = Distribution::ggx;
    Masking G = Masking::ggx;
    Fresnel F = Fresnel::schlick;
    double factor = 1.0;           ///< on the lobe: pi for physical units, 4 for Cook and Torrance's unnormalised print, a solid angle
    bool fresnel_at_view = false;  ///< F of n.v instead of v.h: not reciprocal
    bool half_of_normal_and_view = false;  ///< a misprint's half vector: the highlight does not follow the light
    bool clamped_denominator = false;      ///< 4 max(1/16, n.v) instead of 4 n.v: darker at grazing, not reciprocal
    bool without_cosine = false;           ///< rs itself, without n.l: diverges as n.l goes to 0
};

/// Values beyond this are cut to it, so that no product with a light overflows; only alphas far above 1 seen at grazing come there.
inline constexpr double largest_lobe = 1e200;

/// n.l D G / (4 n.l n.v) without the factor. A D that underflowed to 0 ends it before an infinite V can meet it.
inline double unscaled_lobe(const MicrofacetTerms& terms, const HalfGeometry& g, double alpha) {
    const double d = D(terms.D, g.cos2_h, g.sin2_h, alpha);
    if (d == 0.0) return 0.0;
    double V = visibility(terms.G, g, alpha);
    if (terms.clamped_denominator) V *= g.v.cos / std::max(1.0 / 16.0, g.v.cos);
    if (!terms.without_cosine) V *= g.l.cos;
    return d * V;
}
inline double scaled_lobe(double factor, double unscaled) { return std::min(factor * unscaled, largest_lobe); }

/// n.l D G / (4 n.l n.v) with the terms' factor, to be multiplied by F: what one light of unit colour reflects but for Fresnel.
inline double microfacet_lobe(const MicrofacetTerms& terms, const HalfGeometry& g, double alpha) {
    return scaled_lobe(terms.factor, unscaled_lobe(terms, g, alpha));
}

/// The cosine at which the terms ask for F.
inline double incidence(const MicrofacetTerms& terms, const HalfGeometry& g) {
    return terms.fresnel_at_view ? std::min(1.0, g.v.cos) : g.v_dot_h;
}
inline double reflectance(const MicrofacetTerms& terms, const Interface& x, const HalfGeometry& g) {
    return F(terms.F, x, incidence(terms, g));
}

/// A real-time form of Cook and Torrance's, lit by lights of the solid angle `dw`: dw k_s F D' G' / (2 m^2 pi n.v). It is the normalised
/// Beckmann lobe with the V-grooves, times dw, and Fresnel's argument is n.v; `linear` prints Schlick without the fifth power.
inline MicrofacetTerms effects_terms(double dw, bool linear) {
    return {.D = Distribution::beckmann,
            .G = Masking::cook_torrance,
            .F = linear ? Fresnel::schlick_linear : Fresnel::schlick,
            .factor = dw,
            .fresnel_at_view = true};
}

/// The lecture's k_s D G F / (pi n.v) with D = exp(-tan^2/m^2) / (4 m^2 cos^4): the same function as the normalised form.
constexpr MicrofacetTerms lecture_terms() { return {.D = Distribution::beckmann, .G = Masking::cook_torrance, .F = Fresnel::dielectric}; }
/// Its diffuse weight, 1 - k_a - k_s and never negative.
inline double lecture_diffuse(double ka, double ks) { return std::max(0.0, 1.0 - ka - ks); }

/// Phong 1975: max(r.v, 0)^p with r = 2 (n.l) n - l, without n.l; 0 on the unlit side unless `gated` is false.
inline double phong(const Vec3& n, const Vec3& l, const Vec3& v, double p, bool gated = true) {
    const double n_dot_l = dot(n, l);
    if (gated && !(n_dot_l > 0.0)) return 0.0;
    const Vec3 r = 2.0 * n_dot_l * n - l;
    const Vec3 sine = accurate_cross(r, v);
    return cosine_power(dot(r, v), dot(sine, sine), p);
}

/// max(r.v^p, 0) as a text prints it: an even exponent lights the back, and where there is no power there is no light.
inline double phong_clamped_after(const Vec3& n, const Vec3& l, const Vec3& v, double p, bool gated = true) {
    if (gated && !(dot(n, l) > 0.0)) return 0.0;
    return power_clamped_after(dot(2.0 * dot(n, l) * n - l, v), p);
}

/// Blinn's way to Phong's highlight: (n.h)^p, without n.l.
inline double blinn_phong(const HalfGeometry& g, double p) { return std::exp(-0.5 * p * std::log1p(g.sin2_h / g.cos2_h)); }

/// Gooch, Gooch, Shirley, Cohen 1998: from the cool colour away from the light to the warm one towards it. Not light: no shadow, no n.l.
inline double gooch(double n_dot_l, double cool, double warm) {
    const double x = std::clamp(0.5 * (1.0 + n_dot_l), 0.0, 1.0);
    return x * warm + (1.0 - x) * cool;
}

/// Weight of the mirror direction of surroundings lit as a lamp of solid angle `dw`: dw F / (4 m^2 pi n.v), cut to `largest_lobe`; as
/// printed it has no bound, neither at grazing nor for small alpha.
inline double effects_environment(double f0, double alpha, double n_dot_v, double dw) {
    const double flux = dw * F_schlick(f0, n_dot_v);
    if (flux == 0.0 || alpha < least_alpha) return 0.0;  // no lamp, or, as for D, no lobe
    return std::min(flux / (4.0 * pi * alpha * (alpha * n_dot_v)), largest_lobe);
}

/// What a surface sends on of the light that arrives from the mirror direction R = 2 (n.v) n - v.
enum class Surroundings {
    finish,      ///< what the finish itself says
    mirror,      ///< all of it, times k_s
    fresnel,     ///< k_s F(n.v), the limit of the microfacet lobe for alpha to 0
    albedo,      ///< k_s E(n.v), the directional albedo of the lobe
    ct_effects,  ///< k_s effects_environment()
};

}  // namespace rt
