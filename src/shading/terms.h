// The catalogue of terms in r = ka + sum lc (n.l) (d rd + s rs), rs = D G F / (4 n.l n.v): diffuse reflection rd, normal distributions D,
// masking G and Fresnel reflectance F, as pure functions in doubles. One enum value and one case of a dispatch each. Every form is finite
// for every geometry that half_geometry() lets pass and loses no digits near the highlight, at grazing or for extreme parameters.
#pragma once

#include <limits>

#include "shading/half_geometry.h"

namespace rt {

// ---- D: normal distributions in 1/steradian, of the squares of cosine and sine of the half angle; alpha > 0 is the width, roughness^2 by
// default and the rms slope m of Beckmann's. Widths above 1 are allowed; below `least_alpha` D is 0: the spike belongs to the mirror ray.
// Above `greatest_alpha` it is 0, too: so little is left of it everywhere but at the horizon.

enum class Distribution { blinn, blinn_inverse_roughness, beckmann, ggx, gaussian };

inline constexpr double least_alpha = 1e-150;
inline constexpr double greatest_alpha = 1e150;

/// Logarithm of the squared cosine, from whichever of the squares loses less.
inline double log_cos2(double cos2_h, double sin2_h) { return sin2_h < 0.5 ? std::log1p(-sin2_h) : std::log(cos2_h); }
/// (n.h)^(2 exponent) / (pi alpha^2): Blinn 1977 by any power.
inline double D_power(double cos2_h, double sin2_h, double alpha, double exponent) {
    if (exponent == 0.0) return 1.0 / (pi * alpha * alpha);
    return std::exp(exponent * log_cos2(cos2_h, sin2_h)) / (pi * alpha * alpha);
}
/// Blinn with power 2/alpha^2 - 2, which integrates to 1 for every alpha (Walter, Marschner, Li, Torrance 2007, with this width).
/// Above 1 the power is negative; one division by the cosine's square leaves a small positive one, and nothing large to cancel.
inline double D_blinn(double cos2_h, double sin2_h, double alpha) {
    if (alpha > 1.0 && cos2_h > 0.0) return std::exp(log_cos2(cos2_h, sin2_h) / alpha / alpha) / (pi * alpha * (alpha * cos2_h));
    return D_power(cos2_h, sin2_h, alpha, ((1.0 - alpha) / alpha) * ((1.0 + alpha) / alpha));
}
/// Blinn with power 1/roughness, roughness = sqrt(alpha): integrates to 1 only at roughness 0.895.
inline double D_blinn_inverse_roughness(double cos2_h, double sin2_h, double alpha) {
    return D_power(cos2_h, sin2_h, alpha, 0.5 / std::sqrt(alpha));
}
/// Beckmann, Spizzichino 1963, as Cook, Torrance 1982 use it, normalised.
inline double D_beckmann(double cos2_h, double sin2_h, double alpha) {
    const double x = sin2_h / (cos2_h * alpha * alpha);
    if (!(x <= 1400.0)) return 0.0;
    return sqr(std::exp(-0.5 * x) / (alpha * cos2_h)) / pi;  // squared last: the exponential alone would underflow where D does not
}
/// GGX (Trowbridge, Reitz 1975; Walter et al. 2007).
inline double D_ggx(double cos2_h, double sin2_h, double alpha) {
    const double k = alpha / (sin2_h + alpha * (alpha * cos2_h));
    return k * k / pi;
}
/// exp(-(angle/alpha)^2): the Gaussian that Cook, Torrance 1982 mention; not normalised, its constant is part of ks.
inline double D_gaussian(double cos2_h, double sin2_h, double alpha) {
    return std::exp(-sqr(std::atan2(std::sqrt(sin2_h), std::sqrt(cos2_h)) / alpha));
}

inline double D(Distribution kind, double cos2_h, double sin2_h, double alpha) {
    if (!(alpha >= least_alpha && alpha <= greatest_alpha)) return 0.0;
    switch (kind) {
        case Distribution::blinn:
            return D_blinn(cos2_h, sin2_h, alpha);
        case Distribution::blinn_inverse_roughness:
            return D_blinn_inverse_roughness(cos2_h, sin2_h, alpha);
        case Distribution::beckmann:
            return D_beckmann(cos2_h, sin2_h, alpha);
        case Distribution::ggx:
            return D_ggx(cos2_h, sin2_h, alpha);
        case Distribution::gaussian:
            return D_gaussian(cos2_h, sin2_h, alpha);
    }
    return 0.0;
}

// ---- G: masking and shadowing, 0..1, as the visibility V = G / (4 n.l n.v), which stays finite where the quotient would not.

enum class Masking { cook_torrance, ggx, ggx_hc, beckmann, beckmann_hc, beckmann_rational, none };

/// The V-grooves of Torrance, Sparrow 1967 and Cook, Torrance 1982: G = min(1, 2 nh nv / vh, 2 nh nl / vh).
inline double V_cook_torrance(const HalfGeometry& g) {
    const double nl = g.l.cos, nv = g.v.cos;
    return std::min(1.0 / (4.0 * nl * nv), g.n_dot_s / (g.s_dot_s * std::max(nl, nv)));
}

/// sqrt(cos^2 + alpha^2 sin^2), to which Smith's GGX terms reduce without a tangent.
inline double smith_ggx_root(const Incline& x, double alpha) { return std::sqrt(x.cos * x.cos + alpha * alpha * x.sin2); }

/// Smith's masking for GGX, both directions on their own (Smith 1967; Walter et al. 2007): G1 = 2 / (1 + sqrt(1 + alpha^2 tan^2)).
inline double V_ggx(const Incline& l, const Incline& v, double alpha) {
    return 1.0 / ((l.cos + smith_ggx_root(l, alpha)) * (v.cos + smith_ggx_root(v, alpha)));
}
/// The same for the height-correlated pair (Heitz 2014).
inline double V_ggx_hc(const Incline& l, const Incline& v, double alpha) {
    return 0.5 / (l.cos * smith_ggx_root(v, alpha) + v.cos * smith_ggx_root(l, alpha));
}

/// 2 cos / G1 of Smith's exact masking for Beckmann: G1 = 2 / (1 + erf a + exp(-a^2) / (a sqrt pi)), a = 1 / (alpha tan).
inline double smith_beckmann_divisor(const Incline& x, double alpha) {
    const double spread = alpha * std::sqrt(x.sin2);
    if (!(spread > 0.0)) return 2.0 * x.cos;
    const double a = x.cos / spread;
    return x.cos * (1.0 + std::erf(a)) + spread * std::exp(-a * a) / std::sqrt(pi);
}
inline double V_beckmann(const Incline& l, const Incline& v, double alpha) {
    return 1.0 / (smith_beckmann_divisor(l, alpha) * smith_beckmann_divisor(v, alpha));
}
/// Height-correlated: 1 / (1 + Lambda(l) + Lambda(v)) with 1 + Lambda = divisor / (2 cos).
inline double V_beckmann_hc(const Incline& l, const Incline& v, double alpha) {
    const double both = l.cos * smith_beckmann_divisor(v, alpha) + v.cos * smith_beckmann_divisor(l, alpha);
    return 0.5 / (both - 2.0 * l.cos * v.cos);
}

/// G1 / cos of the rational fit of Walter et al. 2007 to Smith's masking for Beckmann (0.3 %, with a small jump at a = 1.6).
inline double rational_beckmann_over_cosine(const Incline& x, double alpha) {
    const double spread = alpha * std::sqrt(x.sin2);
    const double a = x.cos / spread;  // infinite or not a number where nothing is masked
    if (!(a < 1.6)) return 1.0 / x.cos;
    return (3.535 + 2.181 * a) / ((1.0 + a * (2.276 + 2.577 * a)) * spread);
}

/// V = G / (4 n.l n.v): the one place where the denominator of the microfacet form is.
inline double visibility(Masking kind, const HalfGeometry& g, double alpha) {
    switch (kind) {
        case Masking::cook_torrance:
            return V_cook_torrance(g);
        case Masking::ggx:
            return V_ggx(g.l, g.v, alpha);
        case Masking::ggx_hc:
            return V_ggx_hc(g.l, g.v, alpha);
        case Masking::beckmann:
            return V_beckmann(g.l, g.v, alpha);
        case Masking::beckmann_hc:
            return V_beckmann_hc(g.l, g.v, alpha);
        case Masking::beckmann_rational:
            return 0.25 * rational_beckmann_over_cosine(g.l, alpha) * rational_beckmann_over_cosine(g.v, alpha);
        case Masking::none:
            return 1.0 / (4.0 * g.l.cos * g.v.cos);
    }
    return 0.0;
}

/// G itself, for tables and tests.
inline double G(Masking kind, const HalfGeometry& g, double alpha) {
    return std::min(1.0, visibility(kind, g, alpha) * (4.0 * g.l.cos * g.v.cos));
}

// ---- F: reflectance 0..1 of one channel at cosine c = v.h of incidence.

enum class Fresnel { one, constant, schlick, schlick_linear, schlick_f82, dielectric, conductor };

/// One channel of an interface: relative index eta + i k, and what follows from it once.
struct Interface {
    double eta = 1.5, k = 0.0;
    double f0 = 0.04;  ///< reflectance at normal incidence
    double f82 = 0.0;  ///< what schlick-f82 takes away, see below
    bool operator==(const Interface&) const = default;
};

/// ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2), finite for the largest indices.
inline double f0_from_ior(double eta, double k = 0.0) {
    if (k == 0.0) return sqr((eta - 1.0) / (eta + 1.0));
    const double scale = 1.0 / std::max({eta, k, 1.0});
    const double a = (eta - 1.0) * scale, b = (eta + 1.0) * scale, c = k * scale;
    return (a * a + c * c) / (b * b + c * c);
}

/// Unpolarised reflectance of a dielectric (Fresnel 1823): 1 on total reflection, 0 for eta = 1. With e = eta^2 - 1 the amplitudes are
/// r_s = -e / (c + g)^2 and r_p = e (eta^2 c^2 - sin^2) / (eta^2 c + g)^2, so nothing cancels but at Brewster's angle.
inline double F_dielectric(double eta, double c) {
    const double e = (eta - 1.0) * (eta + 1.0), sin2 = (1.0 - c) * (1.0 + c);
    if (e == 0.0) return 0.0;
    if (!(c > 0.0) || !(eta < 1e153)) return 1.0;
    const double g2 = eta < 0.75 ? eta * eta - sin2 : e + c * c;
    if (!(g2 > 0.0)) return 1.0;
    const double g = std::sqrt(g2);
    const double A = e / sqr(c + g);
    const double P = eta * eta * c + g;
    const double B = (e / P) * ((eta * eta * c * c - sin2) / P);
    return std::min(1.0, 0.5 * (A * A + B * B));
}

/// |a + i b|. The library's hypot scales first, which costs four times as much and is only needed where squares leave the range.
inline double modulus(double a, double b) {
    const double square = a * a + b * b;
    return square > 1e-280 && square < 1e300 ? std::sqrt(square) : std::hypot(a, b);
}

/// The same for the complex index eta + i k; k = 0 is the dielectric.
inline double F_conductor(double eta, double k, double c) {
    if (k == 0.0) return F_dielectric(eta, c);
    if (!(c > 0.0) || !(eta < 1e153 && k < 1e153)) return 1.0;
    const double sin2 = (1.0 - c) * (1.0 + c), im = 2.0 * eta * k;
    const double e_re = (eta - 1.0) * (eta + 1.0) - k * k;
    const double g2_re = eta < 0.75 ? (eta - k) * (eta + k) - sin2 : e_re + c * c;
    // g = a + i b, the principal root of g^2.
    const double p = std::sqrt(0.5 * (modulus(g2_re, im) + std::fabs(g2_re)));
    const double q = p > 0.0 ? 0.5 * im / p : 0.0;
    const double a = g2_re >= 0.0 ? p : q, b = g2_re >= 0.0 ? q : p;
    const double e = modulus(e_re, im);
    const double A = e / (sqr(c + a) + b * b);
    const double eta2 = (eta - k) * (eta + k);
    const double N = modulus(eta2 * c * c - sin2, im * c * c);
    const double P = modulus(eta2 * c + a, im * c + b);
    const double B = (e / P) * (N / P);
    return std::min(1.0, 0.5 * (A * A + B * B));
}

/// Schlick 1994, "An inexpensive BRDF model for physically-based rendering".
inline double F_schlick(double f0, double c) {
    const double x = std::clamp(1.0 - c, 0.0, 1.0);
    const double x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

/// An interface by its index. schlick-f82 is Schlick less f82 c (1 - c)^6, which meets the exact value at c = 1/7, where metals dip.
inline Interface interface_of(double eta, double k = 0.0) {
    constexpr double c = 1.0 / 7.0, x = 1.0 - c, dip = c * (x * x * x) * (x * x * x);
    const double f0 = f0_from_ior(eta, k);
    return {eta, k, f0, (F_schlick(f0, c) - F_conductor(eta, k, c)) / dip};
}
/// An interface by its reflectance at normal incidence, 0 <= f0 < 1: the dielectric that has it.
inline Interface interface_of_f0(double f0) {
    const double root = std::sqrt(std::clamp(f0, 0.0, 1.0 - 0x1p-53));
    Interface result = interface_of((1.0 + root) / (1.0 - root));
    result.f0 = f0;
    return result;
}

inline double F(Fresnel kind, const Interface& x, double c) {
    switch (kind) {
        case Fresnel::one:
            return 1.0;
        case Fresnel::constant:
            return x.f0;
        case Fresnel::schlick:
            return F_schlick(x.f0, c);
        case Fresnel::schlick_linear:
            return x.f0 + (1.0 - x.f0) * std::clamp(1.0 - c, 0.0, 1.0);
        case Fresnel::schlick_f82: {
            const double y = std::clamp(1.0 - c, 0.0, 1.0), y3 = y * y * y;
            return std::clamp(F_schlick(x.f0, c) - x.f82 * c * (y3 * y3), 0.0, 1.0);
        }
        case Fresnel::dielectric:
            return F_dielectric(x.eta, c);
        case Fresnel::conductor:
            return F_conductor(x.eta, x.k, c);
    }
    return 0.0;
}

// ---- rd: diffuse reflection as a factor on the surface's colour. Gooch's replaces the colour and is in models.h.

enum class Diffuse { lambert, oren_nayar, gooch, none };

/// Oren, Nayar 1994 (the qualitative model), sigma in radians: A + B max(0, u) / max(n.l, n.v) with u = l.v - n.l n.v, which is their
/// max(0, cos dphi) sin a tan b without an angle.
struct OrenNayar {
    double A = 1.0, B = 0.0;
    OrenNayar() = default;
    explicit OrenNayar(double sigma) {
        const double s2 = sigma * sigma;
        A = 1.0 - 0.5 / (1.0 + 0.33 / s2);  // = 1 - s2 / 2 / (s2 + 0.33), for s2 of 0 and infinity, too
        B = 0.45 / (1.0 + 0.09 / s2);
    }
    double operator()(double n_dot_l, double n_dot_v, double l_dot_v) const {
        return A + B * std::max(0.0, l_dot_v - n_dot_l * n_dot_v) / std::max(n_dot_l, n_dot_v);
    }
};

}  // namespace rt
