// Patterns made of noise and of hashed numbers: values before frequency, phase and wave. `p` is in pattern space.
#pragma once

#include "core/vec.h"
#include "patterns/pattern.h"

namespace rt {

/// sin(2 pi v), computed from v's fraction.
double cycle(double v);

double dents(NoiseGenerator generator, const Vec3& p);
double wrinkles(NoiseGenerator generator, const Vec3& p);
double granite(NoiseGenerator generator, const Vec3& p);
double agate(const Pattern& pattern, const Vec3& p);
/// Here turbulence is part of the pattern and does not move the point; the same holds for wood.
double marble(const Pattern& pattern, const Vec3& p);
double wood(const Pattern& pattern, const Vec3& p);
double cells(const Vec3& p);
double ripples(const Pattern& pattern, const Vec3& p);
double waves(const Pattern& pattern, const Vec3& p);
double crackle(const CrackleNumbers& numbers, NoiseGenerator generator, const Vec3& p);

/// The feature points of crackle and facets that are nearest to a point, by the sum of |difference|^metric per axis.
struct NearestFeatures {
    double distance[3];  ///< the three smallest sums, ascending
    Vec3 nearest;
};
NearestFeatures nearest_features(const Vec3& p, double metric);

}  // namespace rt
