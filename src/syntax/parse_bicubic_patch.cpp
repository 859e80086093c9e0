// bicubic_patch { }: POV-Ray makes smooth triangles of it, and so a mesh is what it becomes.
#include "geometry/bezier_patch.h"
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

constexpr int most_steps = 8;  ///< 2^8 x 2^8 cells of two triangles

int parse_steps(Reader& reader) { return std::min(std::max(parse_int(reader), 0), most_steps); }

BezierPatch parse_head(Reader& reader) {
    BezierPatch patch;
    std::optional<int> type;
    for (;;) {
        const Span place = reader.peek().span;
        if (reader.accept(Word::type)) {
            type = parse_int(reader);
            if (*type != 0 && *type != 1) reader.warn(place, "Patch type no longer supported. Using type 1.");
        } else if (reader.accept(Word::flatness)) {
            patch.flatness = reader.parse_float();
        } else if (reader.accept(Word::u_steps)) {
            patch.u_steps = parse_steps(reader);
        } else if (reader.accept(Word::v_steps)) {
            patch.v_steps = parse_steps(reader);
        } else if (reader.accept(Word::uv_vectors)) {
            for (Vec2& corner : patch.corner_uvs.emplace()) {
                reader.accept_comma();
                corner = reader.parse_vector2();
            }
        } else {
            break;
        }
        reader.accept_comma();
    }
    if (!type) reader.fail(reader.peek().span, "Undefined bicubic patch type.");
    return patch;
}

}  // namespace

ParsedShape parse_bicubic_patch(Reader& reader) {
    BezierPatch patch = parse_head(reader);
    for (auto& row : patch.points) {
        for (Vec3& p : row) {
            reader.accept_comma();
            p = reader.parse_vector();
        }
    }
    MeshData mesh = triangles_of(patch, {});
    if (mesh.faces.empty()) return std::nullopt;
    Mesh shape{std::move(mesh)};
    // Where it is to be halved until it is flat, that depends on how large it will be at its place.
    if (patch.flatness > 0.0) shape.patch.emplace(std::move(patch));
    return shape;
}

}  // namespace rt
