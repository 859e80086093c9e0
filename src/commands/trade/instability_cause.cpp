#include "commands/trade/instability_cause.h"

#include <algorithm>

namespace rt {

namespace {

constexpr double near_distance = 1e-6;     ///< between two surfaces, over that from the ray's origin
constexpr double along_cosine = 1e-3;      ///< of a ray that leaves along the surface
constexpr double parallel_cosine = 0.999;  /// of the normals of surfaces that lie one along the other, or are one

bool ends_early(const RayNode& node) { return node.end == RayNode::End::level || node.end == RayNode::End::weight; }

bool parallel(const Vec3& a, const Vec3& b) { return std::fabs(dot(a, b)) > parallel_cosine; }

/// Whether something else than its own object lies along the surface at the record's point, as seen in this direction.
bool other_surface_near(const World& world, const RayNode& node, const Vec3& direction) {
    const double cosine = std::fmax(std::fabs(dot(node.normal, direction)), along_cosine);
    const double reach = near_distance * node.t / cosine;
    const Ray ray{node.point - reach * direction, direction};
    constexpr int most_surfaces = 16;
    Interval range{0.0, 2.0 * reach};
    Hit hit;
    for (int i = 0; i < most_surfaces && world.nearest(ray, range, RayKind::shadow, hit); ++i) {
        if (hit.object != node.object && parallel(node.normal, world.normal(hit, ray.at(hit.shape.t)))) return true;
        range.min = hit.shape.t;
    }
    return false;
}

bool seen_along(const RayNode& node) { return std::fabs(dot(node.normal, node.ray.direction)) < along_cosine; }

/// The zero vector for a lamp at the point.
Vec3 towards_lamp(const World& world, const RayNode& node, std::uint32_t light) {
    const Vec3 way = world.lights[light].location - node.point;
    const double distance = length(way);
    return distance > 0.0 ? way / distance : Vec3(0.0);
}

UnstableCause cause_of_shadow(const World& world, const RayNode& node, std::uint32_t light) {
    const Vec3 to_lamp = towards_lamp(world, node, light);
    if (other_surface_near(world, node, to_lamp)) return UnstableCause::coincident;
    return std::fabs(dot(node.normal, to_lamp)) < along_cosine ? UnstableCause::grazing : UnstableCause::shadow;
}

bool same(const ShadowAnswer& a, const ShadowAnswer& b) {
    const auto dark = [](const ShadowAnswer& answer) { return answer.transmitted == Rgb(0.0); };
    return a.light == b.light && a.sample == b.sample && dark(a) == dark(b) && a.crossed == b.crossed;
}

/// One answer more or less comes from a lamp on the horizon.
std::optional<UnstableCause> disagreement_of_shadows(const World& world, const RayNode& a, const RayNode& b) {
    for (std::size_t i = 0; i < std::min(a.shadows.size(), b.shadows.size()); ++i)
        if (!same(a.shadows[i], b.shadows[i])) return cause_of_shadow(world, a, a.shadows[i].light);
    if (a.shadows.size() != b.shadows.size()) return UnstableCause::grazing;
    return std::nullopt;
}

/// Both met a surface.
std::optional<UnstableCause> disagreement_of_surfaces(const World& world, const RayNode& a, const RayNode& b) {
    const bool same_face = a.object == b.object && a.part == b.part && parallel(a.normal, b.normal);
    const bool near = std::fabs(a.t - b.t) <= near_distance * std::max(a.t, b.t);
    if (!same_face) {
        if (a.object != b.object && near && parallel(a.normal, b.normal)) return UnstableCause::coincident;
        return a.kind == RayNode::Kind::camera ? UnstableCause::silhouette : UnstableCause::secondary;
    }
    if (!near || a.inside != b.inside) return seen_along(a) ? UnstableCause::grazing : UnstableCause::secondary;
    if (a.layers != b.layers) return UnstableCause::pattern;
    return disagreement_of_shadows(world, a, b);
}

std::optional<UnstableCause> disagreement_of_rays(const World& world, const RayNode& a, const RayNode& b) {
    if (a.parent != b.parent || a.kind != b.kind) {
        // Beyond the critical angle or not: the bent ray would leave along the surface.
        const bool critical = a.parent == b.parent && (a.kind == RayNode::Kind::total) != (b.kind == RayNode::Kind::total);
        return critical ? UnstableCause::grazing : UnstableCause::depth;
    }
    if (a.end != b.end) {
        if (ends_early(a) || ends_early(b)) return UnstableCause::depth;
        return a.kind == RayNode::Kind::camera ? UnstableCause::silhouette : UnstableCause::secondary;
    }
    return a.end == RayNode::End::surface ? disagreement_of_surfaces(world, a, b) : std::nullopt;
}

}  // namespace

std::optional<UnstableCause> disagreement(const World& world, const RayLog& log, const RayLog& other) {
    const std::size_t both = std::min(log.nodes.size(), other.nodes.size());
    for (std::size_t i = 0; i < both; ++i)
        if (const auto cause = disagreement_of_rays(world, log.nodes[i], other.nodes[i])) return cause;
    if (log.nodes.size() != other.nodes.size()) return UnstableCause::depth;
    return std::nullopt;
}

std::optional<UnstableCause> sensitivity(const World& world, const RayLog& log) {
    for (const RayNode& node : log.nodes) {
        if (node.end != RayNode::End::surface) continue;
        if (other_surface_near(world, node, node.ray.direction)) return UnstableCause::coincident;
        if (seen_along(node)) return UnstableCause::grazing;
        for (const ShadowAnswer& answer : node.shadows)
            if (std::fabs(dot(node.normal, towards_lamp(world, node, answer.light))) < along_cosine) return UnstableCause::grazing;
    }
    return std::nullopt;
}

}  // namespace rt
