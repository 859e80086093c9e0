#include "world/normal_node.h"

namespace rt {

namespace {

/// Kinds whose values this room computes turn normals by the slope of these values.
Vec3 turned_by_slope(const NormalNode& node, const Vec3& n0, const Vec3& q, const TexturePoint& seen) {
    const std::array<Vec3, 4> points = difference_points(node.bump, q);
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) values[i] = value_at(node.pattern, points[i], seen);
    return perturbed_by(node.bump, n0, values);
}

}  // namespace

Vec3 turned(const NormalNode& node, const Vec3& normal, const Vec3& p, const TexturePoint& seen) {
    const Pattern& pattern = node.pattern.pattern;
    const Vec3 q = enter(node.pattern, p, seen);
    const Vec3 n0 = into_pattern(pattern, node.bump, normal);
    Vec3 n1(0.0);
    if (!node.children.empty())
        for_each_entry(node.pattern, q, seen, [&](std::size_t i, double share) { n1 += share * turned(node.children[i], n0, q, seen); });
    else if (is_computed_elsewhere(pattern.kind))
        n1 = turned_by_slope(node, n0, q, seen);
    else
        n1 = perturbed(pattern, node.bump, n0, q, seen.surface);
    const Vec3 out = out_of_pattern(pattern, node.bump, n1);
    return is_finite(out) ? out : normal;
}

}  // namespace rt
