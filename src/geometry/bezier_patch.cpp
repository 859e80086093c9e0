#include "geometry/bezier_patch.h"

#include "geometry/triangle.h"

namespace rt {

namespace {

using Row = std::array<Vec3, 4>;
using Points = std::array<Row, 4>;

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

/// The unit normal of the surface; where its two tangents do not span a plane, that of a point a little further in.
Vec3 surface_normal(const Points& p, double u, double v) {
    for (double inward = 0.0; inward < 0.1; inward = inward == 0.0 ? 1e-6 : 10.0 * inward) {
        const double a = u + inward * (0.5 - u), b = v + inward * (0.5 - v);
        const Vec3 n = cross(sum(p, slopes(a), weights(b)), sum(p, weights(a), slopes(b)));
        if (const double size = length(n); size > 1e-12) return n / size;
    }
    return {1.0, 0.0, 0.0};
}

/// De Casteljau's points of one half of a curve.
Row half_of(const Row& p, bool second) {
    const auto middle = [](const Vec3& a, const Vec3& b) { return 0.5 * (a + b); };
    const Vec3 ab = middle(p[0], p[1]), bc = middle(p[1], p[2]), cd = middle(p[2], p[3]);
    const Vec3 abc = middle(ab, bc), bcd = middle(bc, cd), centre = middle(abc, bcd);
    return second ? Row{centre, bcd, cd, p[3]} : Row{p[0], ab, abc, centre};
}
Points transposed(const Points& p) {
    Points t;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) t[j][i] = p[i][j];
    return t;
}
Points half_along_v(Points p, bool second) {
    for (Row& row : p) row = half_of(row, second);
    return p;
}
Points half_along_u(const Points& p, bool second) { return transposed(half_along_v(transposed(p), second)); }

/// Largest distance from the plane through three corners: the fourth one takes part only where two of these coincide.
double unevenness(const Points& p) {
    const Vec3 corners[3] = {cross(p[0][3] - p[0][0], p[3][0] - p[0][0]), cross(p[3][3] - p[0][0], p[3][0] - p[0][0]),
                             cross(p[0][3] - p[0][0], p[3][3] - p[0][0])};
    for (const Vec3& n : corners) {
        const double size = length(n);
        if (!(size > 0.0)) continue;
        double largest = 0.0;
        for (const Row& row : p)
            for (const Vec3& point : row) largest = std::fmax(largest, std::fabs(dot(point - p[0][0], n)) / size);
        return largest;
    }
    return infinity;
}

class Tessellation {
public:
    Tessellation(const BezierPatch& patch, MeshData& out) : patch_(patch), out_(out) {}

    /// The piece in row i of 2^u_halves and column j of 2^v_halves, with its points as they stand in the world.
    void add(const Points& moved, int u_halves, int v_halves, std::uint32_t i, std::uint32_t j) {
        const bool by_u = u_halves < patch_.u_steps, by_v = v_halves < patch_.v_steps;
        if ((by_u || by_v) && (patch_.flatness <= 0.0 || unevenness(moved) >= patch_.flatness)) {
            for (const bool low : {false, true}) {
                if (low && !by_u) continue;
                const Points strip = by_u ? half_along_u(moved, low) : moved;
                for (const bool right : {false, true}) {
                    if (right && !by_v) continue;
                    add(by_v ? half_along_v(strip, right) : strip, u_halves + by_u, v_halves + by_v, by_u ? 2 * i + low : i,
                        by_v ? 2 * j + right : j);
                }
            }
            return;
        }
        const double rows = std::ldexp(1.0, u_halves), columns = std::ldexp(1.0, v_halves);
        const auto corner = [&](std::uint32_t row, std::uint32_t column) {
            const double u = row / rows, v = column / columns;
            out_.vertices.push_back(sum(patch_.points, weights(u), weights(v)));
            out_.normals.push_back(surface_normal(patch_.points, u, v));
            out_.uvs.push_back({v, u});
            return static_cast<std::uint32_t>(out_.vertices.size() - 1);
        };
        const std::uint32_t a = corner(i, j), b = corner(i, j + 1), c = corner(i + 1, j + 1), d = corner(i + 1, j);
        for (const MeshData::Face& face : {MeshData::Face{a, b, c}, MeshData::Face{a, c, d}}) {
            if (is_degenerate_triangle(out_.vertices[face[0]], out_.vertices[face[1]], out_.vertices[face[2]])) continue;
            out_.faces.push_back(face);
            out_.normal_faces.push_back(face);
            out_.uv_faces.push_back(face);
        }
    }

private:
    const BezierPatch& patch_;
    MeshData& out_;
};

}  // namespace

MeshData triangles_of(const BezierPatch& patch, const Transform& to_world) {
    Points moved = patch.points;
    for (Row& row : moved)
        for (Vec3& point : row) point = to_world.point(point);
    MeshData mesh;
    mesh.corner_uvs = patch.corner_uvs;
    Tessellation(patch, mesh).add(moved, 0, 0, 0, 0);
    return mesh;
}

}  // namespace rt
