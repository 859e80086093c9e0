// What a difference between two records of a pixel usually means.
#pragma once

#include <string_view>

namespace rt {

enum class Cause {
    other,
    another_pixel,
    sampling,
    camera,
    mirrored,
    upside_down,
    half_pixel,
    missing_normalisation,
    missed_object,
    wrong_object,
    far_hit,
    object_space_distance,
    placement,
    wrong_normal_side,
    wrong_normal,
    offset,
    missing_filter,
    missing_fresnel,
    missing_reflection,
    total_reflection,
    depth,
    wrong_refraction_ratio,
    wrong_mirror_direction,
    missing_shadow,
    false_shadow,
    missing_light,
    missing_ambient,
    wrong_diffuse,
    missing_highlight,
    wrong_exponent,
    wrong_pigment,
    wrong_share,
    background,
    clamp,
    missing_part,
    gamma,
    rounding,
};

/// Two or three words, e.g. "wrong normal side".
std::string_view name_of(Cause cause);
/// One or two sentences: what is seen, and where in a program to look. "B" is the second record.
std::string_view meaning_of(Cause cause);

}  // namespace rt
