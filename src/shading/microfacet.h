// Microfacet reflection: the catalogue of normal distributions D, masking functions G and Fresnel terms F as pure functions, one enum value
// and one case of a dispatch each. Everything is in doubles; the forms are the ones that lose no digits near the highlight or at grazing.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace rt {

enum class Distribution { ggx };
enum class Masking { ggx };
enum class Fresnel { schlick };

/// The terms of one microfacet model.
struct MicrofacetTerms {
    Distribution D = Distribution::ggx;
    Masking G = Masking::ggx;
    Fresnel F = Fresnel::schlick;
};

// ---- geometry, once per light ----

/// a b - c d with an error of 1.5 ulp of the result (Kahan; Jeannerod, Louvet, Muller 2013).
inline double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// a x b without cancellation: the sine of a small angle keeps its relative accuracy.
inline Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// What D, G and F need to know of one direction x: its cosine to the normal and the square of its sine.
struct Incline {
    double cos = 0.0;
    double sin2 = 0.0;
};

inline Incline incline(const Vec3& n, const Vec3& x) {
    const Vec3 sine = accurate_cross(n, x);
    return {dot(n, x), dot(sine, sine)};
}

/// The pair of directions l and v as the microfacet terms see it.
struct HalfGeometry {
    Incline l, v;
    double cos2_h = 1.0;   ///< square of n.h; with sin2_h it sums to 1
    double sin2_h = 0.0;   ///< from a cross product, never as 1 - cos2_h
    double v_dot_h = 1.0;  ///< = l.h = |l + v| / 2
};

/// Below this cosine a direction counts as below the surface: |l + v|^2 and the product of the cosines stay normal numbers.
inline constexpr double least_cosine = 1e-150;

/// n, l, v unit, all pointing away from the surface; `v` holds n.v of the same n. False if either direction is at or below the surface
/// or not a number: then nothing is reflected. l = -v cannot pass, so no epsilon guards it.
inline bool half_geometry(const Vec3& n, const Vec3& l, const Vec3& v, const Incline& incline_v, HalfGeometry& g) {
    const double n_dot_l = dot(n, l);
    if (!(n_dot_l > least_cosine && incline_v.cos > least_cosine)) return false;
    const Vec3 s = l + v;
    const double n_dot_s = n_dot_l + incline_v.cos;
    const Vec3 x = accurate_cross(n, s);
    const double xx = dot(x, x);
    const double q = n_dot_s * n_dot_s + xx;  // |n|^2 |s|^2: renormalises
    g.l = incline(n, l);
    g.v = incline_v;
    g.cos2_h = n_dot_s * n_dot_s / q;
    g.sin2_h = xx / q;
    g.v_dot_h = std::min(1.0, 0.5 * std::sqrt(dot(s, s)));
    return true;
}

// ---- D: normal distributions, in 1/steradian, for n.h > 0; 0 for alpha below 1e-150 (the spike belongs to the mirror ray) ----

/// GGX (Walter, Marschner, Li, Torrance 2007; Trowbridge, Reitz 1975). Any alpha >= 1e-150; alpha above 1 is allowed.
inline double D_ggx(double cos2_h, double sin2_h, double alpha) {
    if (!(alpha >= 1e-150)) return 0.0;
    const double k = alpha / (sin2_h + alpha * alpha * cos2_h);
    return k * k / pi;
}

inline double D(Distribution kind, double cos2_h, double sin2_h, double alpha) {
    switch (kind) {
        case Distribution::ggx:
            return D_ggx(cos2_h, sin2_h, alpha);
    }
    return 0.0;
}

// ---- G: masking and shadowing, 0..1, and V = G / (4 n.l n.v), the only form that is evaluated while rendering ----

/// sqrt(cos^2 + alpha^2 sin^2), to which Smith's GGX terms reduce without a tangent.
inline double smith_ggx_root(const Incline& x, double alpha) { return std::sqrt(x.cos * x.cos + alpha * alpha * x.sin2); }

/// Smith's masking of one direction for GGX (Smith 1967; Walter et al. 2007): 2 / (1 + sqrt(1 + alpha^2 tan^2)).
inline double G1_ggx(const Incline& x, double alpha) { return x.cos > 0.0 ? 2.0 * x.cos / (x.cos + smith_ggx_root(x, alpha)) : 0.0; }

/// Separable Smith G of both directions.
inline double G_ggx(const Incline& l, const Incline& v, double alpha) { return G1_ggx(l, alpha) * G1_ggx(v, alpha); }

/// G_ggx / (4 n.l n.v), finite down to the smallest cosines.
inline double V_ggx(const Incline& l, const Incline& v, double alpha) {
    return 1.0 / ((l.cos + smith_ggx_root(l, alpha)) * (v.cos + smith_ggx_root(v, alpha)));
}

inline double G(Masking kind, const HalfGeometry& g, double alpha) {
    switch (kind) {
        case Masking::ggx:
            return G_ggx(g.l, g.v, alpha);
    }
    return 0.0;
}

/// V = G / (4 n.l n.v) in 1/1: the one place where the denominator of the microfacet form is.
inline double visibility(Masking kind, const HalfGeometry& g, double alpha) {
    switch (kind) {
        case Masking::ggx:
            return V_ggx(g.l, g.v, alpha);
    }
    return 0.0;
}

// ---- F: Fresnel reflectance, 0..1 ----

/// Reflectance at normal incidence of relative index eta and extinction k.
inline double f0_from_ior(double eta, double k = 0.0) {
    if (k == 0.0) return sqr((eta - 1.0) / (eta + 1.0));
    return (sqr(eta - 1.0) + k * k) / (sqr(eta + 1.0) + k * k);
}

/// Schlick 1994, "An inexpensive BRDF model for physically-based rendering".
inline double F_schlick(double f0, double v_dot_h) {
    const double x = std::clamp(1.0 - v_dot_h, 0.0, 1.0);
    const double x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

inline double F(Fresnel kind, double f0, double v_dot_h) {
    switch (kind) {
        case Fresnel::schlick:
            return F_schlick(f0, v_dot_h);
    }
    return 0.0;
}

/// The same for a coloured reflectance at normal incidence.
inline Rgb F(Fresnel kind, const Rgb& f0, double v_dot_h) {
    return {F(kind, f0.r, v_dot_h), F(kind, f0.g, v_dot_h), F(kind, f0.b, v_dot_h)};
}

// ---- the lobe ----

/// n.l D G / (4 n.l n.v), to be multiplied by F: what one light of unit colour reflects but for Fresnel. The factors are taken in an order
/// in which a D that underflowed to 0 meets a large V before an infinity can form.
inline double microfacet_lobe(const MicrofacetTerms& terms, const HalfGeometry& g, double alpha) {
    const double d = D(terms.D, g.cos2_h, g.sin2_h, alpha);
    return d == 0.0 ? 0.0 : d * (g.l.cos * visibility(terms.G, g, alpha));
}

}  // namespace rt
