// Why a pixel hangs by the last bits: the first thing in which two records of its rays disagree.
#pragma once

#include <cstdint>
#include <optional>

#include "core/name_table.h"
#include "trace/ray_log.h"

namespace rt {

/// In the order of the first disagreement's search; "near" is within 1e-6 of the distance, "along" within a cosine of 1e-3.
enum class UnstableCause : std::uint8_t {
    silhouette,  ///< the camera's ray, or one of a neighbouring pixel, meets another object or another face of it
    coincident,  ///< two surfaces lie near each other, one along the other, and either is met or shadows the other
    grazing,     ///< the ray to the viewer, to a lamp or behind the surface leaves along it
    depth,       ///< a ray more or less: the tree ends by its depth, by the rays' weight, or branches otherwise
    shadow,      ///< a lamp is hidden by something, or not
    pattern,     ///< the pattern has another colour at the point
    secondary,   ///< a mirrored or transmitted ray meets something else
    other,
};
inline constexpr std::size_t unstable_causes = 8;
inline constexpr NameTable<UnstableCause, unstable_causes> unstable_cause_names{{{"silhouette", UnstableCause::silhouette},
                                                                                 {"near-coincident", UnstableCause::coincident},
                                                                                 {"grazing", UnstableCause::grazing},
                                                                                 {"depth", UnstableCause::depth},
                                                                                 {"shadow", UnstableCause::shadow},
                                                                                 {"pattern", UnstableCause::pattern},
                                                                                 {"secondary", UnstableCause::secondary},
                                                                                 {"other", UnstableCause::other}}};

/// The cause of the first disagreement between two records of one camera ray, in the order in which the rays were traced; nothing if they
/// met the same surfaces, colours and shadows. `world` is the first record's.
std::optional<UnstableCause> disagreement(const World& world, const RayLog& log, const RayLog& other);

/// What makes the light of these rays hang by its last bits although they meet the same: grazing or coincident, or nothing.
std::optional<UnstableCause> sensitivity(const World& world, const RayLog& log);

}  // namespace rt
