#include "trace/surface_layers.h"

namespace rt {

SurfaceLayers::Side SurfaceLayers::side(const Material& material, bool inside) const {
    const bool two_faced = inside && !material.interior_layers.empty();
    const std::vector<LayerNode>& layers = two_faced ? material.interior_layers : material.layers;
    Side side;
    side.uses_uv = material.uses_uv;
    if (!two_faced) side.shape_textures = material.shape_textures;
    if (!side.shape_textures.empty()) side.varying = &layers;
    for (const LayerNode& layer : layers)
        if (layer.textures || (layer.normal && question_.normals) || layer.pigment.front().surface) side.varying = &layers;
    if (side.varying == nullptr) sample(layers, {}, question_, side.constant);
    return side;
}

SurfaceLayers::SurfaceLayers(const World& world, const TextureQuestion& question)
    : world_(world), question_(question), outside_(world.materials.size()), inside_(world.materials.size()) {
    std::vector<bool> met(world.materials.size());
    for (const CompiledObject& object : world.objects) met[object.material] = true;
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (!met[i]) continue;  // one of a shape's textures
        outside_[i] = side(world.materials[i], false);
        inside_[i] = side(world.materials[i], true);
    }
}

const SampledTexture& SurfaceLayers::at(const CompiledObject& object, bool inside, const SeenSurface& seen) {
    const Side& side = inside ? inside_[object.material] : outside_[object.material];
    if (side.varying == nullptr) return side.constant;
    TexturePoint point{seen.point, {seen.normal, seen.direction}, Vec2(0.0)};
    if (side.uses_uv) point.uv = world_.uv(seen.hit, seen.point);
    scratch_.layers.clear();
    scratch_.shares.clear();
    if (!side.shape_textures.empty()) return blend(side, point, seen);
    sample(*side.varying, point, question_, scratch_);
    return scratch_;
}

/// The textures of the shape's parts that show at the point, each with its weight.
[[gnu::noinline]] const SampledTexture& SurfaceLayers::blend(const Side& side, const TexturePoint& point, const SeenSurface& seen) {
    weights_.clear();
    world_.texture_weights(seen.hit, seen.point, question_.least_weight, weights_);
    const auto layers = [&](const TextureWeight& shown) -> const std::vector<LayerNode>& {
        const bool of_object = shown.texture == TextureWeight::of_object;
        return world_.materials[of_object ? side.shape_textures.back() : side.shape_textures[shown.texture]].layers;
    };
    if (weights_.size() == 1 && weights_.front().weight == 1.0) {
        sample(layers(weights_.front()), point, question_, scratch_);
        return scratch_;
    }
    for (const TextureWeight& shown : weights_) sample_share(layers(shown), shown.weight, point, question_, scratch_);
    if (weights_.empty()) scratch_.shares.push_back({0.0, 0});  // nothing has weight enough: black
    return scratch_;
}

}  // namespace rt
