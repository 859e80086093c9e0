// How a lamp's light thins out: with distance, and across a spot's cone. Distances in scene units.
#pragma once

#include "shading/half_geometry.h"

namespace rt {

enum class Attenuation { none, one_d_d2, polynomial, inverse_square };

/// The law and its numbers. Nothing is lit beyond `range`; at the range itself it is.
struct AttenuationLaw {
    Attenuation kind = Attenuation::none;
    double constant = 1.0, linear = 1.0, quadratic = 1.0;  ///< polynomial: 1 / (constant + linear d + quadratic d^2)
    double least_distance = 1e-3;                          ///< inverse_square: 1 / max(d, least_distance)^2
    double range = infinite;

    static constexpr double infinite = 1e300;
};

/// No law lets a lamp shine brighter than this times its colour, however near it is.
inline constexpr double brightest = 1e200;

/// Factor on the light of a lamp at that distance. Finite: a lamp at the very point has no direction and lights nothing, but not by 0 times
/// infinity.
inline double attenuation(const AttenuationLaw& law, double distance) {
    if (!(distance <= law.range)) return 0.0;
    switch (law.kind) {
        case Attenuation::none:
            return 1.0;
        case Attenuation::one_d_d2:
            return 1.0 / (1.0 + distance + distance * distance);
        case Attenuation::polynomial:
            return std::min(1.0 / (law.constant + distance * (law.linear + distance * law.quadratic)), brightest);
        case Attenuation::inverse_square:
            return 1.0 / sqr(std::max(distance, law.least_distance));
    }
    return 0.0;
}

/// What all lamps of a picture obey beside their own description.
struct LampRules {
    AttenuationLaw law;
    bool exponent_spots = false;  ///< a spotlight's beam is spot() with its tightness as the exponent, without a cone's edge
    bool clamp_after = false;     ///< that beam is spot_clamped_after()
};

/// max(-l.a, 0)^q across the beam of a spot that shines along `axis` (any length); l points to the lamp. 0 behind it, also for q = 0.
inline double spot(const Vec3& axis, const Vec3& l, double exponent) {
    const Vec3 sine = accurate_cross(axis, l);
    return cosine_power(-dot(axis, l), dot(sine, sine), exponent);
}

/// max((-l.a)^q, 0) as a text prints it: an even exponent, 0 included, lights what is behind the lamp, and where there is no power there is
/// no light. Both unit.
inline double spot_clamped_after(const Vec3& axis, const Vec3& l, double exponent) { return power_clamped_after(-dot(axis, l), exponent); }

}  // namespace rt
