#include "world/material.h"

namespace rt {

namespace {

/// The patterns of textures around a layer, innermost first.
struct Enclosing {
    const PatternNode* pattern = nullptr;
    const Enclosing* around = nullptr;
};

const Bump plain;

Vec3 into(const Enclosing* enclosing, const Vec3& normal) {
    if (enclosing == nullptr) return normal;
    return into_pattern(enclosing->pattern->pattern, plain, into(enclosing->around, normal));
}

Vec3 out_of(const Enclosing* enclosing, const Vec3& normal) {
    if (enclosing == nullptr) return normal;
    return out_of(enclosing->around, out_of_pattern(enclosing->pattern->pattern, plain, normal));
}

void sample_layer(const LayerNode& layer, const TexturePoint& seen, const TextureQuestion& question, const Enclosing* enclosing,
                  SampledTexture& out) {
    LayerSample sampled{.color = {}, .finish = &layer.finish};
    if (!layer.normal || !question.normals) {
        sampled.color = color_at(layer.pigment, seen, question.quick_colors);
    } else {
        TexturePoint bumped = seen;
        sampled.bumped = true;
        sampled.normal = out_of(enclosing, turned(*layer.normal, into(enclosing, seen.surface.normal), seen.point, seen));
        bumped.surface.normal = sampled.normal;
        sampled.color = color_at(layer.pigment, bumped, question.quick_colors);
    }
    out.layers.push_back(sampled);
}

void sample_inside(const std::vector<LayerNode>& layers, const TexturePoint& seen, const TextureQuestion& question,
                   const Enclosing* enclosing, double weight, SampledTexture& out) {
    if (layers.size() == 1 && layers.front().textures) {
        const TextureNode& node = *layers.front().textures;
        TexturePoint there = seen;
        there.point = enter(node.pattern, seen.point, seen);
        const Enclosing inner{&node.pattern, enclosing};
        for_each_entry(node.pattern, there.point, seen,
                       [&](std::size_t i, double share) { sample_inside(node.entries[i], there, question, &inner, weight * share, out); });
        return;
    }
    for (const LayerNode& layer : layers) sample_layer(layer, seen, question, enclosing, out);
    if (enclosing != nullptr) out.shares.push_back({weight, out.layers.size()});
}

}  // namespace

void sample(const std::vector<LayerNode>& layers, const TexturePoint& seen, const TextureQuestion& question, SampledTexture& out) {
    sample_inside(layers, seen, question, nullptr, 1.0, out);
}

void sample_share(const std::vector<LayerNode>& layers, double weight, const TexturePoint& seen, const TextureQuestion& question,
                  SampledTexture& out) {
    const std::size_t before = out.shares.size();
    sample_inside(layers, seen, question, nullptr, weight, out);
    if (out.shares.size() == before) out.shares.push_back({weight, out.layers.size()});
}

LayerSample top_layer(const std::vector<LayerNode>& layers, const Vec3& point) {
    thread_local SampledTexture texture;
    texture.layers.clear();
    texture.shares.clear();
    TexturePoint seen;
    seen.point = point;
    sample(layers, seen, {.normals = false}, texture);
    return texture.layers.front();
}

}  // namespace rt
