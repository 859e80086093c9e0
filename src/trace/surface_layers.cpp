#include "trace/surface_layers.h"

namespace rt {

SurfaceLayers::Side SurfaceLayers::side(const std::vector<LayerNode>& layers, bool uses_uv) const {
    Side side;
    side.uses_uv = uses_uv;
    for (const LayerNode& layer : layers)
        if (layer.textures || (layer.normal && question_.normals) || layer.pigment.front().surface) side.varying = &layers;
    if (side.varying == nullptr) sample(layers, {}, question_, side.constant);
    return side;
}

SurfaceLayers::SurfaceLayers(const World& world, const TextureQuestion& question) : world_(world), question_(question) {
    for (const Material& material : world.materials) {
        outside_.push_back(side(material.layers, material.uses_uv));
        inside_.push_back(side(material.interior_layers.empty() ? material.layers : material.interior_layers, material.uses_uv));
    }
}

const SampledTexture& SurfaceLayers::at(const CompiledObject& object, bool inside, const SeenSurface& seen) {
    const Side& side = inside ? inside_[object.material] : outside_[object.material];
    if (side.varying == nullptr) return side.constant;
    TexturePoint point{seen.point, {seen.normal, seen.direction}, Vec2(0.0)};
    if (side.uses_uv) point.uv = world_.uv(seen.hit, seen.point);
    scratch_.layers.clear();
    scratch_.shares.clear();
    sample(*side.varying, point, question_, scratch_);
    return scratch_;
}

}  // namespace rt
