// Sets of objects into the trees of `Surfaces`.

#include "world/local_frame.h"
#include "world/surfaces.h"

namespace rt {

namespace {

double longest_side(const Bounds& b) { return max_component(b.max - b.min); }

Object unseen(const Solid& solid) {
    Object object;
    object.shape = solid.shape;
    object.transform = solid.transform;
    object.inverse = solid.inverse;
    return object;
}

/// Whether the body is what another one is bounded by.
bool is_bound(const std::vector<Body>& bodies, std::size_t at) {
    const std::uint32_t parent = bodies[at].parent;
    return parent != Body::none && bodies[parent].kind == SetNode::Kind::bounded && at != parent + 1;
}

bool reaches_out(const Bounds& box, const Bounds& of) { return !contains(of, box.min) || !contains(of, box.max); }

}  // namespace

void Surfaces::add_set(const ObjectSet& set, bool few) {
    const auto first_solid = static_cast<std::uint32_t>(objects.size());
    for (const Solid& solid : set.solids) {
        add(unseen(solid), 0);
        objects.back().count = 0;
    }
    const std::size_t first = bodies.size();
    add_bodies(set, first_solid);
    add_gates(set, static_cast<std::uint32_t>(first), few);

    double extent = 0.0;
    for (std::size_t i = first; i < bodies.size(); ++i) {
        if (is_bound(bodies, i))
            i = bodies[i].end - 1;
        else if (const Bounds& box = bodies[i].box; box.is_finite())
            extent = std::fmax(extent, std::fmax(max_abs(box.min), max_abs(box.max)));
    }
    LateBody outside{bodies[first].gate, {}};
    for (std::size_t i = first; i < bodies.size(); ++i)
        if (bodies[i].kind == SetNode::Kind::surface && make_part(static_cast<std::uint32_t>(i), extent) && !few)
            outside.objects.push_back(bodies[i].object);
    if (!outside.objects.empty()) late.push_back(std::move(outside));
}

MaskRange Surfaces::add_mask(const Mask& mask) {
    const MaskRange range{static_cast<std::uint32_t>(objects.size()), static_cast<std::uint32_t>(mask.surfaces.size())};
    for (const Solid& surface : mask.surfaces) add(unseen(surface), seen_by::masked_light);
    for (ObjectSet set : mask.sets) {
        set.first_object += range.first;
        add_set(set);
    }
    return range;
}

/// Whether the box around a surface is around what is inside as well: not of a disc, whose whole half space counts, nor of a field.
bool Surfaces::holds_its_inside(std::uint32_t object) const {
    const Surface& s = objects[object];
    if (s.kind == SurfaceKind::further) return bounds_hold_inside(further[s.first].shape);
    return s.kind != SurfaceKind::disc;
}

/// The nodes with their parents and the boxes around them; a box around shapes that are inverse is unbounded but for the shape's own.
void Surfaces::add_bodies(const ObjectSet& set, std::uint32_t first_solid) {
    const std::size_t first = bodies.size();
    std::vector<std::uint32_t> open;
    for (const SetNode& node : set.nodes) {
        const auto at = static_cast<std::uint32_t>(bodies.size());
        while (!open.empty() && bodies[open.back()].end <= at) open.pop_back();
        Body body;
        body.kind = node.kind;
        body.parent = open.empty() ? Body::none : open.back();
        body.end = at + node.size;
        body.medium = node.medium;
        body.inverse = node.inverse;
        body.clips = node.clips;
        body.cuts = node.cuts;
        body.texture = node.texture;
        if (node.kind == SetNode::Kind::surface || node.kind == SetNode::Kind::solid) {
            body.object = (node.kind == SetNode::Kind::surface ? set.first_object : first_solid) + node.index;
            body.box = holds_its_inside(body.object) ? shape_bounds(body.object) : Bounds::everything();
        } else {
            body.box = node.kind == SetNode::Kind::all ? Bounds::everything() : Bounds{};
            open.push_back(at);
        }
        bodies.push_back(body);
    }
    for (std::size_t i = bodies.size(); i-- > first;) {
        const Body& body = bodies[i];
        if (body.parent == Body::none || is_bound(bodies, i)) continue;
        Bounds& whole = bodies[body.parent].box;
        const Bounds box = around(static_cast<std::uint32_t>(i));
        if (bodies[body.parent].kind == SetNode::Kind::all)
            whole = common(whole, box);
        else
            whole.extend(box);
    }
}

/// Box around all points that a body contains.
Bounds Surfaces::around(std::uint32_t body) const {
    const Body& b = bodies[body];
    const bool shape = b.kind == SetNode::Kind::surface || b.kind == SetNode::Kind::solid;
    return shape && objects[b.object].inverse ? Bounds::everything() : b.box;
}

/// A surface that nothing cuts and every ray comes to stays what it is. True if it reaches out of the gate of the whole set.
bool Surfaces::make_part(std::uint32_t body, double extent) {
    Surface& s = objects[bodies[body].object];
    Part part;
    part.kind = s.kind;
    part.sheet = s.is_triangles() || s.kind == SurfaceKind::polygon;
    part.body = body;
    part.extent = extent;
    part.box = shape_bounds(bodies[body].object);
    for (std::uint32_t whole = bodies[body].parent; whole != Body::none; whole = bodies[whole].parent) {
        part.box = common(part.box, bodies[whole].box);
        part.cut |= bodies[whole].kind == SetNode::Kind::all || bodies[whole].kind == SetNode::Kind::merged;
    }
    bool outside = false;
    for (std::uint32_t whole = bodies[body].parent; whole != Body::none && !part.box.is_empty(); whole = bodies[whole].parent) {
        outside = reaches_out(part.box, bodies[whole].gate);
        part.gated |= outside || (bodies[whole].bounds_count && !within_bounds(whole, part.box));
    }
    if (!part.cut && !part.gated) return false;
    // A hit may lie outside by as much as it may be wrong.
    constexpr double margin = 0x1p-18;
    if (part.box.is_empty()) s.count = 0;
    if (part.box.is_finite()) {
        part.size = longest_side(part.box);
        part.box = grown(part.box, margin * part.size + 0x1p-40 * extent);
    }
    s.kind = s.is_triangles() ? SurfaceKind::part_triangles : SurfaceKind::part;
    s.part = static_cast<std::uint32_t>(parts.size());
    parts.push_back(part);
    return outside;
}

}  // namespace rt
