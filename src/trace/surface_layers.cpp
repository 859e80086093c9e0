#include "trace/surface_layers.h"

namespace rt {

SurfaceLayers::Side SurfaceLayers::side(const std::vector<LayerNode>& layers) const {
    Side side;
    for (const LayerNode& layer : layers) {
        if (layer.checker || (!layer.pigment.empty() && layer.pigment.front().checker)) side.pattern = &layers;
    }
    if (side.pattern == nullptr) sample_layers(layers, Vec3(0.0), side.constant, quick_);
    return side;
}

SurfaceLayers::SurfaceLayers(const World& world, bool quick) : quick_(quick) {
    for (const Material& material : world.materials) {
        outside_.push_back(side(material.layers));
        inside_.push_back(side(material.interior_layers.empty() ? material.layers : material.interior_layers));
    }
}

std::span<const LayerSample> SurfaceLayers::at(const CompiledObject& object, bool inside, const Vec3& point) {
    const Side& side = inside ? inside_[object.material] : outside_[object.material];
    if (side.pattern == nullptr) return side.constant;
    scratch_.clear();
    sample_layers(*side.pattern, point, scratch_, quick_);
    return scratch_;
}

}  // namespace rt
