// The terms of POV-Ray's finish as pure functions of cosines and coefficients. No coefficient is clamped: values above 1 and below 0 mean
// what the formulas say.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace rt {

/// Cosines from here on count as facing the light.
inline constexpr double facing_cosine = 1e-10;

/// Share of a layer's ambient and diffuse light that its pigment leaves: 1 - filter - transmit, may be negative.
/// `legacy`: the rule before language version 3.7, in which the filter counts by the brightest channel.
inline double opacity(const Rgb& color, double filter, double transmit, bool legacy) {
    return legacy ? 1.0 - (filter * max_component(color) + transmit) : 1.0 - filter - transmit;
}

/// Lambert's cosine with `brilliance` as its exponent; `n_dot_l` > 0.
inline double diffuse_cosine(double n_dot_l, double brilliance) { return brilliance == 1.0 ? n_dot_l : std::pow(n_dot_l, brilliance); }

/// Phong 1975: cosine between the mirrored view direction and the light, to the power `size`. Large exponents cut the faint tail.
inline double phong_lobe(double r_dot_l, double size) {
    if (!(r_dot_l > 0.0) || (size >= 60.0 && r_dot_l <= 0.0008)) return 0.0;
    return std::pow(std::min(r_dot_l, 1.0), size);
}

/// Blinn 1977: cosine between normal and half vector to the power `exponent` = 1 / roughness.
inline double specular_lobe(double n_dot_h, double exponent) { return n_dot_h > 0.0 ? std::pow(std::min(n_dot_h, 1.0), exponent) : 0.0; }

/// How much a `metallic` highlight or reflection has lost of its tint at this cosine of incidence: 0 from above, 1 at grazing.
inline double metallic_fresnel(double cos) {
    const double x = std::acos(std::clamp(cos, -1.0, 1.0)) / (0.5 * pi);
    return std::clamp(0.014567225 / sqr(x - 1.12) - 0.011612903, 0.0, 1.0);
}

/// Factor on a highlight or reflection of a finish with `metallic` m over pigment `color`.
inline Rgb metallic_tint(const Rgb& color, double m, double cos) {
    return Rgb(1.0) + m * (1.0 - metallic_fresnel(cos)) * (color - Rgb(1.0));
}

/// Reflectivity between its values at normal and at grazing incidence: linear in (1 - cos)^falloff, and beyond that of grazing where a
/// bumped normal looks away and the cosine is negative.
inline Rgb angular_reflectivity(const Rgb& min, const Rgb& max, double falloff, double cos) {
    const double x = std::fmax(1.0 - cos, 0.0);
    const double k = falloff == 1.0 ? x : std::pow(x, falloff);
    return k * max + (1.0 - k) * min;
}

/// Light along a mirrored ray as `reflection { exponent x }` takes it: to the power 1 / x per channel. Negative light that has no such
/// power becomes 0.
inline Rgb reflected_light(const Rgb& light, double exponent) {
    if (exponent == 1.0) return light;
    const auto root = [&](double x) {
        const double y = std::pow(x, 1.0 / exponent);
        return std::isnan(y) ? 0.0 : y;
    };
    return {root(light.r), root(light.g), root(light.b)};
}

/// The cubic that joins 0 at `low` to 1 at `high`.
inline double cubic_step(double low, double high, double x) {
    if (x < low) return 0.0;
    if (x >= high) return 1.0;
    const double q = (x - low) / (high - low);
    return q * q * (3.0 - 2.0 * q);
}

}  // namespace rt
