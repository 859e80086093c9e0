#include "world/shape_frame.h"

namespace rt {

void texture_weights(const ShapeFrame& frame, const Vec3& point, std::size_t face, const ShapeHit& hit, double least,
                     std::vector<TextureWeight>& out) {
    if (const Mesh* mesh = std::get_if<Mesh>(&frame.shape)) return texture_weights(**mesh->textures, face, hit, least, out);
    const auto* further = std::get_if<FurtherShape>(&frame.shape);
    if (further == nullptr) return;
    std::visit(
        [&](const auto& shape) {
            if constexpr (requires { texture_weights(shape, point, least, out); })
                texture_weights(shape, frame.to_world.inverse_point(point), least, out);
        },
        *further);
}

}  // namespace rt
