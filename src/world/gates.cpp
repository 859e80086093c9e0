// What a ray has to meet before it meets a body: POV-Ray's box around it, and what it is `bounded_by`.
//
// POV-Ray asks a body only for rays that meet these, wherever the body's surface is met then. Its box is that of the shapes: of an
// intersection what the boxes of its parts have in common, of a disc that of the flat square around it although all behind it is its
// inside; a height field, whose inside has no floor, has none. Bounds take the box's place if their own is smaller. A shape that has a box
// needs no bounds itself, so of them only theirs is left.

#include <algorithm>

#include "geometry/hits.h"
#include "world/local_frame.h"
#include "world/surfaces.h"
#include "world/visit_shape.h"

namespace rt {

namespace {

bool is_shape(const Body& body) { return body.kind == SetNode::Kind::surface || body.kind == SetNode::Kind::solid; }

double volume(const Bounds& box) {
    const Vec3 side = box.max - box.min;
    return side.x * side.y * side.z;
}

/// Of a shape's own box and that of its bounds the one that POV-Ray takes.
Bounds smaller(const Bounds& own, const Bounds& of_bounds) { return volume(of_bounds) < volume(own) ? of_bounds : own; }

/// Around the square around the disc, which is turned from the plane z = 0 by the shortest way.
Bounds square_bounds(const Placed<Disc>& placed) {
    const Disc& disc = placed.shape;
    const Vec3& n = disc.normal;
    Vec3 right(1, 0, 0), up(0, 1, 0);
    if (n.z > -1.0) {
        right -= n.x / (1.0 + n.z) * (n + Vec3(0, 0, 1));
        up -= n.y / (1.0 + n.z) * (n + Vec3(0, 0, 1));
    }
    Bounds box;
    for (const double a : {-disc.radius, disc.radius})
        for (const double b : {-disc.radius, disc.radius}) {
            const Vec3 corner = disc.center + a * right + b * up;
            box.extend(placed.moved ? placed.to_world.point(corner) : corner);
        }
    return box;
}

/// Shapes whose boxes POV-Ray does not ask for where it asks every object.
bool is_asked_without_box(const Surface& s, const Surfaces& all) {
    switch (s.kind) {
        case SurfaceKind::cone:
        case SurfaceKind::torus:
            return false;
        case SurfaceKind::further:
            return std::holds_alternative<Blob>(all.further[s.first].shape);
        default:
            return true;
    }
}

}  // namespace

Bounds Surfaces::shape_gate(std::uint32_t object) const {
    const Surface& s = objects[object];
    if (s.kind == SurfaceKind::disc) return square_bounds(discs[s.first]);
    return holds_its_inside(object) ? shape_bounds(object) : Bounds::everything();
}

/// From the gates of its parts.
Bounds Surfaces::gate_of(std::uint32_t body) const {
    const Body& b = bodies[body];
    if (is_shape(b)) return objects[b.object].inverse ? Bounds::everything() : shape_gate(b.object);
    const std::uint32_t first = body + 1;
    if (first == b.end) return b.box;
    if (b.inverse) return Bounds::everything();
    if (b.kind == SetNode::Kind::bounded) return smaller(bodies[first].gate, gate_of_bounds(body));
    Bounds gate = bodies[first].gate;
    for (std::uint32_t part = bodies[first].end; part < b.end; part = bodies[part].end) {
        if (b.kind == SetNode::Kind::all)
            gate = common(gate, bodies[part].gate);
        else
            gate.extend(bodies[part].gate);
    }
    return gate;
}

Bounds Surfaces::gate_of_bounds(std::uint32_t bounded) const {
    Bounds gate = Bounds::everything();
    for (std::uint32_t bound = bodies[bounded + 1].end; bound < bodies[bounded].end; bound = bodies[bound].end)
        gate = common(gate, bodies[bound].gate);
    return gate;
}

/// Only the box of the whole is ever asked for, the bounds of every part.
void Surfaces::add_gates(const ObjectSet& set, std::uint32_t root, bool few) {
    for (auto body = static_cast<std::uint32_t>(bodies.size()); body-- > root;) {
        bodies[body].gate = gate_of(body);
        bodies[body].bounds_count = bodies[body].kind == SetNode::Kind::bounded;
    }
    Body& whole = bodies[root];
    if (whole.inverse && is_shape(bodies[root + 1])) whole.gate = smaller(shape_gate(bodies[root + 1].object), gate_of_bounds(root));
    for (std::size_t part = root + 1; part < bodies.size(); ++part) bodies[part].gate = Bounds::everything();
    if (whole.kind != SetNode::Kind::bounded) return;
    const Body& inner = bodies[root + (set.nodes[1].clips ? 2 : 1)];
    if (!is_shape(inner)) return;
    const Surface& s = objects[inner.object];
    if (s.kind == SurfaceKind::further && keeps_bounds(further[s.first].shape)) return;
    whole.bounds_count = false;
    if (few && is_asked_without_box(s, *this)) whole.gate = Bounds::everything();
}

/// Whether everything in the box is surely inside of all that the body is bounded by, but for rounding. Bounds that are not convex are
/// never sure.
bool Surfaces::within_bounds(std::uint32_t bounded, const Bounds& box) const {
    if (!box.is_finite()) return false;
    constexpr double less = 1.0 - 0x1p-20;
    const Vec3 centre = 0.5 * (box.min + box.max), half = less * 0.5 * (box.max - box.min);
    for (std::uint32_t bound = bodies[bounded + 1].end; bound < bodies[bounded].end; bound = bodies[bound].end)
        for (int i = 0; i < 8; ++i)
            if (!within(bound, centre + half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1))) return false;
    return true;
}

/// Whether the corner is inside a body that is surely convex.
bool Surfaces::within(std::uint32_t body, const Vec3& corner) const {
    const Body& b = bodies[body];
    if (b.kind == SetNode::Kind::all) {
        for (std::uint32_t part = body + 1; part < b.end; part = bodies[part].end)
            if (!within(part, corner)) return false;
        return true;
    }
    if (!is_shape(b)) return false;
    const Surface& s = objects[b.object];
    switch (s.kind) {
        case SurfaceKind::plane:
            return shape_contains(b.object, corner);
        case SurfaceKind::sphere:
        case SurfaceKind::placed_sphere:
        case SurfaceKind::box:
        case SurfaceKind::cone:
            return !s.inverse && shape_contains(b.object, corner);
        default:
            return false;
    }
}

/// Whether the ray meets the box of the whole set and the bounds of everything that the body is a part of.
bool Surfaces::passes(std::uint32_t body, const Ray& ray) const {
    for (std::uint32_t whole = bodies[body].parent; whole != Body::none; whole = bodies[whole].parent) {
        const Body& w = bodies[whole];
        if (Interval inside; !clip(ray, w.gate, inside)) return false;
        if (!w.bounds_count) continue;
        for (std::uint32_t bound = bodies[whole + 1].end; bound < w.end; bound = bodies[bound].end)
            if (!meets(bound, ray)) return false;
    }
    return true;
}

/// Whether some of the ray from its origin on is inside the body.
bool Surfaces::meets(std::uint32_t body, const Ray& ray) const {
    if (holds(body, ray.origin)) return true;
    std::vector<double> crossings;
    for (std::uint32_t at = body; at < bodies[body].end; ++at) {
        if (!is_shape(bodies[at])) continue;
        visit_shape(*this, objects[bodies[at].object], [&](const auto& shape) {
            const auto add = [&](const ShapeHit& hit) {
                crossings.push_back(hit.t);
                return false;
            };
            if constexpr (is_placed<std::decay_t<decltype(shape)>>)
                return visit_hits(shape.shape, shape.moved ? shape.to_world.inverse_ray(ray) : ray, {}, add);
            else
                return visit_hits(shape, ray, {}, add);
        });
    }
    if (is_shape(bodies[body])) return !crossings.empty();
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const double next = i + 1 < crossings.size() ? crossings[i + 1] : 2.0 * crossings[i] + 1.0;
        if (holds(body, ray.at(0.5 * (crossings[i] + next)))) return true;
    }
    return false;
}

}  // namespace rt
