#include "world/surfaces.h"

#include <algorithm>

#include "world/visit_shape.h"

namespace rt {

namespace {

template <typename S>
bool intersect_placed(const Placed<S>& placed, const Query& query, ShapeHit& hit) {
    if (!placed.moved) return intersect(placed.shape, query.ray, query.range, hit);
    return intersect(placed.shape, placed.to_world.inverse_ray(query.ray), query.range, hit);
}

template <typename S>
Vec3 normal_placed(const Placed<S>& placed, const Vec3& point, const ShapeHit& hit) {
    if (!placed.moved) return normal(placed.shape, point, hit);
    const Vec3 own_point = placed.to_world.inverse_point(point);
    if constexpr (std::is_same_v<S, FurtherShape>) return moved_normal(placed.shape, placed.to_world, own_point, hit);
    return placed.to_world.normal(normal(placed.shape, own_point, hit));
}

template <typename S>
Bounds bounds_placed(const Placed<S>& placed) {
    return placed.moved ? placed.to_world.bounds(bounds(placed.shape)) : bounds(placed.shape);
}

/// From the vertices, on POV-Ray's side.
Vec3 flat_normal(const Surfaces& all, const Surface& s, const Hit& hit) {
    const auto& f = all.faces[s.first + (hit.primitive - s.first_primitive)];
    const Vec3 n = cross(all.vertices[f[2]] - all.vertices[f[0]], all.vertices[f[1]] - all.vertices[f[0]]);
    return s.mirrored ? -n : n;
}

/// n / |n|, also where the square of the normal of a huge or tiny triangle leaves the range of doubles.
Vec3 in_range_unit(Vec3 n) {
    if (const double square = dot(n, n); !(square > 1e-200 && square < 1e200)) n /= std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    return unit(n);
}

Vec3 triangle_normal(const Surfaces& all, const Surface& s, const Hit& hit, const Vec3& point) {
    if (s.first_normals == Surface::flat) return flat_normal(all, s, hit);
    const auto& n = all.normal_faces[s.first_normals + (hit.primitive - s.first_primitive)];
    if (n[0] == Surface::flat) return flat_normal(all, s, hit);
    return normal(SmoothTriangle{{}, {}, {}, all.normals[n[0]], all.normals[n[1]], all.normals[n[2]]}, point, hit.shape);
}

/// Of a shape that is seldom: apart, so that all others ask nothing but their kind.
[[gnu::noinline]] Vec3 further_side(const Placed<FurtherShape>& placed, const Hit& hit, const Vec3& normal) {
    const auto* field = std::get_if<HeightField>(&placed.shape);
    return field && !field->normals->empty() ? in_range_unit(placed.to_world.normal(flat_normal(*field, hit.shape))) : normal;
}

}  // namespace

bool Surfaces::test_faces(const Surface& s, Query& query) const {
    const bool whole = s.kind == SurfaceKind::triangles;
    bool better = false;
    for (std::uint32_t face = s.first; face < s.first + s.count; ++face)
        better |= whole ? test_face(face, query) : test_part_face(face, query);
    return better;
}

bool Surfaces::test(std::uint32_t object, Query& query) const {
    const Surface& s = objects[object];
    if (!(s.seen & query.seen)) return false;
    if (s.kind >= SurfaceKind::further)
        return s.kind == SurfaceKind::further ? test_further(object, query)
               : s.kind == SurfaceKind::part  ? test_part(object, query)
                                              : test_faces(s, query);
    ShapeHit hit;
    const bool met = visit_shape(*this, s.kind, s.first, [&](const auto& shape) {
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return intersect_placed(shape, query, hit);
        else
            return intersect(shape, query.ray, query.range, hit);
    });
    return met && query.offer(hit, s.first_primitive, object);
}

/// Costly shapes search no farther than the best hit so far; one at the same distance still counts.
bool Surfaces::test_further(std::uint32_t object, Query& query) const {
    const Surface& s = objects[object];
    const Placed<FurtherShape>& placed = further[s.first];
    const Ray ray = placed.moved ? placed.to_world.inverse_ray(query.ray) : query.ray;
    ShapeHit hit;
    return intersect(placed.shape, ray, query.wanted(), hit) && query.offer(hit, s.first_primitive, object);
}

bool Surfaces::offer_plane(std::uint32_t face, Query& query) const {
    const Surface& s = objects[face_object[face]];
    if (!(s.seen & query.seen)) return false;
    const Face& f = faces[face];
    const Vec3& a = vertices[f[0]];
    const Vec3 ab = vertices[f[1]] - a;
    const Vec3 ac = vertices[f[2]] - a;
    const Vec3 n = cross(ab, ac);
    const double t = dot(n, a - query.ray.origin) / dot(n, query.ray.direction);
    if (!query.range.contains(t)) return false;
    const Vec3 p = query.ray.at(t) - a;
    const double square = dot(n, n);
    return query.offer({t, 0, dot(cross(p, ac), n) / square, dot(cross(ab, p), n) / square}, s.first_primitive + (face - s.first),
                       face_object[face]);
}

Vec3 Surfaces::flat_side(const Hit& hit, const Vec3& normal) const {
    const Surface& s = objects[hit.object];
    if (!s.is_triangles()) {
        const SurfaceKind kind = s.kind == SurfaceKind::part ? parts[s.part].kind : s.kind;
        return kind == SurfaceKind::further ? further_side(further[s.first], hit, normal) : normal;
    }
    return s.first_normals == Surface::flat ? normal : in_range_unit(flat_normal(*this, s, hit));
}

Vec3 Surfaces::normal(const Hit& hit, const Vec3& point) const {
    const Surface& s = objects[hit.object];
    Vec3 n;
    if (s.is_triangles()) {
        n = triangle_normal(*this, s, hit, point);
    } else {
        n = visit_shape(*this, s, [&](const auto& shape) {
            if constexpr (is_placed<std::decay_t<decltype(shape)>>)
                return normal_placed(shape, point, hit.shape);
            else
                return rt::normal(shape, point, hit.shape);
        });
    }
    n = in_range_unit(n);
    return s.inverse ? -n : n;
}

Bounds Surfaces::bounds(std::uint32_t object) const {
    const Surface& s = objects[object];
    if (s.kind == SurfaceKind::part || s.kind == SurfaceKind::part_triangles) return parts[s.part].box;
    return shape_bounds(object);
}

Bounds Surfaces::shape_bounds(std::uint32_t object) const {
    const Surface& s = objects[object];
    if (s.kind != SurfaceKind::triangles) {
        return visit_shape(*this, s, [](const auto& shape) {
            if constexpr (is_placed<std::decay_t<decltype(shape)>>)
                return bounds_placed(shape);
            else
                return rt::bounds(shape);
        });
    }
    Bounds box;
    // Comparisons, not fmin: the calls would be half of the time that an index takes to build. A NaN is passed over either way.
    for (std::uint32_t face = s.first; face < s.first + s.count; ++face) {
        for (const std::uint32_t vertex : faces[face]) {
            const Vec3& p = vertices[vertex];
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] < box.min[axis]) box.min[axis] = p[axis];
                if (p[axis] > box.max[axis]) box.max[axis] = p[axis];
            }
        }
    }
    return box;
}

bool Surfaces::met_from_inside(const Hit& hit, const Vec3& point, const Vec3& direction) const {
    const Surface& s = objects[hit.object];
    if (s.is_triangles() && s.of_mesh) return (dot(flat_normal(*this, s, hit), direction) > 0.0) != s.inverse;
    return dot(normal(hit, point), direction) > 0.0;
}

bool Surfaces::contains(std::uint32_t object, const Vec3& point) const {
    const std::uint32_t set = set_of(object);
    return set == Body::none ? shape_contains(object, point) : holds(set, point);
}

bool Surfaces::shape_contains(std::uint32_t object, const Vec3& point) const {
    const Surface& s = objects[object];
    if (s.is_triangles() || s.kind == SurfaceKind::polygon) return false;
    const bool in = visit_shape(*this, s, [&](const auto& shape) {
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return rt::contains(shape.shape, shape.moved ? shape.to_world.inverse_point(point) : point);
        else
            return rt::contains(shape, point);
    });
    return in != s.inverse;
}

}  // namespace rt
