// Light at a point by the course's rules (Cal Poly's CSC 473), as pure functions. Directions point away from the surface; vectors are unit.
#pragma once

#include <algorithm>

#include "shading/terms.h"

namespace rt::course {

/// Blinn 1977 with the exponent of a roughness: (n.h)^(2 / roughness^2 - 2), both clamped at 0. No factor n.l.
inline double blinn_phong(double n_dot_h, double roughness) {
    const double exponent = std::max(0.0, 2.0 / (roughness * roughness) - 2.0);
    return std::pow(std::clamp(n_dot_h, 0.0, 1.0), exponent);
}

/// One of the two factors of GGX's masking (Walter et al. 2007): 2 / (1 + sqrt(1 + alpha^2 tan^2)).
inline double masking_ggx(double cos, double alpha) {
    if (!(cos > 0.0)) return 0.0;
    return 2.0 * cos / (cos + smith_ggx_root(incline(cos), alpha));
}

/// Between l and v; the zero vector where they are opposite and nothing is.
inline Vec3 half_vector(const Vec3& l, const Vec3& v) {
    const Vec3 sum = l + v;
    return sum == Vec3(0.0) ? sum : unit(sum);
}

/// D G F / (4 max(1/16, |n.v|)) with GGX, alpha = roughness^2 and Schlick's F of v.h; the n.l that multiplies light is already in it.
inline double cook_torrance(const Vec3& n, const Vec3& l, const Vec3& v, double roughness, double ior) {
    constexpr double least_n_dot_v = 1.0 / 16.0;
    const Vec3 h = half_vector(l, v);
    const auto cosine = [](const Vec3& a, const Vec3& b) { return std::clamp(dot(a, b), 0.0, 1.0); };
    const double alpha = roughness * roughness, n_dot_h = cosine(n, h), n_dot_v = dot(n, v);
    const double D = rt::D(Distribution::ggx, n_dot_h * n_dot_h, (1.0 - n_dot_h) * (1.0 + n_dot_h), alpha);
    const double G = masking_ggx(cosine(n, l), alpha) * masking_ggx(std::clamp(n_dot_v, 0.0, 1.0), alpha);
    const double F = F_schlick(f0_from_ior(ior), cosine(v, h));
    return D * G * F / (4.0 * std::max(least_n_dot_v, std::fabs(n_dot_v)));
}

/// What a length `d` inside leaves of light, per channel: Beer's law, no colour where the pigment is 1.
inline Rgb beers_law(const Rgb& pigment, double d, double density) {
    const auto left = [&](double p) { return std::exp(-density * d * (1.0 - p)); };
    return {left(pigment.r), left(pigment.g), left(pigment.b)};
}

}  // namespace rt::course
