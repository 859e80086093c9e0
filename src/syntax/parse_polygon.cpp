// polygon { }
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

bool same_point(const Vec3& a, const Vec3& b) { return length(a - b) < epsilon; }

/// Closes every contour by an exact copy of its first point. How many points the last one had if it had to be closed by a point of ours.
std::size_t close_contours(std::vector<Vec3>& points) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i == first || !same_point(points[i], points[first])) continue;
        if (i == first + 1 && i + 1 < points.size()) continue;  // a doubled first point closes nothing
        points[i] = points[first];
        first = i + 1;
    }
    if (first >= points.size()) return 0;
    points.push_back(points[first]);
    return points.size() - 1 - first;
}

/// The plane's normal from the first point and the two that span the most with it; zero if all points lie on a line.
Vec3 plane_normal(const std::vector<Vec3>& points) {
    Vec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec3 candidate = cross(points[i] - points[0], points[i + 1] - points[0]);
        if (length(candidate) > length(normal)) normal = candidate;
    }
    return normal;
}

/// POV-Ray shows nothing of a polygon whose points are not in one plane, by an absolute measure; far points get their rounding as well.
bool is_planar(const std::vector<Vec3>& points, const Vec3& normal) {
    const Vec3 n = unit(normal);
    for (const Vec3& p : points) {
        const double rounding = 1e-15 * (length(p) + length(points[0]));
        if (std::fabs(dot(p - points[0], n)) > epsilon + rounding) return false;
    }
    return true;
}

}  // namespace

ParsedShape parse_polygon(Reader& reader) {
    const std::size_t count = parse_count(reader);
    if (count < 3) reader.fail(reader.peek().span, "Polygon needs at least three points.");
    Polygon polygon;
    polygon.points.reserve(reserve_limit(reader, count + 1, 2));
    for (std::size_t i = 0; i < count; ++i) {
        reader.accept_comma();
        polygon.points.push_back(reader.parse_vector());
    }
    const Span place = reader.peek().span;
    const std::size_t open = close_contours(polygon.points);
    if (open != 0) reader.warn(place, "Polygon not closed. Closing it.");
    // POV-Ray makes a triangle of it with the start of the contour before and a point far away, wherever that lies in its own plane.
    if (open == 1) reader.warn(place, "The last point of this polygon stands alone and bounds nothing. POV-Ray draws something else.");
    const Vec3 normal = plane_normal(polygon.points);
    if (!(length(normal) > 0.0)) return std::nullopt;
    if (!is_planar(polygon.points, normal)) {
        reader.warn(place, "The points of this polygon are not in one plane. It is not visible.");
        return std::nullopt;
    }
    return polygon;
}

}  // namespace rt
