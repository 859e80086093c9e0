// Parts of a finish that vary over the surface by themselves: a thin film's colours, and grain.
#pragma once

#include <bit>
#include <cstdint>

#include "world/world.h"

namespace rt {

/// Factor of `irid` on light that arrives and leaves at these cosines, per channel.
inline Rgb film_factor(const Irid& film, const World& world, const Vec3& point, double cos_light, double cos_view) {
    double thickness = film.thickness;
    if (film.turbulence != 0.0) {
        const Turbulence turbulence{.amount = Vec3(0.0), .octaves = 5, .omega = 0.5F, .lambda = 2.0F};
        thickness *= 1.0 + film.turbulence * (2.0 * scalar_turbulence(world.noise, turbulence, point) - 1.0);
    }
    const double path = 2.0 * pi * thickness * (std::fabs(cos_light) + std::fabs(cos_view));
    const Rgb& wave = world.irid_wavelength;
    return Rgb(1.0) + film.amount * Rgb(std::cos(path / wave.r), std::cos(path / wave.g), std::cos(path / wave.b));
}

/// Chance at a point, 0..1, the same for any order of work.
inline double chance_at(const Vec3& point) {
    std::uint64_t bits = 0x243f6a8885a308d3u;
    for (int i = 0; i < 3; ++i) {
        bits = (bits ^ std::bit_cast<std::uint64_t>(point[i])) * 0x9e3779b97f4a7c15u;
        bits ^= bits >> 29;
    }
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace rt
