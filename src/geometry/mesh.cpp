#include "geometry/mesh.h"

namespace rt {

Bounds bounds(const Mesh& shape) {
    Bounds b;
    for (const MeshData::Face& face : shape.data->faces)
        for (const std::uint32_t vertex : face) b.extend(shape.data->vertices[vertex]);
    return b;
}

}  // namespace rt
