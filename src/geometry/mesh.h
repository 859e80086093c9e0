// Indexed triangle mesh: what both `mesh` and `mesh2` become. The world spreads a mesh into triangles, so it has no ray test of its own.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/ray.h"
#include "core/shared.h"
#include "geometry/hit.h"

namespace rt {

struct MeshData {
    using Face = std::array<std::uint32_t, 3>;
    std::vector<Vec3> vertices;
    std::vector<Face> faces;    ///< indices into vertices; degenerate faces are left out by the parser, with POV-Ray's warning
    std::vector<Vec3> normals;  ///< unit; empty for a flat mesh
    /// Empty, or one entry a face: indices into normals; a face of three equal `flat` entries has its own flat normal.
    std::vector<Face> normal_faces;
    static constexpr std::uint32_t flat = 0xffffffffu;
    std::vector<Vec2> uvs;  ///< of corners, for textures that are seen at (u, v, 0)
    /// Empty, or one entry a face: indices into uvs; a face of three equal `flat` entries has none, and is (0, 0).
    std::vector<Face> uv_faces;
    bool operator==(const MeshData&) const = default;
};

/// Cheap to copy: copies share the data.
struct Mesh {
    Shared<MeshData> data;
    bool operator==(const Mesh&) const = default;
};

/// (u, v) at a hit on face number `face`, u and v of the hit being the weights of its second and third corner.
Vec2 uv(const MeshData& mesh, std::size_t face, const ShapeHit& hit);

inline bool contains(const Mesh&, const Vec3&) { return false; }
Bounds bounds(const Mesh& shape);

}  // namespace rt
