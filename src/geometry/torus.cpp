#include "geometry/torus.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/roots.h"

namespace rt {

namespace {

/// The torus along a line whose direction is unit and whose point at s = 0 is the one nearest to the torus' centre. Then the quartic has
/// no cubic term: s^4 + c2 s^2 + c1 s + c0.
struct Quartic {
    Quartic(const Torus& torus, const Vec3& nearest, const Vec3& direction)
        : R(torus.major_radius), r2(sqr(torus.minor_radius)), o(nearest), d(direction) {
        const double R2 = sqr(R);
        c2 = 2.0 * (dot(o, o) + R2 - r2) - 4.0 * R2 + 4.0 * R2 * sqr(d.y);
        c1 = 8.0 * R2 * o.y * d.y;
    }
    /// The same value as a product of two distances from circles, which keeps its relative accuracy for thin tori.
    double operator()(double s) const {
        const Vec3 p = o + s * d;
        const double rho = std::sqrt(sqr(p.x) + sqr(p.z));
        const double rest = sqr(p.y) - r2;
        return (sqr(rho - R) + rest) * (sqr(rho + R) + rest);
    }
    double derivative(double s) const { return (4.0 * s * s + 2.0 * c2) * s + c1; }
    double second_derivative(double s) const { return 12.0 * s * s + 2.0 * c2; }

    double R, r2, c2, c1;
    Vec3 o, d;
};

/// Points in increasing order, `lo` first and `hi` last, between which the quartic is monotone.
struct Pieces {
    Pieces(const Quartic& quartic, double lo, double hi, double tolerance) {
        ends[count++] = lo;
        const double e = quartic.c2 < 0.0 ? std::sqrt(-quartic.c2 / 6.0) : lo;  // the derivative turns at -e and e
        const std::array<double, 4> turns{lo, std::fmin(std::fmax(-e, lo), hi), std::fmin(std::fmax(e, lo), hi), hi};
        for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
            const double from = turns[i], to = turns[i + 1];
            if (!(from < to)) continue;
            const bool begins_negative = quartic.derivative(from) < 0.0;
            if (begins_negative == (quartic.derivative(to) < 0.0)) continue;
            ends[count++] = bracketed_root(
                from, to, begins_negative, tolerance, [&](double s) { return quartic.derivative(s); },
                [&](double s) { return quartic.second_derivative(s); });
        }
        ends[count++] = hi;
    }
    std::array<double, 5> ends{};
    std::size_t count = 0;
};

/// Cuts [lo, hi] to where the line is in a ball and a slab slightly larger than the torus: the ends are surely outside of it.
bool clip_to_hull(const Torus& torus, const Vec3& nearest, const Vec3& direction, double& lo, double& hi) {
    constexpr double margin = 1.001;
    const double half2 = sqr(margin * (std::fabs(torus.major_radius) + std::fabs(torus.minor_radius))) - dot(nearest, nearest);
    if (!(half2 > 0.0)) return false;
    hi = std::sqrt(half2);
    lo = -hi;
    const double height = margin * std::fabs(torus.minor_radius);
    if (direction.y == 0.0) return std::fabs(nearest.y) < height;
    const double below = (-height - nearest.y) / direction.y;
    const double above = (height - nearest.y) / direction.y;
    lo = std::fmax(lo, std::fmin(below, above));
    hi = std::fmin(hi, std::fmax(below, above));
    return lo < hi;
}

/// POV-Ray asks first whether the ray meets the drum around the tube: |y| < r and rho < |R + r|. Where R is negative the drum is narrower
/// than the tube: only what is seen through it exists.
bool meets_drum(const Torus& torus, const Ray& ray) {
    const double r = torus.minor_radius;
    const Vec3 &o = ray.origin, &d = ray.direction;
    const double a = sqr(d.x) + sqr(d.z), b = o.x * d.x + o.z * d.z, c = sqr(o.x) + sqr(o.z) - sqr(torus.major_radius + r);
    double lo = -infinity, hi = infinity;
    if (a > 0.0) {
        const double root = std::sqrt(b * b - a * c);
        lo = (-b - root) / a;
        hi = (-b + root) / a;
    } else if (c >= 0.0) {
        return false;
    }
    if (d.y != 0.0) {
        const double below = (-r - o.y) / d.y, above = (r - o.y) / d.y;
        lo = std::max(lo, std::min(below, above));
        hi = std::min(hi, std::max(below, above));
    } else if (std::fabs(o.y) >= r) {
        return false;
    }
    return lo < hi && hi > 0.0;
}

}  // namespace

// The roots are isolated by the extrema of the quartic, those by the extrema of its derivative: no closed formula, so double and nearly
// double roots cost no accuracy. A ray that only touches (the quartic does not become negative) has no hit.
bool intersect(const Torus& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    if (shape.major_radius < 0.0 && shape.minor_radius > 0.0 && !meets_drum(shape, ray)) return false;
    const double speed = length(ray.direction);
    const Vec3 direction = ray.direction / speed;
    const double shift = -dot(ray.origin, direction);
    const Vec3 nearest = ray.origin + shift * direction;
    double lo = 0.0, hi = 0.0;
    if (!clip_to_hull(shape, nearest, direction, lo, hi)) return false;

    const Quartic quartic(shape, nearest, direction);
    const double tolerance = 0x1p-53 * (std::fabs(shape.major_radius) + std::fabs(shape.minor_radius));
    const Pieces pieces(quartic, lo, hi, tolerance);
    bool inside = false;
    for (std::size_t i = 1; i < pieces.count; ++i) {
        const bool was_inside = std::exchange(inside, quartic(pieces.ends[i]) < 0.0);
        if (inside == was_inside || !((pieces.ends[i] + shift) / speed > range.min)) continue;
        const double s = bracketed_root(pieces.ends[i - 1], pieces.ends[i], was_inside, tolerance, quartic,
                                        [&](double x) { return quartic.derivative(x); });
        const double t = (s + shift) / speed;
        if (t >= range.max) return false;
        if (!range.contains(t)) continue;
        hit.t = t;
        return true;
    }
    return false;
}

Vec3 normal(const Torus& shape, const Vec3& point, const ShapeHit&) {
    // From the nearest point of the circle inside the tube; on the axis (spindle tori only) every point is nearest, the axis is the normal.
    // POV-Ray keeps the sign of a negative major radius: it measures from the circle's far side.
    const double rho = std::sqrt(sqr(point.x) + sqr(point.z));
    if (rho == 0.0) return {0.0, point.y < 0.0 ? -1.0 : 1.0, 0.0};
    const double from_circle = (rho - shape.major_radius) / rho;
    return {point.x * from_circle, point.y, point.z * from_circle};
}

bool contains(const Torus& shape, const Vec3& point) {
    const double from_circle = std::sqrt(sqr(point.x) + sqr(point.z)) - std::fabs(shape.major_radius);
    return sqr(from_circle) + sqr(point.y) < sqr(shape.minor_radius);
}

Bounds bounds(const Torus& shape) {
    const double r = std::fabs(shape.minor_radius);
    const double reach = std::fabs(shape.major_radius) + r;
    return rounded_outward({{-reach, -r, -reach}, {reach, r, reach}});
}

}  // namespace rt
