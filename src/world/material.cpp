#include "world/material.h"

#include "patterns/checker.h"

namespace rt {

namespace {

PigmentColor color_at(const std::vector<PigmentNode>& tree, Vec3 p, bool quick) {
    const PigmentNode* node = &tree[0];
    while (node->checker && !(quick && node->quick)) {
        p = node->to_pattern.point(p);
        node = &tree[node->child[checker(p)]];
    }
    return quick && node->quick ? *node->quick : node->color;
}

}  // namespace

void sample_layers(const std::vector<LayerNode>& layers, const Vec3& p, std::vector<LayerSample>& out, bool quick) {
    for (const LayerNode& layer : layers) {
        if (layer.checker) {
            const Vec3 inside = layer.to_pattern.point(p);
            sample_layers(layer.cell[checker(inside)], inside, out, quick);
        } else {
            out.push_back({color_at(layer.pigment, p, quick), &layer.finish});
        }
    }
}

}  // namespace rt
