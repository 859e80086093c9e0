#include "geometry/polygon.h"

#include "geometry/triangle.h"

namespace rt {

namespace {

/// Calls visit(from, to) for every edge of every contour; the last contour is closed if its points do not.
template <typename Visit>
void for_each_edge(const std::vector<Vec3>& points, Visit visit) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        visit(first, points[i - 1], points[i]);
        if (points[i] == points[first]) first = ++i;
    }
    if (first + 1 < points.size() && points.back() != points[first]) visit(first, points.back(), points[first]);
}

/// Across the plane of the points, from the largest triangle that the first one spans with two neighbours. An outline that crosses itself
/// may enclose as much on one side as on the other, so that no area could tell.
Vec3 plane_normal(const std::vector<Vec3>& points) {
    Vec3 largest(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec3 candidate = cross(points[i] - points[0], points[i + 1] - points[0]);
        if (dot(candidate, candidate) > dot(largest, largest)) largest = candidate;
    }
    return largest;
}

/// Even-odd rule in the plane that the shear of the watertight triangle test takes the outline to, by a walk towards +x. An edge owns its
/// lower end and not its upper one, so a walk through a vertex counts it once; the side of an edge has the same answer for every polygon
/// that has this edge, whichever way it is run through.
bool contains(const std::vector<Vec3>& points, const TriangleRay& ray) {
    const auto sheared = [&](const Vec3& point) {
        const Vec3 p = point - ray.origin;
        const double z = (&p.x)[ray.kz];
        return Vec2((&p.x)[ray.kx] - ray.sx * z, (&p.x)[ray.ky] - ray.sy * z);
    };
    bool inside = false;
    for_each_edge(points, [&](std::size_t, const Vec3& from_point, const Vec3& to_point) {
        const Vec2 from = sheared(from_point), to = sheared(to_point);
        if ((from.y > 0.0) == (to.y > 0.0)) return;
        double turn = from.x * to.y - from.y * to.x;
        if (turn == 0.0) turn = difference_of_products(from.x, to.y, from.y, to.x);
        if (to.y > 0.0 ? turn > 0.0 : turn < 0.0) inside = !inside;
    });
    return inside;
}

}  // namespace

bool intersect(const Polygon& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    if (shape.points.size() < 3) return false;
    const Vec3 n = plane_normal(shape.points);
    const double t = dot(shape.points.front() - ray.origin, n) / dot(ray.direction, n);
    if (!range.contains(t) || !contains(shape.points, TriangleRay(ray))) return false;
    hit.t = t;
    return true;
}

Vec3 normal(const Polygon& shape, const Vec3&, const ShapeHit&) { return plane_normal(shape.points); }

Bounds bounds(const Polygon& shape) {
    Bounds b;
    for (const Vec3& point : shape.points) b.extend(point);
    return b;
}

}  // namespace rt
