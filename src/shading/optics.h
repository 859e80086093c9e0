// Geometry and losses of mirror and refracted rays. Indices of refraction are ratios; lengths are in scene units.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace rt {

/// Mirror image of direction `d` about the unit normal `n`; keeps |d|.
inline Vec3 reflect(const Vec3& d, const Vec3& n) { return d - 2.0 * dot(d, n) * n; }

/// A ray behind an interface: refracted, or nothing when all light is reflected.
struct Refraction {
    bool total = false;    ///< total internal reflection: no direction
    bool straight = true;  ///< the indices are equal: `direction` is the incoming one, bit for bit
    Vec3 direction{0.0};
};

/// Snell's law. `d` unit, `n` unit and against d, `ratio` the index before the interface over the one behind it. Ratios within 1e-10 of 1
/// do not bend. A ratio that is not finite reflects totally.
inline Refraction refract(const Vec3& d, const Vec3& n, double ratio) {
    if (std::fabs(ratio - 1.0) < 1e-10) return {false, true, d};
    const double cos = -dot(d, n);
    const double k = 1.0 + ratio * ratio * (cos * cos - 1.0);
    if (!(k >= 0.0)) return {true, false, {}};
    return {false, false, ratio * d + (ratio * cos - std::sqrt(k)) * n};
}

/// Unpolarised reflectance of a dielectric (Fresnel 1823, in the form of Cook and Torrance 1982), 0..1. `eta` is the index behind the
/// interface over the one before it, `cos` the cosine of incidence. 1 for total reflection.
inline double fresnel_reflectance(double eta, double cos) {
    const double q = eta * eta + cos * cos - 1.0;
    if (!(q > 0.0)) return 1.0;
    if (std::isinf(q)) return 1.0;
    const double g = std::sqrt(q);
    const double a = (g - cos) / (g + cos);
    const double b = (cos * (g + cos) - 1.0) / (cos * (g - cos) + 1.0);
    return std::clamp(0.5 * a * a * (1.0 + b * b), 0.0, 1.0);
}

/// What is left of light after length `s` in a medium that fades by `power` over `distance`: towards `color`, or by the law of Beer and
/// Lambert for powers of 1000 and above. 1 where distance is 0.
inline Rgb distance_fade(double s, double distance, double power, const Rgb& color) {
    if (!(std::fabs(distance) > 1e-10)) return Rgb(1.0);
    if (power >= 1000.0) {
        const double depth = s / distance;
        return {std::exp(-(1.0 - color.r) * depth), std::exp(-(1.0 - color.g) * depth), std::exp(-(1.0 - color.b) * depth)};
    }
    const double left = 1.0 / (1.0 + std::pow(std::fabs(s / distance), power));
    return color + (Rgb(1.0) - color) * left;
}

}  // namespace rt
