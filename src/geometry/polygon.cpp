#include "geometry/polygon.h"

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

/// Twice the area vector of the contour with the largest one (Newell's method): contours that run opposite ways must not cancel.
Vec3 area_vector(const std::vector<Vec3>& points) {
    Vec3 largest(0.0), sum(0.0);
    std::size_t contour = 0;
    const auto finish = [&] {
        if (dot(sum, sum) > dot(largest, largest)) largest = sum;
        sum = Vec3(0.0);
    };
    for_each_edge(points, [&](std::size_t first, const Vec3& from, const Vec3& to) {
        if (first != contour) finish();
        contour = first;
        sum += cross(from - points[first], to - points[first]);
    });
    finish();
    return largest;
}

/// Even-odd rule in the plane with coordinates x and y (indices of the vector's components), by a walk towards +x.
/// An edge owns its lower end and not its upper one, so a walk through a vertex counts it once.
bool contains(const std::vector<Vec3>& points, const Vec3& origin, const Vec3& p, int x, int y) {
    bool inside = false;
    for_each_edge(points, [&](std::size_t, const Vec3& from, const Vec3& to) {
        const double from_x = from[x] - origin[x] - p[x], from_y = from[y] - origin[y] - p[y];
        const double to_x = to[x] - origin[x] - p[x], to_y = to[y] - origin[y] - p[y];
        if ((from_y > 0.0) == (to_y > 0.0)) return;
        const double turn = from_x * to_y - to_x * from_y;
        if ((turn > 0.0) == (to_y > 0.0)) inside = !inside;
    });
    return inside;
}

}  // namespace

bool intersect(const Polygon& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    if (shape.points.size() < 3) return false;
    const Vec3 n = area_vector(shape.points);
    const Vec3& on_plane = shape.points.front();
    const Vec3 f = ray.origin - on_plane;
    const double t = -dot(f, n) / dot(ray.direction, n);
    if (!range.contains(t)) return false;
    const double nx = std::fabs(n.x), ny = std::fabs(n.y), nz = std::fabs(n.z);
    const int dominant = nz >= nx && nz >= ny ? 2 : ny >= nx ? 1 : 0;
    if (!contains(shape.points, on_plane, f + t * ray.direction, (dominant + 1) % 3, (dominant + 2) % 3)) return false;
    hit.t = t;
    return true;
}

Vec3 normal(const Polygon& shape, const Vec3&, const ShapeHit&) { return area_vector(shape.points); }

Bounds bounds(const Polygon& shape) {
    Bounds b;
    for (const Vec3& point : shape.points) b.extend(point);
    return b;
}

}  // namespace rt
