// mesh { } : triangles one by one.
#include <array>
#include <optional>

#include "syntax/mesh_textures.h"

namespace rt {

namespace {

struct Corner {
    Vec3 point;
    Vec3 normal{0.0};
};

constexpr MeshData::Face no_indices{MeshData::flat, MeshData::flat, MeshData::flat};

Corner parse_corner(Reader& reader, bool smooth) {
    Corner corner;
    corner.point = reader.parse_vector();
    if (!smooth) return corner;
    reader.accept_comma();
    corner.normal = reader.parse_vector();
    if (!(length(corner.normal) > 0.0)) {
        reader.warn(reader.peek().span, "Normal vector in mesh cannot be zero - changing it to <1,0,0>.");
        corner.normal = Vec3(1, 0, 0);
    }
    corner.normal = unit(corner.normal);
    return corner;
}

using CornerUvs = std::array<Vec2, 3>;

std::optional<CornerUvs> accept_uvs(Reader& reader) {
    if (!reader.accept(Word::uv_vectors)) return std::nullopt;
    CornerUvs uvs;
    for (std::size_t i = 0; i < 3; ++i) {
        uvs[i] = reader.parse_vector2();
        if (i != 2) reader.accept_comma();
    }
    return uvs;
}

/// A declared texture, by its name alone.
std::uint32_t parse_texture_name(Reader& reader, MeshTextures& textures) {
    const TextureLayers* declared = reader.accept_declared<TextureLayers>();
    if (!declared) reader.fail_expected("texture identifier");
    return textures.number_of(*declared);
}

/// Of the corners of a triangle. Of several textures the last one counts.
MeshTextures::Corners parse_textures(Reader& reader, MeshTextures& textures) {
    MeshTextures::Corners corners = MeshTextures::none;
    while (reader.accept(Word::texture)) {
        reader.begin_block("texture");
        corners.fill(parse_texture_name(reader, textures));
        reader.end_block();
    }
    if (!reader.accept(Word::texture_list)) return corners;
    reader.begin_block("texture_list");
    for (std::uint32_t& corner : corners) {
        corner = parse_texture_name(reader, textures);
        reader.accept_comma();
    }
    reader.end_block();
    return corners;
}

/// Of the face that was added last. The faces before the first one that states something have nothing of it.
template <typename T>
void add_stated(const std::array<T, 3>* stated, std::size_t faces, std::vector<T>& values, std::vector<MeshData::Face>& indices) {
    if (!stated && indices.empty()) return;
    indices.resize(faces, no_indices);
    if (!stated) return;
    const auto first = static_cast<std::uint32_t>(values.size());
    values.insert(values.end(), stated->begin(), stated->end());
    indices.back() = {first, first + 1, first + 2};
}

void add_triangle(MeshData& mesh, const Corner (&corner)[3], bool smooth, const std::optional<CornerUvs>& uvs) {
    if (is_degenerate_triangle(corner[0].point, corner[1].point, corner[2].point)) return;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Corner& c : corner) mesh.vertices.push_back(c.point);
    mesh.faces.push_back({first, first + 1, first + 2});
    const std::array<Vec3, 3> normals{corner[0].normal, corner[1].normal, corner[2].normal};
    add_stated(smooth ? &normals : nullptr, mesh.faces.size(), mesh.normals, mesh.normal_faces);
    add_stated(uvs ? &*uvs : nullptr, mesh.faces.size(), mesh.uvs, mesh.uv_faces);
}

bool accept_triangle(Reader& reader, MeshData& mesh, MeshTextures& textures) {
    const bool smooth = reader.accept(Word::smooth_triangle);
    if (!smooth && !reader.accept(Word::triangle)) return false;
    reader.begin_block(smooth ? "smooth_triangle" : "triangle");
    Corner corner[3];
    for (int i = 0; i < 3; ++i) {
        corner[i] = parse_corner(reader, smooth);
        if (i != 2) reader.accept_comma();
    }
    const std::optional<CornerUvs> uvs = accept_uvs(reader);
    const MeshTextures::Corners corner_textures = parse_textures(reader, textures);
    reader.end_block();
    if (mesh.vertices.size() > MeshData::flat - 4) reader.fail(reader.peek().span, "Too many triangles in one mesh.");
    const std::size_t face = mesh.faces.size();
    add_triangle(mesh, corner, smooth, uvs);
    if (mesh.faces.size() > face) textures.add_face(face, corner_textures);
    return true;
}

}  // namespace

ParsedShape parse_mesh(Reader& reader) {
    MeshData mesh;
    MeshTextures textures;
    while (accept_triangle(reader, mesh, textures)) continue;
    if (mesh.faces.empty()) reader.fail(reader.peek().span, "No triangles in triangle mesh.");
    if (reader.accept(Word::inside_vector)) reader.parse_vector();
    return textures.finish(std::move(mesh));
}

}  // namespace rt
