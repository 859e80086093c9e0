// The light of rays that were traced once, as it would be if a rule of shading were another: the same paths, other sums.
#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "trace/course_rules.h"
#include "trace/ray_log.h"

namespace rt {

/// How the course's rules are broken; as it stands, not at all. Factors multiply the terms wherever they occur in the tree.
struct Reshading {
    double ambient = 1.0, diffuse = 1.0, specular = 1.0, reflection = 1.0, refraction = 1.0;
    int deepest = 1'000'000;  ///< rays after the camera's

    enum class Shadows : std::uint8_t { as_found, none, everywhere } shadows = Shadows::as_found;
    enum class Lamps : std::uint8_t { all, first, white, faded } lamps = Lamps::all;  ///< faded: by the square of the distance
    enum class Cosine : std::uint8_t { clamped, negative_too, absolute, none, times_distance } cosine = Cosine::clamped;
    enum class Lobe : std::uint8_t {
        by_rules,
        other_model,
        phong,
        half_not_unit,
        roughness_not_squared,
        times_n_dot_l
    } lobe = Lobe::by_rules;
    double exponent_scale = 1.0;  ///< of Blinn-Phong; of Cook-Torrance's alpha its inverse root
    enum class Normal : std::uint8_t { right, to_viewer, triangles_turned, by_matrix, in_object_space, not_unit } normal = Normal::right;

    bool ambient_for_each_lamp = false;
    bool without_pigment = false;  ///< in the surface's own light
    bool untinted_mirrors = false, unfiltered = false;
    bool local_unscaled = false;  ///< a surface's own light is not weakened by what it mirrors and lets through
    bool total_reflection_lost = false;
    std::uint32_t hidden_lamps = 0;  ///< bits: lamps that do not reach what the camera sees
    std::uint32_t shown_lamps = 0;   ///< bits: lamps that do, whatever is between
};

/// A scene whose rays were traced by the course's rules, shaded, without indirect light. All outlive it.
struct ShadedScene {
    const Scene& scene;
    const World& world;
    const CourseRules& rules;
};

/// The camera ray's light. With a default `how` it is what the tracer found.
Rgb reshaded(const ShadedScene& shaded, const RayLog& log, const Reshading& how);

}  // namespace rt
