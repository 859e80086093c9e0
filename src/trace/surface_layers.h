// The layers of a material at a point. Materials without patterns are sampled once for the whole picture.
#pragma once

#include <span>
#include <vector>

#include "world/world.h"

namespace rt {

class SurfaceLayers {
public:
    explicit SurfaceLayers(const World& world);

    /// Layers of the side of `object` that is seen, top layer first. Valid until the next call.
    std::span<const LayerSample> at(const CompiledObject& object, bool inside, const Vec3& point);

private:
    /// One side of a material: `constant`, unless there is a `pattern`.
    struct Side {
        const std::vector<LayerNode>* pattern = nullptr;
        std::vector<LayerSample> constant;
    };
    static Side side(const std::vector<LayerNode>& layers);

    std::vector<Side> outside_, inside_;  ///< by material
    std::vector<LayerSample> scratch_;
};

}  // namespace rt
