// What of a surface counts that is part of a set.
//
// A part's surface is where the whole set begins or ends if on its inner side a ray is inside of everything that an intersection asks for,
// and on its outer side outside of everything that a merge leaves out. Both sides are asked a little way along the ray, beyond what the
// hit can be wrong by: so surfaces that coincide are told apart by which side of them is the inner one, and no rounding speckles them.
// Where two have it on the same side, the one stated first counts.

#include "geometry/hits.h"
#include "world/surfaces.h"
#include "world/visit_shape.h"

namespace rt {

namespace {

/// What a hit can be wrong by, with a hundred times of what `hit_error` allows to spare.
double slack(const Part& part, const Ray& ray, double t) {
    constexpr double relative = 0x1p-40, of_place = 0x1p-44, far = 4.0;
    const double lengths = max_abs(ray.origin) + std::fabs(t) + part.extent;
    return relative * std::fmin(lengths, far * part.size) + of_place * lengths;
}

/// How far along the ray a hit's sides are: farther where it grazes the surface. Thinner pieces are not seen.
double side_distance(double slack, double cos) {
    constexpr double least_cos = 0x1p-20;
    return slack / std::fmax(std::fabs(cos), least_cos);
}

/// Calls `visit` with the part's hits and their unit normals, nearest first, until it returns true; true if it did. Not for triangles.
template <typename Visit>
bool visit_part(const Surfaces& all, std::uint32_t object, const Ray& ray, const Interval& range, Visit visit) {
    const Surface& s = all.objects[object];
    return visit_shape(all, s, [&](const auto& shape) {
        const auto with_normal = [&](const ShapeHit& hit) {
            return visit(hit, all.normal({hit, s.first_primitive, object}, ray.at(hit.t)));
        };
        if constexpr (is_placed<std::decay_t<decltype(shape)>>)
            return visit_hits(shape.shape, shape.moved ? shape.to_world.inverse_ray(ray) : ray, range, with_normal);
        else
            return visit_hits(shape, ray, range, with_normal);
    });
}

}  // namespace

bool Surfaces::test_part(std::uint32_t object, Query& query) const {
    const Surface& s = objects[object];
    const Part& part = parts[s.part];
    if (part.gated && !passes(part.body, query.ray)) return false;
    bool better = false;
    visit_part(*this, object, query.ray, query.wanted(), [&](const ShapeHit& hit, const Vec3& normal) {
        if (!counts(part, query, hit.t, normal)) return false;
        better = query.offer(hit, s.first_primitive, object);
        return true;
    });
    return better;
}

bool Surfaces::test_part_face(std::uint32_t face, Query& query) const {
    const Face& f = faces[face];
    ShapeHit hit;
    if (!intersect(vertices[f[0]], vertices[f[1]], vertices[f[2]], query.sheared(), query.range, hit)) return false;
    const std::uint32_t object = face_object[face];
    const Surface& s = objects[object];
    const Hit met{hit, s.first_primitive + (face - s.first), object};
    if (parts[s.part].gated && !passes(parts[s.part].body, query.ray)) return false;
    const Vec3 n = flat_side(met, normal(met, query.ray.at(hit.t)));
    return counts(parts[s.part], query, hit.t, n) && query.offer(hit, met.primitive, object);
}

/// Whether the hit at t of a part's surface, whose unit normal points out of it, is the set's.
bool Surfaces::counts(const Part& part, const Query& query, double t, const Vec3& normal) const {
    if (!part.cut) return true;
    double aside = 0.0;
    return bounds_set(part, query.ray, t, normal, aside) && (part.sheet || stands_for_itself(part.body, query, t, aside));
}

/// The same, were it the only surface there. `aside` becomes the way from the hit to its outer side.
bool Surfaces::bounds_set(const Part& part, const Ray& ray, double t, const Vec3& normal, double& aside) const {
    if (!rt::contains(part.box, ray.at(t))) return false;
    const double cos = dot(normal, ray.direction);
    const double error = slack(part, ray, t);
    aside = std::copysign(side_distance(error, cos), cos);
    const Vec3 inner = ray.at(t - aside), outer = ray.at(t + aside);
    if (part.sheet) return fits(part.body, inner, inner) || fits(part.body, outer, outer);
    return fits(part.body, inner, outer) && !is_touch(bodies[part.body].object, ray, t, aside, error);
}

/// Whether the ray only touches the shape at t, as at an edge: it is outside on both sides. Beside a hit of one face another one that the
/// ray grazes may be too near to tell, so that is asked farther away as well.
bool Surfaces::is_touch(std::uint32_t object, const Ray& ray, double t, double aside, double error) const {
    // The hits of an isosurface are an accuracy away from where its inside ends, which is far, and it touches nothing.
    if (const Surface& s = objects[object];
        parts[s.part].kind == SurfaceKind::further && std::holds_alternative<Isosurface>(further[s.first].shape))
        return false;
    const bool outside = objects[object].inverse;
    for (const double step : {aside, 0x1p10 * aside, 0x1p20 * aside})
        if (body_contains(object, ray.at(t - step)) != outside || body_contains(object, ray.at(t + step)) != outside) return false;
    const double near = std::fabs(aside);
    const auto any = [](const ShapeHit&, const Vec3&) { return true; };
    return !visit_part(*this, object, ray, {t - near, t - error}, any) && !visit_part(*this, object, ray, {t + error, t + near}, any);
}

/// Whether everything that the body is set against holds at the points on its two sides.
bool Surfaces::fits(std::uint32_t body, const Vec3& inner, const Vec3& outer) const {
    for (std::uint32_t whole = bodies[body].parent; whole != Body::none; body = whole, whole = bodies[whole].parent) {
        const SetNode::Kind kind = bodies[whole].kind;
        if (kind == SetNode::Kind::any || kind == SetNode::Kind::bounded) continue;
        const bool all = kind == SetNode::Kind::all;
        for (std::uint32_t other = whole + 1; other < bodies[whole].end; other = bodies[other].end)
            if (other != body && holds(other, all ? inner : outer) != all) return false;
    }
    return true;
}

/// Whether no surface that was stated before coincides with this one, `aside` before it or behind it. Where several do, the first one has
/// none before it, so that one of them is left.
bool Surfaces::stands_for_itself(std::uint32_t body, const Query& query, double t, double aside) const {
    const Vec3 inner = query.ray.at(t - aside), outer = query.ray.at(t + aside);
    const Interval near{t - std::fabs(aside), t + std::fabs(aside)};
    for (std::uint32_t whole = bodies[body].parent; whole != Body::none; body = whole, whole = bodies[whole].parent) {
        const SetNode::Kind kind = bodies[whole].kind;
        if (kind == SetNode::Kind::any || kind == SetNode::Kind::bounded) continue;
        const bool all = kind == SetNode::Kind::all;
        for (std::uint32_t before = whole + 1; before < body; before = bodies[before].end)
            if (holds(before, all ? outer : inner) != all && has_boundary(before, query, near)) return false;
    }
    return true;
}

/// Whether a surface of the body would bound the set inside the range.
bool Surfaces::has_boundary(std::uint32_t body, const Query& query, const Interval& range) const {
    for (std::uint32_t at = body; at < bodies[body].end; ++at) {
        const std::uint32_t object = bodies[at].object;
        if (bodies[at].kind != SetNode::Kind::surface || objects[object].is_triangles() || !(objects[object].seen & query.seen)) continue;
        const Part& part = parts[objects[object].part];
        if (part.gated && !passes(part.body, query.ray)) continue;
        double aside = 0.0;
        if (visit_part(*this, object, query.ray, range,
                       [&](const ShapeHit& hit, const Vec3& normal) { return bounds_set(part, query.ray, hit.t, normal, aside); }))
            return true;
    }
    return false;
}

bool Surfaces::holds(std::uint32_t body, const Vec3& point) const {
    const Body& b = bodies[body];
    if (b.kind == SetNode::Kind::surface || b.kind == SetNode::Kind::solid) {
        // Far from an inverse shape is inside of it.
        return rt::contains(b.box, point) ? body_contains(b.object, point) : objects[b.object].inverse;
    }
    if (!rt::contains(b.box, point)) return false;
    if (b.kind == SetNode::Kind::bounded) return holds(body + 1, point);
    const bool any = b.kind != SetNode::Kind::all;
    for (std::uint32_t part = body + 1; part < b.end; part = bodies[part].end)
        if (holds(part, point) == any) return any;
    return !any;
}

/// Without the tolerance that a plane has for a camera that stands in it: a ray along it would be inside for long.
bool Surfaces::body_contains(std::uint32_t object, const Vec3& point) const {
    const Surface& s = objects[object];
    if (s.kind != SurfaceKind::plane && !(s.kind == SurfaceKind::part && parts[s.part].kind == SurfaceKind::plane))
        return shape_contains(object, point);
    const Plane& plane = planes[s.first];
    return (dot(point, plane.normal) < plane.distance) != s.inverse;
}

std::uint32_t Surfaces::set_of(std::uint32_t object) const {
    const Surface& s = objects[object];
    if (s.kind != SurfaceKind::part && s.kind != SurfaceKind::part_triangles) return Body::none;
    // What is only bounded, or in a union, stands for itself.
    std::uint32_t set = Body::none;
    for (std::uint32_t body = bodies[parts[s.part].body].parent; body != Body::none; body = bodies[body].parent)
        if (bodies[body].kind == SetNode::Kind::all || bodies[body].kind == SetNode::Kind::merged) set = body;
    return set;
}

}  // namespace rt
