#include "world/surfaces.h"

#include <algorithm>

namespace rt {

namespace {

template <typename S>
bool intersect_placed(const Placed<S>& placed, const Ray& ray, const Interval& range, ShapeHit& hit) {
    if (!placed.moved) return intersect(placed.shape, ray, range, hit);
    return intersect(placed.shape, placed.to_world.inverse_ray(ray), range, hit);
}

template <typename S>
Vec3 normal_placed(const Placed<S>& placed, const Vec3& point, const ShapeHit& hit) {
    if (!placed.moved) return normal(placed.shape, point, hit);
    return placed.to_world.normal(normal(placed.shape, placed.to_world.inverse_point(point), hit));
}

template <typename S>
Bounds bounds_placed(const Placed<S>& placed) {
    return placed.moved ? placed.to_world.bounds(bounds(placed.shape)) : bounds(placed.shape);
}

/// Calls `f` with the shape behind a surface that is not made of triangles.
template <typename F>
auto visit_shape(const Surfaces& all, const Surface& s, F f) {
    switch (s.kind) {
        case SurfaceKind::sphere:
            return f(all.spheres[s.first]);
        case SurfaceKind::plane:
            return f(all.planes[s.first]);
        case SurfaceKind::placed_sphere:
            return f(all.placed_spheres[s.first]);
        case SurfaceKind::box:
            return f(all.boxes[s.first]);
        case SurfaceKind::cone:
            return f(all.cones[s.first]);
        case SurfaceKind::torus:
            return f(all.toruses[s.first]);
        case SurfaceKind::disc:
            return f(all.discs[s.first]);
        case SurfaceKind::polygon:
            return f(all.polygons[s.first]);
        case SurfaceKind::further:
            return f(all.further[s.first]);
        case SurfaceKind::part:
            return visit_shape(all, all.part_bodies[s.first], f);
        case SurfaceKind::triangles:
            break;
    }
    throw std::logic_error("triangles are visited face by face");
}

template <typename T>
constexpr bool is_placed = false;
template <typename S>
constexpr bool is_placed<Placed<S>> = true;

/// How far from a surface its sides are, of the largest coordinate.
constexpr double relative_step = 0x1p-36;

/// `max_abs` for finite numbers, without calls.
double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool is_sheet(SurfaceKind kind) { return kind == SurfaceKind::triangles || kind == SurfaceKind::polygon; }

Bounds face_bounds(const Surfaces& all, const Surface& s) {
    Bounds box;
    // Comparisons, not fmin: the calls would be half of the time that an index takes to build. A NaN is passed over either way.
    for (std::uint32_t face = s.first; face < s.first + s.count; ++face) {
        for (const std::uint32_t vertex : all.faces[face]) {
            const Vec3& p = all.vertices[vertex];
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] < box.min[axis]) box.min[axis] = p[axis];
                if (p[axis] > box.max[axis]) box.max[axis] = p[axis];
            }
        }
    }
    return box;
}

/// Where a ray meets a part of a set that is not made of triangles.
bool meet(const Surfaces& all, const Surface& s, const Ray& ray, const Interval& range, ShapeHit& hit) {
    return visit_shape(all, s, [&](const auto& shape) {
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return intersect_placed(shape, ray, range, hit);
        else
            return intersect(shape, ray, range, hit);
    });
}

/// Whether the ray's line comes through the box at a distance that counts; true where rounding leaves it open. For a box with room.
bool passes(const Ray& ray, const Interval& range, const Bounds& box) {
    double enter = range.min, leave = range.max;
    for (int axis = 0; axis < 3; ++axis) {
        // Along the planes: infinities of one sign outside of them, of two signs between.
        const double inverse = 1.0 / ray.direction[axis];
        const double low = (box.min[axis] - ray.origin[axis]) * inverse, high = (box.max[axis] - ray.origin[axis]) * inverse;
        const double first = low < high ? low : high, last = low < high ? high : low;
        if (first > enter) enter = first;
        if (last < leave) leave = last;
    }
    return !(enter > leave);
}

/// Whether a point is in the shape itself, `inverse` or not. Where a side of a surface is asked for, the room that POV-Ray gives planes
/// would be wider than the step to it.
bool encloses(const Surfaces& all, const Surface& surface, const Vec3& point) {
    const Surface& s = all.body(surface);
    if (is_sheet(s.kind)) return false;
    if (s.kind == SurfaceKind::plane) return dot(point, all.planes[s.first].normal) < all.planes[s.first].distance;
    return visit_shape(all, s, [&](const auto& shape) {
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return rt::contains(shape.shape, shape.moved ? shape.to_world.inverse_point(point) : point);
        else
            return rt::contains(shape, point);
    });
}

Bounds shape_bounds(const Surfaces& all, const Surface& s) {
    if (s.kind == SurfaceKind::triangles) return face_bounds(all, s);
    return visit_shape(all, s, [](const auto& shape) {
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return bounds_placed(shape);
        else
            return bounds(shape);
    });
}

class SurfaceBodies final : public Bodies {
public:
    explicit SurfaceBodies(const Surfaces& all) : all_(all) {}
    bool contains(SetPart::What what, std::uint32_t index, const Vec3& point) const override {
        return encloses(all_, body(what, index), point);
    }
    Bounds bounds(SetPart::What what, std::uint32_t index) const override {
        const Surface& s = all_.body(body(what, index));
        if (is_sheet(s.kind)) return Bounds();  // has no inside
        return s.kind == SurfaceKind::disc ? Bounds::everything() : shape_bounds(all_, s);
    }

private:
    const Surface& body(SetPart::What what, std::uint32_t index) const {
        return what == SetPart::What::object ? all_.objects[index] : all_.clips[index];
    }
    const Surfaces& all_;
};

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

}  // namespace

bool Surfaces::test_faces(const Surface& s, Query& query) const {
    bool better = false;
    for (std::uint32_t face = s.first; face < s.first + s.count; ++face) better |= test_face(face, query);
    return better;
}

bool Surfaces::test(std::uint32_t object, Query& query) const {
    const Surface& s = objects[object];
    if (!(s.seen & query.seen)) return false;
    if (s.kind >= SurfaceKind::triangles) return s.kind == SurfaceKind::part ? test_part(object, query) : test_faces(s, query);
    ShapeHit hit;
    const bool met = visit_shape(*this, s, [&](const auto& shape) {
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return intersect_placed(shape, query.ray, query.range, hit);
        else
            return intersect(shape, query.ray, query.range, hit);
    });
    return met && query.offer(hit, s.first_primitive, object);
}

/// The hits of the shape one by one, until the set leaves one over.
bool Surfaces::test_part(std::uint32_t object, Query& query) const {
    const Surface& s = objects[object];
    Interval range = query.range;
    if (query.found) range.max = std::min(range.max, query.best.shape.t);
    if (!passes(query.ray, range, part_places[object].box)) return false;
    range.max = query.range.max;
    ShapeHit hit;
    const Surface& whole = body(s);
    while (meet(*this, whole, query.ray, range, hit) && !(query.found && hit.t > query.best.shape.t)) {
        if (keeps(object, hit, query.ray)) return query.offer(hit, s.first_primitive, object);
        range.min = hit.t;
    }
    return false;
}

bool Surfaces::keeps(std::uint32_t object, const ShapeHit& hit, const Ray& ray) const {
    const Surface& s = objects[object];
    const Vec3 point = ray.at(hit.t);
    const PartPlace& place = part_places[object];
    if (!rt::contains(place.box, point)) return false;
    SurfaceSides sides{point, point};
    if (!is_sheet(body(s).kind)) {
        const double extent = std::max({place.extent, largest(ray.origin), largest(point)});
        const Vec3 step = relative_step * extent * normal({hit, s.first_primitive, object}, point);
        sides = {point - step, point + step};
    }
    return sets.keeps(object, sides, SurfaceBodies(*this));
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
    const ShapeHit hit{t, 0, dot(cross(p, ac), n) / square, dot(cross(ab, p), n) / square};
    if (s.part && !keeps(face_object[face], hit, query.ray)) return false;
    return query.offer(hit, s.first_primitive + (face - s.first), face_object[face]);
}

Vec3 Surfaces::flat_side(const Hit& hit, const Vec3& normal) const {
    const Surface& s = objects[hit.object];
    if (s.kind != SurfaceKind::triangles || s.first_normals == Surface::flat) return normal;
    return in_range_unit(flat_normal(*this, s, hit));
}

Vec3 Surfaces::normal(const Hit& hit, const Vec3& point) const {
    const Surface& s = objects[hit.object];
    Vec3 n;
    if (s.kind == SurfaceKind::triangles) {
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
    const Bounds box = shape_bounds(*this, s);
    return s.part ? common(box, sets.visible_bounds(sets.node_of(object))) : box;
}

void Surfaces::join(const Scene& scene) {
    if (scene.sets.empty()) return;
    std::vector<bool> inverse, clip_inverse;
    for (const Object& object : scene.objects) inverse.push_back(object.inverse);
    for (const Object& clip : scene.clips) {
        add_clip(clip);
        clip_inverse.push_back(clip.inverse);
    }
    sets = SetTable(scene.sets, inverse, clip_inverse);
    sets.find_bounds(SurfaceBodies(*this));
    part_places.resize(objects.size());
    for (std::uint32_t object = 0; object < objects.size(); ++object) {
        Surface& s = objects[object];
        s.part = sets.node_of(object) != SetTable::none;
        if (!s.part) continue;
        s.inverse = sets.is_complement(object) && (s.of_mesh || !is_sheet(s.kind));
        if (s.kind != SurfaceKind::triangles) {
            part_bodies.push_back(s);
            s.kind = SurfaceKind::part;
            s.first = static_cast<std::uint32_t>(part_bodies.size() - 1);
        }
        const Bounds box = shape_bounds(*this, s);
        PartPlace& place = part_places[object];
        if (box.is_finite()) place.extent = std::fmax(max_abs(box.min), max_abs(box.max));
        place.box = bounds(object);
        const Vec3 room(place.box.is_finite() ? 2.0 * relative_step * std::fmax(max_abs(place.box.min), max_abs(place.box.max)) : 0.0);
        place.box = {place.box.min - room, place.box.max + room};
    }
}

bool Surfaces::met_from_inside(const Hit& hit, const Vec3& point, const Vec3& direction) const {
    const Surface& s = objects[hit.object];
    if (s.kind == SurfaceKind::triangles && s.of_mesh) return (dot(flat_normal(*this, s, hit), direction) > 0.0) != s.inverse;
    return dot(normal(hit, point), direction) > 0.0;
}

bool Surfaces::contains(std::uint32_t object, const Vec3& point) const {
    const Surface& s = objects[object];
    const Surface& whole = body(s);
    const bool in = whole.kind == SurfaceKind::plane ? rt::contains(planes[whole.first], point) : encloses(*this, s, point);
    if (is_sheet(whole.kind) || in == s.inverse) return false;
    return !s.part || sets.surrounds(object, point, SurfaceBodies(*this));
}

}  // namespace rt
