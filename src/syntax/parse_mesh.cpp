// mesh { } : triangles one by one.
#include "syntax/parse_shape.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

struct Corner {
    Vec3 point;
    Vec3 normal{0.0};
};

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

/// Texture coordinates only matter to patterns over them, which are reported where they are asked for.
void skip_triangle_extras(Reader& reader) {
    if (reader.accept(Word::uv_vectors)) {
        for (int i = 0; i < 3; ++i) {
            reader.parse_vector2();
            if (i != 2) reader.accept_comma();
        }
    }
    const Token next = reader.peek();
    if (!reader.accept(Word::texture) && !reader.accept(Word::texture_list)) return;
    reader.unmodelled(next.span, "texture of a mesh triangle");
    skip_inner_block(reader);
}

void add_triangle(MeshData& mesh, const Corner (&corner)[3], bool smooth) {
    if (is_degenerate_triangle(corner[0].point, corner[1].point, corner[2].point)) return;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Corner& c : corner) mesh.vertices.push_back(c.point);
    mesh.faces.push_back({first, first + 1, first + 2});
    if (smooth && mesh.normal_faces.empty())
        mesh.normal_faces.assign(mesh.faces.size() - 1, {MeshData::flat, MeshData::flat, MeshData::flat});
    if (smooth) {
        const auto first_normal = static_cast<std::uint32_t>(mesh.normals.size());
        for (const Corner& c : corner) mesh.normals.push_back(c.normal);
        mesh.normal_faces.push_back({first_normal, first_normal + 1, first_normal + 2});
    } else if (!mesh.normal_faces.empty()) {
        mesh.normal_faces.push_back({MeshData::flat, MeshData::flat, MeshData::flat});
    }
}

bool accept_triangle(Reader& reader, MeshData& mesh) {
    const bool smooth = reader.accept(Word::smooth_triangle);
    if (!smooth && !reader.accept(Word::triangle)) return false;
    reader.begin_block(smooth ? "smooth_triangle" : "triangle");
    Corner corner[3];
    for (int i = 0; i < 3; ++i) {
        corner[i] = parse_corner(reader, smooth);
        if (i != 2) reader.accept_comma();
    }
    skip_triangle_extras(reader);
    reader.end_block();
    if (mesh.vertices.size() > MeshData::flat - 4) reader.fail(reader.peek().span, "Too many triangles in one mesh.");
    add_triangle(mesh, corner, smooth);
    return true;
}

}  // namespace

ParsedShape parse_mesh(Reader& reader) {
    MeshData mesh;
    while (accept_triangle(reader, mesh)) continue;
    if (mesh.faces.empty()) reader.fail(reader.peek().span, "No triangles in triangle mesh.");
    if (reader.accept(Word::inside_vector)) reader.parse_vector();
    return Mesh{std::move(mesh)};
}

}  // namespace rt
