// The layers of a material at a point. Materials without patterns and bumps are sampled once for the whole picture.
#pragma once

#include <span>
#include <vector>

#include "world/world.h"

namespace rt {

/// Where a ray met a surface.
struct SeenSurface {
    const Hit& hit;
    const Vec3& point;
    const Vec3& normal;     ///< turned against the ray
    const Vec3& direction;  ///< the ray's, unit
};

class SurfaceLayers {
public:
    SurfaceLayers(const World& world, const TextureQuestion& question);

    /// What the side of `object` that is seen shows. Valid until the next call.
    const SampledTexture& at(const CompiledObject& object, bool inside, const SeenSurface& seen);

private:
    /// One side of a material: `constant`, unless it depends on the point.
    struct Side {
        const std::vector<LayerNode>* varying = nullptr;
        std::span<const std::uint32_t> shape_textures;  ///< their materials
        bool uses_uv = false;
        SampledTexture constant;
    };
    Side side(const Material& material, bool inside) const;
    const SampledTexture& blend(const Side& side, const TexturePoint& point, const SeenSurface& seen);

    const World& world_;
    TextureQuestion question_;
    std::vector<Side> outside_, inside_;  ///< by material
    SampledTexture scratch_;
    std::vector<TextureWeight> weights_;
};

}  // namespace rt
