// Patterns and pigments, compiled: what the scene leaves to its settings is filled in, and what refers to others holds them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "patterns/map.h"
#include "scene/object_probe.h"

namespace rt {

/// A point of a surface as textures see it.
struct TexturePoint {
    Vec3 point{0.0};
    PatternSurface surface;
    Vec2 uv{0.0};
};

struct PigmentNode;
/// A colour tree; the root is element 0. Children of one node stand one after the other.
using PigmentTree = std::vector<PigmentNode>;

/// A pattern with all that its value needs, and where its entries stand: their values, ascending (of cells 0, 1, 2 ...), or their weights
/// for `average`.
struct PatternNode {
    Pattern pattern;
    bool uv_mapping = false;
    std::shared_ptr<const Function> function;
    PigmentTree grey;  ///< of pigment_pattern
    std::shared_ptr<const ObjectProbe> bodies;
    std::vector<double> values;
};

/// The point that the pattern's kind and its entries see; `p` stands for the surface's point in the space around it.
Vec3 enter(const PatternNode& node, const Vec3& p, const TexturePoint& seen);
/// The value after frequency, phase and wave at a point that was entered.
double value_at(const PatternNode& node, const Vec3& q, const TexturePoint& seen);

/// Calls `visit(i, share)` for the entries that are seen at an entered point; the shares' sum is 1.
template <typename Visit>
void for_each_entry(const PatternNode& node, const Vec3& q, const TexturePoint& seen, const Visit& visit) {
    if (node.pattern.kind == PatternKind::average) {
        double sum = 0.0;
        for (const double weight : node.values) sum += weight;
        for (std::size_t i = 0; i < node.values.size(); ++i)
            if (node.values[i] != 0.0) visit(i, node.values[i] / sum);
    } else {
        const MapPlace place = find_in_map(node.values, value_at(node, q, seen));
        if (place.weight < 1.0) visit(place.lower, 1.0 - place.weight);
        if (place.weight > 0.0) visit(place.upper, place.weight);
    }
}

/// What a node shows besides children.
struct PigmentSurface {
    PatternNode pattern;
    std::optional<Shared<ColorMap>> colors;
    std::optional<ImageMap> image;
};

/// A colour, or a pattern over colours, a picture or children.
struct PigmentNode {
    PigmentColor color;                             ///< where there is no pattern
    std::shared_ptr<const PigmentSurface> surface;  ///< where there is one
    std::uint32_t first_child = 0;
    std::optional<PigmentColor> quick;  ///< stands for the whole tree below where quick colours are asked for
};

/// The colour at a point; with `quick` in quick colours, where stated.
PigmentColor color_at(const PigmentTree& tree, const TexturePoint& seen, bool quick);

}  // namespace rt
