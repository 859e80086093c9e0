// LDR-FLIP: the difference a person sees when two pictures alternate on a screen.
// P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astroem, M. Fairchild: "FLIP: A Difference Evaluator for Alternating
// Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
#pragma once

#include <array>
#include <vector>

#include "grading/separable.h"

namespace rt {

/// Red, green and blue as linear light in 0..1 (sRGB primaries).
using LinearPlanes = std::array<Plane, 3>;

/// The paper's screen: 3840 pixels on 0.7 m, seen from 0.7 m, give 67 pixels a degree.
inline constexpr double flip_pixels_per_degree = 3840.0 * 3.14159265358979323846 / 180.0;

/// The error of every pixel, 0 (same) to 1. Both pictures must have the same, non-zero size.
Plane flip(const LinearPlanes& reference, const LinearPlanes& test);

/// What the authors' program prints of an error map. Percentiles weight each pixel with its own error. Sums run in single precision and
/// row by row, as theirs do, so that figures can be compared; over a large picture that costs up to 1e-3 of the mean, which
/// `mean_exact` has without it.
struct FlipSummary {
    double mean = 0.0, mean_exact = 0.0, median = 0.0, q1 = 0.0, q3 = 0.0, min = 0.0, max = 0.0;
};
FlipSummary summarise(const Plane& error);

}  // namespace rt
