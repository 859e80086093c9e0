// normal {}: how a pattern turns a unit normal, in pattern space.
//
//     q = pattern_point(pattern, p)
//     n0 = into_pattern(pattern, n)              unit after each transform, or left as it comes with `no_bump_scale`
//     n1 = perturbed(pattern, bump, n0, q)       not unit
//     n = out_of_pattern(pattern, n1)            unit
#pragma once

#include <array>
#include <vector>

#include "patterns/pattern.h"

namespace rt {

/// One entry of a `slope_map`: the height and the slope (per distance to the next entry) at a value.
struct SlopeEntry {
    double value = 0.0;
    double height = 0.0;
    double slope = 0.0;
    bool operator==(const SlopeEntry&) const = default;
};

/// What `normal {}` says besides its pattern. POV-Ray keeps amount and accuracy in single precision: `float`.
struct Bump {
    float amount = 0.5F;
    float accuracy = 0.02F;          ///< distance of the finite differences, > 0
    bool scale = true;               ///< false: `no_bump_scale`
    std::vector<SlopeEntry> slopes;  ///< ascending; empty: the value itself is the height
    bool operator==(const Bump&) const = default;
};

/// Patterns that turn a normal by a rule of their own, not by their slope: bump_map bumps dents facets quilted ripples waves wrinkles. A
/// slope_map does nothing to them.
bool has_own_normal(PatternKind kind);

/// The height that a slope map gives to a value.
double slope_height(const std::vector<SlopeEntry>& slopes, double value);

/// The normal `n0` (pattern space) as turned at the pattern point `q`; not unit. Kinds computed elsewhere: see the next function.
Vec3 perturbed(const Pattern& pattern, const Bump& bump, const Vec3& n0, const Vec3& q, const PatternSurface& surface = {});

/// The four places around `q` at which `perturbed_by` wants the value (after frequency, phase and wave) of a pattern computed elsewhere.
std::array<Vec3, 4> difference_points(const Bump& bump, const Vec3& q);
/// `n0` turned by the slope that four such values show.
Vec3 perturbed_by(const Bump& bump, const Vec3& n0, const std::array<double, 4>& values);

/// A unit normal of the space around, in pattern space; and back, then unit. Only transforms turn normals, warps do not.
Vec3 into_pattern(const Pattern& pattern, const Bump& bump, const Vec3& normal);
Vec3 out_of_pattern(const Pattern& pattern, const Bump& bump, const Vec3& normal);

}  // namespace rt
