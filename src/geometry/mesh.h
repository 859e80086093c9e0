// Indexed triangle mesh: what `mesh`, `mesh2` and `bicubic_patch` become. The world spreads a mesh into triangles, so it has no ray test of
// its own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/ray.h"
#include "core/shared.h"
#include "geometry/hit.h"
#include "geometry/texture_weight.h"

namespace rt {

/// Points of a surface: sum of b_i(u) b_j(v) points[i][j] over Bernstein's polynomials, u and v in [0, 1].
struct BezierPatch {
    std::array<std::array<Vec3, 4>, 4> points{};
    int u_steps = 0, v_steps = 0;  ///< times that it is halved along u and v, at most
    double flatness = 0.0;         ///< pieces whose points are nearer than this to a plane are not halved
    /// What textures see instead of (v, u) at the corners (0, 0), (1, 0), (1, 1) and (0, 1); unset: just that.
    std::optional<std::array<Vec2, 4>> corner_uvs = std::nullopt;
    bool operator==(const BezierPatch&) const = default;
};

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
    /// What textures see instead of (u, v), bilinear between the corners (0, 0), (1, 0), (1, 1) and (0, 1); of bicubic patches.
    std::optional<std::array<Vec2, 4>> corner_uvs = std::nullopt;
    bool operator==(const MeshData&) const = default;
};

/// Which of the textures that a mesh states its faces show, as numbers of `TextureWeight`.
struct FaceTextures {
    bool by_corner = false;              ///< three numbers a face, one for each corner, that are mixed between them; else one
    std::vector<std::uint32_t> numbers;  ///< of the faces in order
    bool operator==(const FaceTextures&) const = default;
};

/// Cheap to copy: copies share the data.
struct Mesh {
    Shared<MeshData> data;
    std::optional<Shared<FaceTextures>> textures = std::nullopt;  ///< unset: all faces show the texture of the object
    std::optional<Shared<BezierPatch>> patch = {};                ///< what it was made of, if that has to be done again at its place
    bool operator==(const Mesh&) const = default;
};

/// (u, v) at a hit on face number `face`, u and v of the hit being the weights of its second and third corner.
Vec2 uv(const MeshData& mesh, std::size_t face, const ShapeHit& hit);

/// Appends what shows at such a hit, each texture once: those of corners whose weight is not below `least`.
void texture_weights(const FaceTextures& textures, std::size_t face, const ShapeHit& hit, double least, std::vector<TextureWeight>& out);

inline bool contains(const Mesh&, const Vec3&) { return false; }
Bounds bounds(const Mesh& shape);

}  // namespace rt
