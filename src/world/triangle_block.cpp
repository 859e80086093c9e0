#include "world/triangle_block.h"

#include <algorithm>

namespace rt {

TriangleBlock make_block(const Surfaces& surfaces, std::span<const std::uint32_t> faces, const LocalFrame& frame) {
    TriangleBlock block{};
    block.lanes = (1u << faces.size()) - 1u;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        // Empty lanes repeat the first triangle: their numbers must be ordinary ones.
        const std::uint32_t face = faces[lane < faces.size() ? lane : 0];
        block.face[lane] = face;
        block.seen[lane] = surfaces.objects[surfaces.face_object[face]].seen;
        Vec3 corners[3];
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p = corners[corner] = frame.to_local(surfaces.vertices[surfaces.faces[face][corner]]);
            for (int axis = 0; axis < 3; ++axis) block.corner[corner][axis][lane] = static_cast<float>(p[axis]);
        }
        const double longest =
            std::max({length(corners[1] - corners[0]), length(corners[2] - corners[1]), length(corners[0] - corners[2])});
        block.error[lane] = TriangleBlock::error_bound(static_cast<float>(longest));
    }
    return block;
}

}  // namespace rt
