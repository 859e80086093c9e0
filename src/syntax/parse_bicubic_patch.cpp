// bicubic_patch { }: POV-Ray makes smooth triangles of it, and so a mesh is what it becomes.
#include <array>

#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

constexpr int most_steps = 8;  ///< 2^8 x 2^8 cells of two triangles

using Points = std::array<std::array<Vec3, 4>, 4>;

std::array<double, 4> weights(double t) {
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t};
}
std::array<double, 4> slopes(double t) {
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * s - 6.0 * t * s, 6.0 * t * s - 3.0 * t * t, 3.0 * t * t};
}

Vec3 sum(const Points& p, const std::array<double, 4>& by_row, const std::array<double, 4>& by_column) {
    Vec3 all(0.0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) all += by_row[i] * by_column[j] * p[i][j];
    return all;
}

struct Steps {
    int u = 0, v = 0;
    double flatness = 0.0;
};

int parse_steps(Reader& reader) { return std::min(std::max(parse_int(reader), 0), most_steps); }

Steps parse_head(Reader& reader) {
    Steps steps;
    std::optional<int> type;
    for (;;) {
        const Span place = reader.peek().span;
        if (reader.accept(Word::type)) {
            type = parse_int(reader);
            if (*type != 0 && *type != 1) reader.warn(place, "Patch type no longer supported. Using type 1.");
        } else if (reader.accept(Word::flatness)) {
            steps.flatness = reader.parse_float();
        } else if (reader.accept(Word::u_steps)) {
            steps.u = parse_steps(reader);
        } else if (reader.accept(Word::v_steps)) {
            steps.v = parse_steps(reader);
        } else if (reader.accept(Word::uv_vectors)) {
            for (int i = 0; i < 4; ++i) {
                reader.accept_comma();
                reader.parse_vector2();
            }
        } else {
            break;
        }
        reader.accept_comma();
    }
    if (!type) reader.fail(reader.peek().span, "Undefined bicubic patch type.");
    return steps;
}

/// The unit normal of the surface; where its two tangents do not span a plane, that of a point a little further in.
Vec3 surface_normal(const Points& p, double u, double v) {
    for (double inward = 0.0; inward < 0.1; inward = inward == 0.0 ? 1e-6 : 10.0 * inward) {
        const double a = u + inward * (0.5 - u), b = v + inward * (0.5 - v);
        const Vec3 n = cross(sum(p, slopes(a), weights(b)), sum(p, weights(a), slopes(b)));
        if (const double size = length(n); size > 1e-12) return n / size;
    }
    return {1.0, 0.0, 0.0};
}

}  // namespace

ParsedShape parse_bicubic_patch(Reader& reader) {
    const Steps steps = parse_head(reader);
    Points points;
    for (auto& row : points) {
        for (Vec3& p : row) {
            reader.accept_comma();
            p = reader.parse_vector();
        }
    }
    const std::uint32_t rows = 1u << steps.u, columns = 1u << steps.v;
    MeshData mesh;
    for (std::uint32_t i = 0; i <= rows; ++i) {
        for (std::uint32_t j = 0; j <= columns; ++j) {
            const double u = static_cast<double>(i) / rows, v = static_cast<double>(j) / columns;
            mesh.vertices.push_back(sum(points, weights(u), weights(v)));
            mesh.normals.push_back(surface_normal(points, u, v));
        }
    }
    const auto add = [&](const MeshData::Face& face) {
        if (is_degenerate_triangle(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]])) return;
        mesh.faces.push_back(face);
        mesh.normal_faces.push_back(face);
    };
    for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t a = i * (columns + 1) + j, b = a + 1, d = a + columns + 1, c = d + 1;
            add({a, b, c});
            add({a, c, d});
        }
    }
    if (mesh.faces.empty()) return std::nullopt;
    return Mesh{std::move(mesh)};
}

}  // namespace rt
