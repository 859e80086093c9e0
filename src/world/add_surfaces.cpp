// Scene objects into the arrays of `Surfaces`.

#include "world/surfaces.h"

namespace rt {

namespace {

/// The common factor of a map that is a rotation (or mirror) times a scale, 0 for any other.
double similarity_scale(const Mat3& m) {
    const Mat3 gram = glm::transpose(m) * m;
    const double square = (gram[0][0] + gram[1][1] + gram[2][2]) / 3.0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::fabs(gram[i][j] - (i == j ? square : 0.0)) <= 4e-15 * square)) return 0.0;
    return std::sqrt(square);
}

Plane moved(const Plane& plane, const Transform& to_world) {
    const Vec3 n = to_world.normal(plane.normal);
    return {unit(n), (plane.distance + dot(n, to_world.offset)) / length(n)};
}

std::uint32_t index32(std::size_t n) {
    if (n >= Surface::flat) throw LimitError("the scene has more than 4,294,967,294 surfaces");
    return static_cast<std::uint32_t>(n);
}

template <typename S>
void place(std::vector<Placed<S>>& list, const S& shape, const Transform& to_world, SurfaceKind kind, Surface& s) {
    s.kind = kind;
    s.first = index32(list.size());
    list.push_back({shape, !to_world.is_identity(), to_world});
}

/// Shapes that POV-Ray leaves as they are when told `inverse`.
bool ignores_inverse(const Shape& shape) {
    return std::holds_alternative<Triangle>(shape) || std::holds_alternative<SmoothTriangle>(shape) ||
           std::holds_alternative<Polygon>(shape);
}

void offset_face(const MeshData::Face& face, std::uint32_t by, std::vector<MeshData::Face>& out) {
    out.push_back({face[0] + by, face[1] + by, face[2] + by});
}

}  // namespace

void Surfaces::add_triangle(const Transform& to_world, const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>* corner_normals,
                            Surface& s) {
    s.kind = SurfaceKind::triangles;
    s.first = index32(faces.size());
    offset_face({0, 1, 2}, index32(vertices.size()), faces);
    face_object.push_back(index32(objects.size()));
    for (const Vec3& corner : corners) vertices.push_back(to_world.point(corner));
    if (!corner_normals) return;
    s.first_normals = index32(normal_faces.size());
    offset_face({0, 1, 2}, index32(normals.size()), normal_faces);
    for (const Vec3& n : *corner_normals) normals.push_back(unit(to_world.normal(n)));
}

void Surfaces::add_mesh(const Transform& to_world, const MeshData& mesh, Surface& s) {
    s.kind = SurfaceKind::triangles;
    s.first = index32(faces.size());
    s.count = index32(mesh.faces.size());
    s.of_mesh = true;
    s.mirrored = glm::determinant(to_world.linear) < 0.0;
    const std::uint32_t first_vertex = index32(vertices.size());
    index32(vertices.size() + mesh.vertices.size());
    index32(faces.size() + mesh.faces.size());
    for (const Vec3& vertex : mesh.vertices) vertices.push_back(to_world.point(vertex));
    for (const auto& face : mesh.faces) offset_face(face, first_vertex, faces);
    face_object.resize(faces.size(), index32(objects.size()));
    if (mesh.normal_faces.empty()) return;
    s.first_normals = index32(normal_faces.size());
    const std::uint32_t first_normal = index32(normals.size());
    index32(normals.size() + mesh.normals.size());
    for (const Vec3& n : mesh.normals) normals.push_back(to_world.normal(n));
    for (const auto& face : mesh.normal_faces) {
        if (face[0] == MeshData::flat)
            normal_faces.push_back({Surface::flat, Surface::flat, Surface::flat});
        else
            offset_face(face, first_normal, normal_faces);
    }
}

void Surfaces::add_shape(const Object& object, const Transform& to_world, Surface& s) {
    std::visit(
        [&](const auto& shape) {
            using S = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<S, Sphere>) {
                const double scale = to_world.is_identity() ? 1.0 : similarity_scale(to_world.linear);
                if (scale > 0.0) {
                    s.kind = SurfaceKind::sphere;
                    s.first = index32(spheres.size());
                    spheres.push_back({to_world.point(shape.center), scale * shape.radius});
                } else {
                    place(placed_spheres, shape, to_world, SurfaceKind::placed_sphere, s);
                }
            } else if constexpr (std::is_same_v<S, Plane>) {
                s.kind = SurfaceKind::plane;
                s.first = index32(planes.size());
                planes.push_back(to_world.is_identity() ? shape : moved(shape, to_world));
            } else if constexpr (std::is_same_v<S, Triangle>) {
                add_triangle(to_world, {shape.a, shape.b, shape.c}, nullptr, s);
            } else if constexpr (std::is_same_v<S, SmoothTriangle>) {
                const std::array<Vec3, 3> corner_normals{shape.normal_a, shape.normal_b, shape.normal_c};
                add_triangle(to_world, {shape.a, shape.b, shape.c}, &corner_normals, s);
            } else if constexpr (std::is_same_v<S, Mesh>) {
                add_mesh(to_world, *shape.data, s);
            } else if constexpr (std::is_same_v<S, Box>) {
                place(boxes, shape, to_world, SurfaceKind::box, s);
            } else if constexpr (std::is_same_v<S, Cone>) {
                place(cones, shape, to_world, SurfaceKind::cone, s);
            } else if constexpr (std::is_same_v<S, Torus>) {
                place(toruses, shape, to_world, SurfaceKind::torus, s);
            } else if constexpr (std::is_same_v<S, Disc>) {
                place(discs, shape, to_world, SurfaceKind::disc, s);
            } else if constexpr (std::is_same_v<S, Polygon>) {
                place(polygons, shape, to_world, SurfaceKind::polygon, s);
            } else {
                static_assert(std::is_same_v<S, FurtherShape>);
                place(further, shape, to_world, SurfaceKind::further, s);
            }
        },
        object.shape);
}

void Surfaces::add(const Object& object, std::uint8_t seen) {
    Surface s;
    s.seen = seen;
    s.inverse = object.inverse && !ignores_inverse(object.shape);
    if (!objects.empty()) s.first_primitive = objects.back().first_primitive + objects.back().count;
    add_shape(object, object.transform.value_or(Transform{}), s);
    index32(std::size_t{s.first_primitive} + s.count);
    objects.push_back(s);
}

}  // namespace rt
