#include "syntax/shape_box.h"

#include <array>
#include <cmath>

#include "syntax/quadric_box.h"

namespace rt {

Bounds around_moved(const Bounds& box, const Mat3& linear, const Vec3& offset) {
    Bounds around;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p((corner & 1 ? box.max : box.min).x, (corner & 2 ? box.max : box.min).y, (corner & 4 ? box.max : box.min).z);
        around.extend(linear * p + offset);
    }
    return around;
}

namespace {

/// A cone's, cylinder's or disc's own space has its axis along z and is turned there by the shortest way.
Mat3 turned_from_z(const Vec3& axis) {
    if (1.0 + axis.z < 1e-12) return {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), axis};
    const double s = 1.0 / (1.0 + axis.z);
    return {Vec3(1.0 - s * axis.x * axis.x, -s * axis.x * axis.y, -axis.x), Vec3(-s * axis.x * axis.y, 1.0 - s * axis.y * axis.y, -axis.y),
            axis};
}

Bounds around_corners(const Bounds& box, const std::optional<Transform>& t) { return t ? around_moved(box, t->linear, t->offset) : box; }

/// The box's corners go through two spaces.
Bounds around_corners(const Bounds& box, const Mat3& linear, const Vec3& offset, const std::optional<Transform>& t) {
    if (!t) return around_moved(box, linear, offset);
    return around_moved(box, t->linear * linear, t->point(offset));
}

/// The factor of a transform that leaves spheres round; unset for others.
std::optional<double> uniform_scale(const Transform& t) {
    const Mat3 square = glm::transpose(t.linear) * t.linear;
    const double s2 = square[0][0];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::fabs(square[i][j] - (i == j ? s2 : 0.0)) > 1e-9 * s2) return std::nullopt;
    return std::sqrt(s2);
}

Bounds box_of(const Sphere& s, const std::optional<Transform>& t) {
    const auto ball = [](const Vec3& center, double radius) {
        const Vec3 r(std::fabs(radius));
        return Bounds{center - r, center + r};
    };
    if (!t) return ball(s.center, s.radius);
    if (const auto scale = uniform_scale(*t)) return ball(t->point(s.center), *scale * s.radius);
    return around_corners(ball(s.center, s.radius), t);
}

Bounds box_of(const Box& b, const std::optional<Transform>& t) { return around_corners({b.min, b.max}, t); }

/// The axis goes from the end that is narrower; of a cylinder from the second one.
Bounds box_of(const Cone& c, const std::optional<Transform>& t) {
    const bool to_cap = c.cap_radius > c.base_radius;
    const Vec3 from = to_cap ? c.base : c.cap, axis = to_cap ? c.cap - c.base : c.base - c.cap;
    const double radius = std::fmax(c.base_radius, c.cap_radius);
    return around_corners({Vec3(-radius, -radius, 0.0), Vec3(radius, radius, length(axis))}, turned_from_z(unit(axis)), from, t);
}

Bounds box_of(const Torus& torus, const std::optional<Transform>& t) {
    const Vec3 half(torus.major_radius + torus.minor_radius, torus.minor_radius, torus.major_radius + torus.minor_radius);
    return around_corners({-half, half}, t);
}

Bounds box_of(const Disc& d, const std::optional<Transform>& t) {
    constexpr double thick = 1e-3;
    const Vec3 half(d.radius, d.radius, thick);
    return around_corners({-half, half}, turned_from_z(d.normal), d.center, t);
}

template <typename Points>
Bounds around_points(const Points& points, const std::optional<Transform>& t) {
    Bounds around;
    for (const Vec3& p : points) around.extend(t ? t->point(p) : p);
    return around;
}

template <typename T>
Bounds box_of_triangle(const T& triangle, const std::optional<Transform>& t) {
    const Vec3 margin(1e-10);
    const Bounds box = around_points(std::array{triangle.a, triangle.b, triangle.c}, t);
    return {box.min - margin, box.max + margin};
}

Bounds box_of(const Triangle& triangle, const std::optional<Transform>& t) { return box_of_triangle(triangle, t); }
Bounds box_of(const SmoothTriangle& triangle, const std::optional<Transform>& t) { return box_of_triangle(triangle, t); }

Bounds box_of(const Polygon& polygon, const std::optional<Transform>& t) {
    constexpr double thick = 1e-3;
    Bounds box = around_points(polygon.points, t);
    for (int i = 0; i < 3; ++i) {
        if (box.max[i] - box.min[i] >= thick) continue;
        box.min[i] -= thick;
        box.max[i] += thick;
    }
    return box;
}

Bounds box_of(const Mesh& mesh, const std::optional<Transform>& t) { return around_corners(around_points(mesh.data->vertices, {}), t); }
Bounds box_of(const Plane&, const std::optional<Transform>&) { return Bounds::everything(); }
Bounds box_of(const Poly&, const std::optional<Transform>&) { return Bounds::everything(); }

Bounds box_of(const Superellipsoid&, const std::optional<Transform>& t) {
    constexpr double half = 1.0001;
    return around_corners({Vec3(-half), Vec3(half)}, t);
}

/// A component counts as a ball, for which the largest side of the ball's moved box is the radius.
Bounds around_ball(const Vec3& center, double radius, const Mat3& linear, const Vec3& offset) {
    const Bounds box = around_moved({Vec3(-radius), Vec3(radius)}, linear, Vec3(0.0));
    const Vec3 moved = linear * center + offset, half(max_component(box.max));
    return {moved - half, moved + half};
}

/// Components that take strength away count for nothing. A cylinder is its two ends and a ball around it without them.
Bounds box_of(const Blob& blob, const std::optional<Transform>& t) {
    Bounds box;
    for (const BlobComponent& c : blob.data->components) {
        if (c.strength < 0.0) continue;
        const Mat3 linear = c.moved ? glm::inverse(c.to_own) : Mat3(1.0);
        const Vec3 offset = c.moved ? -(linear * c.own_offset) : Vec3(0.0);
        const Vec3 axis = c.cap - c.base;
        const double half = 0.5 * length(axis);
        if (half == 0.0) {
            box.extend(around_ball(c.base, c.radius, linear, offset));
            continue;
        }
        const Mat3 whole = linear * turned_from_z(unit(axis));
        const Vec3 base = linear * c.base + offset;
        box.extend(around_ball(Vec3(0.0), c.radius, whole, base));
        box.extend(around_ball(Vec3(0.0, 0.0, 2.0 * half), c.radius, whole, base));
        box.extend(around_ball(Vec3(0.0, 0.0, half), std::hypot(c.radius, half), whole, base));
    }
    return around_corners(box, t);
}

/// Centres are moved where that leaves the spheres round.
Bounds box_of(const SphereSweep& sweep, const std::optional<Transform>& t) {
    const std::optional<double> scale = t ? uniform_scale(*t) : 1.0;
    Bounds box;
    for (const SweepPiece& piece : *sweep.pieces) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 center = t && scale ? t->point(piece.center[i]) : piece.center[i], r(scale.value_or(1.0) * piece.radius[i]);
            box.extend(center - r);
            box.extend(center + r);
        }
    }
    return scale ? box : around_corners(box, t);
}

/// Ends and turning points of a Bezier curve.
void extend(double& low, double& high, const std::array<double, 4>& b) {
    const double c1 = 3.0 * (b[1] - b[0]), c2 = 3.0 * (b[2] - 2.0 * b[1] + b[0]), c3 = b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0];
    const auto take = [&](double u) {
        if (!(u >= 0.0 && u <= 1.0)) return;
        const double value = b[0] + u * (c1 + u * (c2 + u * c3));
        low = std::fmin(low, value), high = std::fmax(high, value);
    };
    take(0.0), take(1.0);
    const double root = std::sqrt(c2 * c2 - 3.0 * c1 * c3);
    take(-c1 / (2.0 * c2));
    take((-c2 - root) / (3.0 * c3)), take((-c2 + root) / (3.0 * c3));
}

/// Around straight and quadratic curves themselves, around the points of cubic ones.
std::pair<Vec2, Vec2> around_curve(const Outline& outline) {
    Vec2 min(infinity), max(-infinity);
    for (const CurvePiece& piece : outline.pieces) {
        for (int i = 0; i < 2; ++i) {
            const std::array<double, 4> b{piece.points[0][i], piece.points[1][i], piece.points[2][i], piece.points[3][i]};
            const double scale = std::fabs(b[0]) + std::fabs(b[1]) + std::fabs(b[2]) + std::fabs(b[3]);
            if (std::fabs(b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0]) < 1e-12 * scale)
                extend(min[i], max[i], b);
            else
                for (const double x : b) min[i] = std::fmin(min[i], x), max[i] = std::fmax(max[i], x);
        }
    }
    return {min, max};
}

Bounds box_of(const Lathe& lathe, const std::optional<Transform>& t) {
    const auto [min, max] = around_curve(*lathe.curve);
    const double radius = std::fmax(std::fabs(min.x), std::fabs(max.x));
    return around_corners({Vec3(-radius, min.y, -radius), Vec3(radius, max.y, radius)}, t);
}

Bounds box_of(const Prism& prism, const std::optional<Transform>& t) {
    if (prism.conic) return around_corners(bounds(prism), t);
    const auto [min, max] = around_curve(*prism.outline);
    return around_corners({Vec3(min.x, prism.low, min.y), Vec3(max.x, prism.high, max.y)}, t);
}

Bounds box_of(const Sor& sor, const std::optional<Transform>& t) {
    double least = infinity, most = 0.0;
    for (const SorSlice& slice : *sor.slices) extend(least, most, slice.radius2);
    const double radius = std::sqrt(most);
    return around_corners({Vec3(-radius, sor.slices->front().low, -radius), Vec3(radius, sor.slices->back().high, radius)}, t);
}

Bounds box_of(const HeightField& field, const std::optional<Transform>& t) {
    Bounds box = bounds(field);
    box.min.y = std::fmax(box.min.y, field.lowest);
    return around_corners(box, t);
}

Bounds box_of(const Quadric& quadric, const std::optional<Transform>& t) {
    return around_corners(cut_to(quadric, Bounds::everything()), t);
}

template <typename S>
Bounds box_of(const S& shape, const std::optional<Transform>& t) {
    return around_corners(bounds(shape), t);
}

Bounds box_of(const FurtherShape& shape, const std::optional<Transform>& t) {
    return std::visit([&](const auto& one) { return box_of(one, t); }, shape);
}

}  // namespace

Bounds shape_box(const Shape& shape, const std::optional<Transform>& transform) {
    return std::visit([&](const auto& one) { return box_of(one, transform); }, shape);
}

}  // namespace rt
