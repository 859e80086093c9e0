#include "geometry/lathe.h"

#include "geometry/bernstein.h"
#include "geometry/roots.h"

namespace rt {

namespace {

using Cubic = std::array<double, 4>;

Cubic radii(const CurvePiece& p) { return {p.points[0].x, p.points[1].x, p.points[2].x, p.points[3].x}; }
Cubic heights(const CurvePiece& p) { return {p.points[0].y, p.points[1].y, p.points[2].y, p.points[3].y}; }

/// A line as the curve sees it: unit direction, from the point nearest to the lathe's middle. radius^2 = c + 2 b s + a s^2.
struct AxisRay {
    AxisRay(const Vec3& o_, const Vec3& d_)
        : o(o_), d(d_), a(sqr(d_.x) + sqr(d_.z)), b(o_.x * d_.x + o_.z * d_.z), c(sqr(o_.x) + sqr(o_.z)) {}
    Vec3 o, d;
    double a, b, c;
};

struct OnCurve {
    double s, u;
};

/// Newton's method for the ray's point and the curve's being the same in height and radius.
OnCurve refined(const AxisRay& ray, const Cubic& r, const Cubic& y, OnCurve at) {
    constexpr int steps = 3;
    for (int i = 0; i < steps; ++i) {
        const double radius = value_at(r, at.u), radius_slope = slope_at(r, at.u), y_slope = slope_at(y, at.u);
        const double too_high = ray.o.y + at.s * ray.d.y - value_at(y, at.u);
        const double too_wide = ray.c + (2.0 * ray.b + ray.a * at.s) * at.s - radius * radius;
        const double widening = 2.0 * (ray.b + ray.a * at.s);
        const double determinant = widening * y_slope - 2.0 * radius * radius_slope * ray.d.y;
        const double ds = (2.0 * radius * radius_slope * too_high - y_slope * too_wide) / determinant;
        const double du = (widening * too_high - ray.d.y * too_wide) / determinant;
        constexpr double furthest = 0.01;  // beyond that the two are nearly parallel
        if (!(std::fabs(du) <= furthest)) break;
        at = {at.s + ds, at.u + du};
    }
    at.u = std::fmin(std::fmax(at.u, 0.0), 1.0);
    return at;
}

/// Whether the line comes as near to the axis as the piece, at its heights.
bool passes(const AxisRay& ray, const CurvePiece& piece, double reach) {
    double widest = 0.0, low = infinity, high = -infinity;
    for (const Vec2& p : piece.points) {
        widest = std::fmax(widest, std::fabs(p.x));
        low = std::fmin(low, p.y);
        high = std::fmax(high, p.y);
    }
    const double room = 1e-9 * reach;
    double s0 = -2.0 * reach, s1 = 2.0 * reach;
    if (ray.a > 0.0) {
        const double half = ray.b * ray.b - ray.a * (ray.c - sqr(widest + room));
        if (half < 0.0) return false;
        s0 = (-ray.b - std::sqrt(half)) / ray.a;
        s1 = (-ray.b + std::sqrt(half)) / ray.a;
    } else if (ray.c > sqr(widest + room)) {
        return false;
    }
    const double y0 = ray.o.y + s0 * ray.d.y, y1 = ray.o.y + s1 * ray.d.y;
    return std::fmax(y0, y1) >= low - room && std::fmin(y0, y1) <= high + room;
}

/// Visits the crossings of a line that is nearly horizontal: where the curve is as high as the line, on both sides of the axis.
template <typename Visit>
void visit_horizontal(const AxisRay& ray, const CurvePiece& piece, const Cubic& r, Visit visit) {
    const Crossings found = crossings(piece, {0.0, 1.0}, ray.o.y);
    for (std::size_t i = 0; i < found.count; ++i) {
        const double half = ray.b * ray.b - ray.a * (ray.c - sqr(value_at(r, found.u[i])));
        if (half < 0.0) continue;
        visit(OnCurve{(-ray.b - std::sqrt(half)) / ray.a, found.u[i]});
        visit(OnCurve{(-ray.b + std::sqrt(half)) / ray.a, found.u[i]});
    }
}

/// Visits the crossings of any other line. With s = (y - o.y) / d.y in the equation of the radius:
/// d.y^2 (r^2 - c) - 2 b d.y (y - o.y) - a (y - o.y)^2 = 0, of degree 6 in u.
template <typename Visit>
void visit_steep(const AxisRay& ray, const Cubic& r, const Cubic& y, Visit visit) {
    Cubic above;
    for (std::size_t i = 0; i < 4; ++i) above[i] = y[i] - ray.o.y;
    const std::array<double, 7> r2 = product(r, r), above2 = product(above, above), above1 = product(above, Cubic{1.0, 1.0, 1.0, 1.0});
    std::array<double, 7> f;
    for (std::size_t i = 0; i < 7; ++i) f[i] = sqr(ray.d.y) * (r2[i] - ray.c) - 2.0 * ray.b * ray.d.y * above1[i] - ray.a * above2[i];
    SignChanges changes(f, SignChanges::Basis::bernstein, f[0] == 0.0 ? 1 : 0);  // zero counts as positive, for both neighbours
    for (double u = -1.0; changes.next(u, u);) visit(OnCurve{value_at(above, u) / ray.d.y, u});
    if (f[6] == 0.0 && changes.sign() < 0) visit(OnCurve{above[3] / ray.d.y, 1.0});
}

}  // namespace

void find_hits(const Lathe& shape, const Ray& ray, HitSink& sink) {
    constexpr double nearly_horizontal = 1e-5;
    const Outline& curve = *shape.curve;
    const double speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const Vec3 middle(0.0, 0.5 * (curve.min.y + curve.max.y), 0.0);
    const double shift = -dot(ray.origin - middle, d);
    const AxisRay line(ray.origin + shift * d, d);
    const double reach = std::fmax(std::fabs(curve.min.x), std::fabs(curve.max.x)) + curve.max.y - curve.min.y;
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
        const Cubic r = radii(curve.pieces[i]), y = heights(curve.pieces[i]);
        if (!passes(line, curve.pieces[i], reach)) continue;
        const auto offer = [&](const OnCurve& start) {
            const OnCurve at = refined(line, r, y, start);
            sink.offer({.t = (at.s + shift) / speed, .part = static_cast<std::uint32_t>(i), .u = at.u});
        };
        if (std::fabs(d.y) < nearly_horizontal)
            visit_horizontal(line, curve.pieces[i], r, offer);
        else
            visit_steep(line, r, y, offer);
    }
}

Vec3 normal(const Lathe& shape, const Vec3& point, const ShapeHit& hit) {
    const CurvePiece& piece = shape.curve->pieces[hit.part];
    const Vec2 along = piece.tangent(hit.u);
    const double radius = std::hypot(point.x, point.z);
    if (radius == 0.0) return {0.0, along.x > 0.0 ? -1.0 : 1.0, 0.0};
    return {along.y * point.x / radius, -along.x, along.y * point.z / radius};
}

double along_curve(const Lathe& shape, const ShapeHit& hit) {
    const double share = (hit.part + hit.u) / static_cast<double>(shape.curve->pieces.size());
    return shape.turned ? 1.0 - share : share;
}

bool contains(const Lathe& shape, const Vec3& point) { return shape.curve->contains({std::hypot(point.x, point.z), point.y}); }

Bounds bounds(const Lathe& shape) {
    const Outline& curve = *shape.curve;
    const double widest = std::fmax(std::fabs(curve.min.x), std::fabs(curve.max.x));
    return rounded_outward({{-widest, curve.min.y, -widest}, {widest, curve.max.y, widest}});
}

}  // namespace rt
