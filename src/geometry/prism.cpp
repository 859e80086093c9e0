#include "geometry/prism.h"

namespace rt {

namespace {

Vec2 in_plane(const Vec3& v) { return {v.x, v.z}; }

// The ray and the tip span a plane: at y = 1 it is a line, and walls are met where that line crosses the outline. The point of the wall
// over p is y (p.x, 1, p.y).
void find_conic_walls(const Prism& shape, const Ray& ray, HitSink& sink) {
    const Vec3& d = ray.direction;
    const double shift = -dot(ray.origin, d) / dot(d, d);
    const Vec3 o = ray.origin + shift * d;
    const Vec3 plane = cross(o, d);
    const Outline& outline = *shape.outline;
    for (std::size_t i = 0; i < outline.pieces.size(); ++i) {
        const CurvePiece& piece = outline.pieces[i];
        const Crossings found = crossings(piece, in_plane(plane), -plane.y);
        for (std::size_t k = 0; k < found.count; ++k) {
            const Vec2 p = piece.at(found.u[k]);
            const Vec3 edge(p.x, 1.0, p.y);
            const Vec3 across = cross(d, edge);
            const double t = -dot(cross(o, edge), across) / dot(across, across);
            const double y = o.y + t * d.y;
            if (y >= shape.low && y <= shape.high) sink.offer({.t = shift + t, .part = static_cast<std::uint32_t>(2 + i), .u = found.u[k]});
        }
    }
}

void find_conic_ends(const Prism& shape, const Ray& ray, HitSink& sink) {
    for (std::uint32_t end = 0; end < 2; ++end) {
        const double y = end == 0 ? shape.low : shape.high;
        const double t = (y - ray.origin.y) / ray.direction.y;
        if (y == 0.0 || !(t > sink.after() && t < sink.before())) continue;
        if (shape.outline->contains(in_plane(ray.at(t)) / y)) sink.offer({.t = t, .part = end});
    }
}

}  // namespace

void find_hits(const Prism& shape, const Ray& ray, HitSink& sink) {
    if (!shape.conic) {
        const SweepRay across{in_plane(ray.origin), in_plane(ray.direction), ray.origin.y, ray.direction.y};
        find_hits(Sweep{*shape.outline, shape.low, shape.high, shape.open}, across, sink);
        return;
    }
    if (!shape.open && ray.direction.y != 0.0) find_conic_ends(shape, ray, sink);
    find_conic_walls(shape, ray, sink);
}

Vec3 normal(const Prism& shape, const Vec3& point, const ShapeHit& hit) {
    if (hit.part < 2) return {0.0, hit.part == 0 ? -1.0 : 1.0, 0.0};
    const CurvePiece& piece = shape.outline->pieces[hit.part - 2];
    const Vec2 along = piece.tangent(hit.u);
    if (!shape.conic) return {along.y, 0.0, -along.x};
    const Vec2 p = piece.at(hit.u);
    const Vec3 right = cross(Vec3(p.x, 1.0, p.y), Vec3(along.x, 0.0, along.y));
    return point.y < 0.0 ? -right : right;
}

bool contains(const Prism& shape, const Vec3& point) {
    if (!(point.y > shape.low && point.y < shape.high)) return false;
    return shape.outline->contains(shape.conic ? in_plane(point) / point.y : in_plane(point));
}

Bounds bounds(const Prism& shape) {
    const Outline& outline = *shape.outline;
    Bounds box;
    for (const double y : {shape.low, shape.high}) {
        const double wide = shape.conic ? y : 1.0;
        box.extend(Vec3(wide * outline.min.x, y, wide * outline.min.y));
        box.extend(Vec3(wide * outline.max.x, y, wide * outline.max.y));
    }
    if (shape.conic && shape.low < 0.0 && shape.high > 0.0) box.extend(Vec3(0.0));
    return rounded_outward(box);
}

}  // namespace rt
