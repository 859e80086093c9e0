// The angles that shading needs of a normal, a direction to the light and one to the viewer, without the cancellations of the usual forms.
// n, l and v are unit vectors and all point away from the surface.
#pragma once

#include <algorithm>

#include "core/products.h"

namespace rt {

/// What a term needs to know of one direction x: its cosine to the normal and the square of its sine.
struct Incline {
    double cos = 0.0;
    double sin2 = 0.0;
};

inline Incline incline(const Vec3& n, const Vec3& x) {
    const Vec3 sine = accurate_cross(n, x);
    return {accurate_dot(n, x), dot(sine, sine)};
}

/// The same from a cosine alone, 0..1, taken as exact.
inline Incline incline(double cos) { return {cos, (1.0 - cos) * (1.0 + cos)}; }

/// The pair of directions l and v as the microfacet terms see it; h is their half vector, s = l + v.
struct HalfGeometry {
    Incline l, v;
    double cos2_h = 1.0;   ///< square of n.h; with sin2_h it sums to 1
    double sin2_h = 0.0;   ///< from a cross product, never as 1 - cos2_h
    double v_dot_h = 1.0;  ///< = l.h = |s| / 2
    double n_dot_s = 2.0;  ///< = n.l + n.v
    double s_dot_s = 4.0;
};

/// Below this cosine a direction counts as below the surface: |l + v|^2 and the product of the cosines stay normal numbers.
inline constexpr double least_cosine = 1e-150;

/// False if either direction is at or below the surface or not a number: then nothing is reflected. l = -v cannot pass, so no epsilon
/// guards it. `incline_v` holds n.v of the same n. Cook, Torrance 1982 call the angles delta, beta and theta; the sine of the half angle
/// comes from n x s and v.h from |s|, because 1 - (n.h)^2 and a normalised h lose the digits near the highlight. n.s is the sum of two
/// accurate positive cosines: for nearly opposite l and v nothing else would keep the digits of n.h.
inline bool half_geometry(const Vec3& n, const Vec3& l, const Vec3& v, const Incline& incline_v, HalfGeometry& g) {
    const double n_dot_l = accurate_dot(n, l);
    if (!(n_dot_l > least_cosine && incline_v.cos > least_cosine)) return false;
    const Vec3 s = l + v;
    g.n_dot_s = n_dot_l + incline_v.cos;
    const Vec3 x = accurate_cross(n, s);
    const double xx = dot(x, x);
    const double q = g.n_dot_s * g.n_dot_s + xx;  // |n|^2 |s|^2: renormalises
    g.l = incline(n, l);
    g.v = incline_v;
    g.cos2_h = g.n_dot_s * g.n_dot_s / q;
    g.sin2_h = xx / q;
    g.s_dot_s = dot(s, s);
    g.v_dot_h = std::min(1.0, 0.5 * std::sqrt(g.s_dot_s));
    return true;
}

/// The geometry of a text that calls h the half vector of n and v: then h does not follow the light, n.h = v.h = cos(angle(n, v) / 2).
inline void halve_normal_and_view(const Vec3& n, const Vec3& v, HalfGeometry& g) {
    const Vec3 s = n + v;
    g.n_dot_s = dot(n, n) + g.v.cos;
    g.s_dot_s = dot(s, s);
    const double q = g.n_dot_s * g.n_dot_s + g.v.sin2;
    g.cos2_h = g.n_dot_s * g.n_dot_s / q;
    g.sin2_h = g.v.sin2 / q;
    g.v_dot_h = std::min(1.0, 0.5 * std::sqrt(g.s_dot_s));
}

/// Exponents end here, so that none is infinite and times a logarithm of 0 no number.
inline constexpr double largest_exponent = 1e300;

/// cos^exponent of an angle given by its cosine and the square of its sine, of vectors of any length: 0 for cosines that are not positive,
/// whatever the exponent. The logarithm comes from the tangent, so that large exponents do not amplify the rounding of the cosine.
inline double cosine_power(double cos, double sin2, double exponent) {
    if (!(cos > 0.0)) return 0.0;
    return std::exp(-0.5 * exponent * std::log1p(sin2 / (cos * cos)));
}

/// max(cos^exponent, 0), which texts print where they mean the power of max(cos, 0): even exponents light the back, and fractional ones
/// have no power of a negative cosine and so no light.
inline double power_clamped_after(double cos, double exponent) {
    const double power = std::pow(std::min(1.0, cos), exponent);
    return power > 0.0 ? power : 0.0;
}

}  // namespace rt
