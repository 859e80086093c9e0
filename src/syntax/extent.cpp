#include "syntax/extent.h"

#include "syntax/quadric_box.h"
#include "syntax/shape_box.h"

namespace rt {

namespace {

/// The half space of a plane that stands across an axis, as a box.
Bounds half_space(const Plane& plane, const std::optional<Transform>& t, bool inverted) {
    Vec3 normal = t ? unit(t->normal(plane.normal)) : plane.normal;
    double distance = t ? dot(t->point(plane.distance * plane.normal), normal) : plane.distance;
    if (inverted) normal = -normal, distance = -distance;
    Bounds box = Bounds::everything();
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(normal[i]) < 1.0 - 1e-12) continue;
        (normal[i] > 0.0 ? box.max[i] : box.min[i]) = normal[i] > 0.0 ? distance : -distance;
    }
    return box;
}

const Quadric* as_quadric(const Shape& shape) {
    const auto* further = std::get_if<FurtherShape>(&shape);
    return further ? std::get_if<Quadric>(further) : nullptr;
}

double volume(const Bounds& box) {
    const Vec3 sides = box.max - box.min;
    return sides.x * sides.y * sides.z;
}

}  // namespace

Extent extent_around(const Bounds& box) {
    Extent extent;
    for (int i = 0; i < 3; ++i)
        if (!(box.min[i] <= box.max[i] && box.min[i] > -Extent::far && box.max[i] < Extent::far)) return extent;
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        extent.lower[axis] = static_cast<float>(box.min[i]);
        extent.size[axis] = static_cast<float>(box.max[i] - box.min[i]);
    }
    return extent;
}

Extent moved(const Extent& extent, const Transform& t) {
    return extent.is_finite() ? extent_around(around_moved(extent.bounds(), t.linear, t.offset)) : extent;
}

bool keeps_its_extent(const Shape& shape) {
    const auto* further = std::get_if<FurtherShape>(&shape);
    if (!further) return std::holds_alternative<Mesh>(shape);
    return std::holds_alternative<Quadric>(*further) || std::holds_alternative<Blob>(*further) || std::holds_alternative<Text>(*further);
}

Extent extent_of(const Shape& shape, const std::optional<Transform>& transform) { return extent_around(shape_box(shape, transform)); }

Extent clipped_extent(const Shape& shape, const std::optional<Transform>& transform, const Bounds& clip) {
    const Quadric* quadric = as_quadric(shape);
    return extent_around(quadric ? cut_to(transform ? moved(*quadric, *transform) : *quadric, clip) : clip);
}

Extent smaller(const Extent& a, const Extent& b) { return volume(b.bounds()) < volume(a.bounds()) ? b : a; }

void SetExtent::add(const Extent& part, bool inverted) {
    if (!cuts_)
        box_.extend(part.bounds());
    else if (!inverted && part.is_finite())
        box_ = common(box_, part.bounds());
}

void SetExtent::add(const Shape& shape, const std::optional<Transform>& transform, const std::optional<Extent>& own, bool inverted) {
    if (const auto* plane = std::get_if<Plane>(&shape); plane && cuts_)
        box_ = common(box_, half_space(*plane, transform, inverted));
    else if (const Quadric* quadric = as_quadric(shape); quadric && cuts_ && !inverted)
        quadrics_.push_back(transform ? moved(*quadric, *transform) : *quadric);
    else
        add(own ? *own : extent_of(shape, transform), inverted);
}

Bounds SetExtent::box() const {
    Bounds box = box_;
    for (const Quadric& quadric : quadrics_) box = cut_to(quadric, box);
    return box;
}

Bounds box_around(const ObjectSet& bodies) {
    // Trees that stand one after the other have to hold all. A set is done where its nodes end.
    struct Open {
        SetExtent box;
        std::size_t end;
    };
    std::vector<Open> open{{SetExtent(true), bodies.nodes.size()}};
    const auto close_ended = [&](std::size_t at) {
        while (open.size() > 1 && open.back().end <= at) {
            const Extent done = extent_around(open.back().box.box());
            open.pop_back();
            open.back().box.add(done, false);
        }
    };
    for (std::size_t i = 0; i < bodies.nodes.size(); ++i) {
        close_ended(i);
        const SetNode& node = bodies.nodes[i];
        if (node.kind == SetNode::Kind::solid) {
            const Solid& solid = bodies.solids[node.index];
            open.back().box.add(solid.shape, solid.transform, std::nullopt, solid.inverse);
        } else if (node.kind != SetNode::Kind::surface) {
            open.push_back({SetExtent(node.kind == SetNode::Kind::all), i + node.size});
        }
    }
    close_ended(bodies.nodes.size());
    return open.front().box.box();
}

}  // namespace rt
