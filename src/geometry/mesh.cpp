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
    const Vec2 place = (1.0 - hit.u - hit.v) * mesh.uvs[f[0]] + hit.u * mesh.uvs[f[1]] + hit.v * mesh.uvs[f[2]];
    if (!mesh.corner_uvs) return place;
    const auto& [c00, c10, c11, c01] = *mesh.corner_uvs;
    return (1.0 - place.y) * ((1.0 - place.x) * c00 + place.x * c10) + place.y * ((1.0 - place.x) * c01 + place.x * c11);
}

void texture_weights(const FaceTextures& textures, std::size_t face, const ShapeHit& hit, double least, std::vector<TextureWeight>& out) {
    const std::uint32_t* const numbers = &textures.numbers[textures.by_corner ? 3 * face : face];
    if (!textures.by_corner || (numbers[0] == numbers[1] && numbers[0] == numbers[2])) {
        out.push_back({numbers[0], 1.0});
        return;
    }
    const std::array<double, 3> weights{1.0 - hit.u - hit.v, hit.u, hit.v};
    const std::size_t first = out.size();
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (!(weights[corner] < least)) out.push_back({numbers[corner], weights[corner]});
    join_textures(out, first);
}

}  // namespace rt
