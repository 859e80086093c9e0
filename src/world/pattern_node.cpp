#include "world/pattern_node.h"

namespace rt {

namespace {

/// Steps of a function at one point, sums and products included.
constexpr std::uint64_t most_steps = 10'000'000;

PigmentColor mixed(const PigmentColor& a, const PigmentColor& b, double share) {
    return {a.rgb + share * (b.rgb - a.rgb), a.filter + share * (b.filter - a.filter), a.transmit + share * (b.transmit - a.transmit)};
}

void add(PigmentColor& sum, const PigmentColor& color, double share) {
    sum.rgb += share * color.rgb;
    sum.filter += share * color.filter;
    sum.transmit += share * color.transmit;
}

PigmentColor image_color(const ImageMap& map, const Vec3& q) {
    const ColorImage& image = *map.image;
    const std::optional<Vec2> place = image_place(map.mapping, image.width, image.height, q);
    if (!place) return {Rgb(1.0), 0.0, 1.0};  // beside the picture
    PigmentColor color{Rgb(0.0), map.filter, map.transmit};
    for (const auto& tap : image_taps(map.mapping, image.width, image.height, *place)) {
        const auto& texel =
            image.texels[static_cast<std::size_t>(tap.y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(tap.x)];
        color.rgb += tap.weight * Rgb(texel[0], texel[1], texel[2]);
        color.transmit += tap.weight * static_cast<double>(texel[3]);
    }
    if (map.mapping.interpolate == 3) color.rgb = glm::max(color.rgb, Rgb(0.0));  // cubics undershoot
    return color;
}

double function_value(const Function& function, const Vec3& q) {
    const std::array<double, 3> arguments{q.x, q.y, q.z};
    std::uint64_t steps = most_steps;
    const double value = evaluate(function, arguments, steps).value_or(0.0);
    return std::isfinite(value) ? value : 0.0;
}

PigmentColor color_of_node(const PigmentTree& tree, const PigmentNode& node, const Vec3& p, const TexturePoint& seen, bool quick) {
    if (quick && node.quick) return *node.quick;
    if (!node.surface) return node.color;
    const PigmentSurface& surface = *node.surface;
    const PatternNode& pattern = surface.pattern;
    const Vec3 q = enter(pattern, p, seen);
    if (surface.image) return image_color(*surface.image, q);
    const std::size_t children = node.first_child;
    if (surface.colors) {
        const std::vector<PigmentColor>& colors = (*surface.colors)->colors;
        const MapPlace place = find_in_map((*surface.colors)->values, value_at(pattern, q, seen));
        return mixed(colors[place.lower], colors[place.upper], place.weight);
    }
    PigmentColor sum;
    for_each_entry(pattern, q, seen,
                   [&](std::size_t i, double share) { add(sum, color_of_node(tree, tree[children + i], q, seen, quick), share); });
    return sum;
}

}  // namespace

Vec3 enter(const PatternNode& node, const Vec3& p, const TexturePoint& seen) {
    return pattern_point(node.pattern, node.uv_mapping ? Vec3(seen.uv.x, seen.uv.y, 0.0) : p);
}

namespace {

double raw_value_at(const PatternNode& node, const Vec3& q, const TexturePoint& seen) {
    if (node.function) return function_value(*node.function, q);
    if (node.bodies) return node.bodies->contains(q) ? 1.0 : 0.0;
    if (!node.grey.empty()) {
        TexturePoint there = seen;
        there.point = q;
        return grey(color_at(node.grey, there, false).rgb);
    }
    return raw_value(node.pattern, q, seen.surface);
}

}  // namespace

double value_at(const PatternNode& node, const Vec3& q, const TexturePoint& seen) {
    return wave_value(node.pattern, raw_value_at(node, q, seen));
}

PigmentColor color_at(const PigmentTree& tree, const TexturePoint& seen, bool quick) {
    return color_of_node(tree, tree[0], seen.point, seen, quick);
}

}  // namespace rt
