// The layers of a material at a point. Materials without patterns are sampled once for the whole picture.
#pragma once

#include <span>
#include <vector>

#include "world/world.h"

namespace rt {

class SurfaceLayers {
public:
    /// With `quick`, in quick colours where the scene states them.
    SurfaceLayers(const World& world, bool quick);

    /// Layers of the side of `object` that is seen, top layer first. Valid until the next call.
    std::span<const LayerSample> at(const CompiledObject& object, bool inside, const Vec3& point);

private:
    /// One side of a material: `constant`, unless there is a `pattern`.
    struct Side {
        const std::vector<LayerNode>* pattern = nullptr;
        std::vector<LayerSample> constant;
    };
    Side side(const std::vector<LayerNode>& layers) const;

    bool quick_;
    std::vector<Side> outside_, inside_;  ///< by material
    std::vector<LayerSample> scratch_;
};

}  // namespace rt
