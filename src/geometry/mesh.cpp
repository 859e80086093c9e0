#include "geometry/mesh.h"

namespace rt {

Bounds bounds(const Mesh& shape) {
    Bounds b;
    for (const MeshData::Face& face : shape.data->faces)
        for (const std::uint32_t vertex : face) b.extend(shape.data->vertices[vertex]);
    return b;
}

Vec2 uv(const MeshData& mesh, std::size_t face, const ShapeHit& hit) {
    if (mesh.uv_faces.empty() || mesh.uv_faces[face][0] == MeshData::flat) return Vec2(0.0);
    const MeshData::Face& f = mesh.uv_faces[face];
    return (1.0 - hit.u - hit.v) * mesh.uvs[f[0]] + hit.u * mesh.uvs[f[1]] + hit.v * mesh.uvs[f[2]];
}

}  // namespace rt
