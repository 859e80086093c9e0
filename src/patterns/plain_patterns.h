// Patterns that are a formula of the point alone: values before frequency, phase and wave. `p` is in pattern space.
#pragma once

#include "core/vec.h"
#include "patterns/pattern.h"

namespace rt {

/// 0 at whole numbers, 1 halfway between them.
double triangle_wave(double v);

double boxed(const Vec3& p);
double cylindrical(const Vec3& p);
double spherical(const Vec3& p);
double planar(const Vec3& p);
double gradient(const GradientNumbers& numbers, const Vec3& p);
double leopard(const Vec3& p);
double onion(const Vec3& p);
double radial(const Vec3& p);
double quilted(const QuiltedNumbers& numbers, const Vec3& p);
double spiral1(const SpiralNumbers& numbers, const Vec3& p);
double spiral2(const SpiralNumbers& numbers, const Vec3& p);
double slope(const SlopeNumbers& numbers, const Vec3& p, const PatternSurface& surface);
/// The angle of incidence, acos(N . d) / pi: 1 head-on, 0.5 at grazing.
double angle_of_incidence(const PatternSurface& surface);

/// The shape of one quilt's pillow at distance `t` from its middle, 0..sqrt(3)/2.
double quilt_profile(const QuiltedNumbers& numbers, double t);

}  // namespace rt
