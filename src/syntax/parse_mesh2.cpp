// mesh2 { } : vertex lists and faces of indices.
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/mesh_textures.h"
#include "syntax/parameters.h"

namespace rt {

namespace {

constexpr MeshData::Face flat_face{MeshData::flat, MeshData::flat, MeshData::flat};

struct Mesh2 {
    MeshData data;
    std::vector<char> kept;  ///< a stated face: 0 if it was degenerate and is left out
    MeshTextures textures;
    std::vector<std::uint32_t> texture_numbers;  ///< of those in the list
};

/// The shortest vector that a list can hold is one character and a blank.
constexpr std::size_t least_bytes = 2;

void parse_vectors(Reader& reader, std::string_view name, std::vector<Vec3>& vectors) {
    reader.begin_block(name);
    const std::size_t count = parse_count(reader);
    vectors.clear();
    vectors.reserve(reserve_limit(reader, count, least_bytes));
    reader.accept_comma();
    for (std::size_t i = 0; i < count; ++i) {
        vectors.push_back(reader.parse_vector());
        reader.accept_comma();
    }
    reader.end_block();
}

void warn_duplicate(Reader& reader, bool duplicate, std::string_view name) {
    if (duplicate) reader.warn(reader.peek().span, fmt::format("Duplicate {} block; ignoring previous block.", name));
}

void parse_normals(Reader& reader, std::vector<Vec3>& normals) {
    reader.begin_block("normal_vectors");
    const std::size_t count = parse_count(reader);
    normals.clear();
    normals.reserve(reserve_limit(reader, count, least_bytes));
    reader.accept_comma();
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 normal = reader.parse_vector();
        if (!(length(normal) > 0.0)) {
            reader.warn(reader.peek().span, "Normal vector in mesh2 cannot be zero - changing it to <1,0,0>.");
            normal = Vec3(1, 0, 0);
        }
        normals.push_back(unit(normal));
        reader.accept_comma();
    }
    reader.end_block();
}

void parse_uvs(Reader& reader, std::vector<Vec2>& uvs) {
    reader.begin_block("uv_vectors");
    const std::size_t count = parse_count(reader);
    uvs.clear();
    uvs.reserve(reserve_limit(reader, count, least_bytes));
    reader.accept_comma();
    for (std::size_t i = 0; i < count; ++i) {
        uvs.push_back(reader.parse_vector2());
        reader.accept_comma();
    }
    reader.end_block();
}

void parse_texture_list(Reader& reader, Mesh2& mesh) {
    reader.begin_block("texture_list");
    const std::size_t count = parse_count(reader);
    reader.accept_comma();
    for (std::size_t i = 0; i < count; ++i) {
        if (!reader.accept(Word::texture)) reader.fail_expected("texture");
        std::optional<TextureLayers> layers;
        parse_texture(reader, layers);
        mesh.texture_numbers.push_back(mesh.textures.number_of(*layers));
        reader.accept_comma();
    }
    reader.end_block();
}

/// Three indices below `size`, cut to whole numbers.
MeshData::Face parse_indices(Reader& reader, std::size_t size, std::string_view out_of_range) {
    const Vec3 stated = reader.parse_vector();
    MeshData::Face face;
    for (int i = 0; i < 3; ++i) {
        const bool inside = stated[i] > -1.0 && stated[i] < static_cast<double>(size);
        if (!inside) reader.fail(reader.peek().span, out_of_range);
        face[i] = static_cast<std::uint32_t>(stated[i]);
    }
    return face;
}

bool at_vector(Reader& reader) {
    const Value* const value = reader.next_value();
    const Number* const number = value ? std::get_if<Number>(value) : nullptr;
    return reader.peek().is('<') || (number && number->size > 1);
}

/// A face may be followed by one texture index or three: as many as there are numbers before the next vector.
MeshTextures::Corners parse_texture_indices(Reader& reader, const Mesh2& mesh) {
    MeshTextures::Corners corners = MeshTextures::none;
    int count = 0;
    for (; count < 3 && reader.at_expression() && !at_vector(reader); ++count) {
        const int index = parse_int(reader);
        if (index < 0 || static_cast<std::size_t>(index) >= mesh.texture_numbers.size())
            reader.fail(reader.peek().span, "Texture index out of range in mesh2.");
        corners[count] = mesh.texture_numbers[static_cast<std::size_t>(index)];
        reader.accept_comma();
    }
    if (count == 2) reader.fail(reader.peek().span, "A face of a mesh2 has one texture index or three.");
    if (count == 1) corners.fill(corners[0]);
    return corners;
}

void parse_faces(Reader& reader, Mesh2& mesh) {
    MeshData& data = mesh.data;
    reader.begin_block("face_indices");
    const std::size_t count = parse_count(reader);
    reader.accept_comma();
    if (count == 0) reader.fail(reader.peek().span, "No triangles in triangle mesh.");
    const std::size_t expected = reserve_limit(reader, count, least_bytes);
    data.faces.reserve(expected);
    mesh.kept.reserve(expected);
    for (std::size_t i = 0; i < count; ++i) {
        const MeshData::Face face = parse_indices(reader, data.vertices.size(), "Mesh face index out of range.");
        reader.accept_comma();
        const MeshTextures::Corners textures = parse_texture_indices(reader, mesh);
        const bool keep = !is_degenerate_triangle(data.vertices[face[0]], data.vertices[face[1]], data.vertices[face[2]]);
        mesh.kept.push_back(keep);
        if (!keep) continue;
        mesh.textures.add_face(data.faces.size(), textures);
        data.faces.push_back(face);
    }
    reader.end_block();
}

/// Normals of the first faces; those without stay flat.
void parse_normal_indices(Reader& reader, Mesh2& mesh) {
    MeshData& data = mesh.data;
    reader.begin_block("normal_indices");
    const std::size_t count = parse_count(reader);
    if (count > mesh.kept.size()) reader.fail(reader.peek().span, "Number of normal indices cannot be more than the number of faces.");
    reader.accept_comma();
    if (count > 0) data.normal_faces.reserve(data.faces.size());
    for (std::size_t i = 0; i < count; ++i) {
        const MeshData::Face face = parse_indices(reader, data.normals.size(), "Mesh normal index out of range.");
        if (mesh.kept[i]) data.normal_faces.push_back(face);
        reader.accept_comma();
    }
    reader.end_block();
    if (count > 0) data.normal_faces.resize(data.faces.size(), flat_face);
}

void parse_uv_indices(Reader& reader, Mesh2& mesh) {
    MeshData& data = mesh.data;
    reader.begin_block("uv_indices");
    if (parse_count(reader) != mesh.kept.size()) reader.fail(reader.peek().span, "Number of uv indices must equal number of faces.");
    reader.accept_comma();
    data.uv_faces.clear();
    data.uv_faces.reserve(data.faces.size());
    for (const char kept : mesh.kept) {
        const MeshData::Face face = parse_indices(reader, data.uvs.size(), "Mesh UV index out of range.");
        if (kept) data.uv_faces.push_back(face);
        reader.accept_comma();
    }
    reader.end_block();
}

/// Without indices of their own there is one for each vertex.
void settle_uvs(Reader& reader, MeshData& data) {
    if (data.uvs.empty() || !data.uv_faces.empty()) return;
    if (data.uvs.size() != data.vertices.size()) reader.fail(reader.peek().span, "Missing uv_indicies section in mesh2.");
    data.uv_faces = data.faces;
}

/// The lists before the faces.
void parse_lists(Reader& reader, Mesh2& mesh) {
    for (;;) {
        const Token next = reader.peek();
        if (reader.accept(Word::vertex_vectors)) {
            warn_duplicate(reader, !mesh.data.vertices.empty(), "vertex_vectors");
            parse_vectors(reader, "vertex_vectors", mesh.data.vertices);
            if (mesh.data.vertices.empty()) reader.fail(next.span, "No vertices in triangle mesh.");
        } else if (reader.accept(Word::normal_vectors)) {
            warn_duplicate(reader, !mesh.data.normals.empty(), "normal_vectors");
            parse_normals(reader, mesh.data.normals);
        } else if (reader.accept(Word::uv_vectors)) {
            warn_duplicate(reader, !mesh.data.uvs.empty(), "uv_vectors");
            parse_uvs(reader, mesh.data.uvs);
        } else {
            break;
        }
    }
    if (mesh.data.vertices.empty()) reader.fail(reader.peek().span, "Vertex vectors not found in mesh2");
    if (reader.accept(Word::texture_list)) parse_texture_list(reader, mesh);
}

}  // namespace

ParsedShape parse_mesh2(Reader& reader) {
    Mesh2 mesh;
    parse_lists(reader, mesh);
    MeshData& data = mesh.data;
    if (!reader.accept(Word::face_indices)) reader.fail_expected("face_indices");
    parse_faces(reader, mesh);
    bool has_normal_indices = false;
    for (;;) {
        if (reader.accept(Word::normal_indices)) {
            has_normal_indices = true;
            parse_normal_indices(reader, mesh);
        } else if (reader.accept(Word::uv_indices)) {
            parse_uv_indices(reader, mesh);
        } else {
            break;
        }
    }
    const bool one_per_vertex = data.normals.size() == data.vertices.size();
    if (!data.normals.empty() && !has_normal_indices && !one_per_vertex)
        reader.fail(reader.peek().span, "Missing normal_indicies section in mesh2.");
    if (data.normal_faces.empty() && !data.normals.empty()) {
        if (one_per_vertex)
            data.normal_faces = data.faces;
        else
            data.normals.clear();
    }
    settle_uvs(reader, data);
    if (reader.accept(Word::inside_vector)) reader.parse_vector();
    if (data.faces.empty()) return std::nullopt;
    return mesh.textures.finish(std::move(data));
}

}  // namespace rt
