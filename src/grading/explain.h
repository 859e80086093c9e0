// Two records of one pixel, field by field, to the first that differs.
#pragma once

#include "grading/causes.h"
#include "grading/told_pixel.h"

namespace rt {

/// Where two records part.
struct Divergence {
    Cause cause = Cause::other;
    std::size_t sample = 0;                                    ///< of the pixel
    std::size_t ray_a = ToldRay::none, ray_b = ToldRay::none;  ///< in that sample; none: the pixel itself
    std::string field;                                         ///< in words, e.g. "normal"
    std::string value_a, value_b;
};

/// The first field of `b` that is not the same as in `a`, which is taken to be right; empty if there is none. A ray's own fields come first
/// (where it begins and goes, what it meets, what light the surface has of its own), then the rays that it causes, each with all of its
/// own, then what is summed from them; at the end the colour of the pixel. What one of the records leaves out is not compared. Numbers are
/// the same within `tolerance`, relative above 1 and absolute below.
std::optional<Divergence> first_divergence(const ToldPixel& a, const ToldPixel& b, double tolerance);

}  // namespace rt
