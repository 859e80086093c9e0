// Gradient noise on a lattice, in three variants, and what is made of it.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/vec.h"

namespace rt {

struct Turbulence;

inline double clamp01(double x) { return std::fmin(1.0, std::fmax(0.0, x)); }

/// `noise_generator`.
enum class NoiseGenerator : std::uint8_t { original = 1, range_corrected = 2, perlin = 3 };

/// Scalar noise, 0..1.
double noise(NoiseGenerator generator, const Vec3& p);
/// Vector noise, about -1..1 in each component; one variant.
Vec3 vector_noise(const Vec3& p);
/// sum over the octaves of omega^i vector_noise(lambda^i p).
Vec3 vector_turbulence(const Turbulence& turbulence, const Vec3& p);
/// The scalar counterpart, which agate, marble and turbulent fog use.
double scalar_turbulence(NoiseGenerator generator, const Turbulence& turbulence, const Vec3& p);

}  // namespace rt
