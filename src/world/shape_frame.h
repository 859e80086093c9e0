// A shape of which more is asked where a ray met it than rays themselves ask.
#pragma once

#include "core/transform.h"
#include "geometry/shape.h"

namespace rt {

/// Of objects whose textures are seen at (u, v, 0), or whose shapes state textures; of a mesh without (u, v) only the textures are here.
struct ShapeFrame {
    Shape shape;
    Transform to_world;
};

/// Appends which textures of the shape show at a point of its surface, in world space, where face number `face` was met; those of mixtures
/// whose weight is below `least` are left out.
void texture_weights(const ShapeFrame& frame, const Vec3& point, std::size_t face, const ShapeHit& hit, double least,
                     std::vector<TextureWeight>& out);

}  // namespace rt
