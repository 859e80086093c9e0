#include "geometry/superellipsoid.h"

#include <algorithm>
#include <array>

#include "geometry/roots.h"

namespace rt {

namespace {

/// (a^p + b^p)^(1/p) for a, b >= 0 without leaving the range of doubles.
double norm2(double a, double b, double p) {
    const double large = std::fmax(a, b), small = std::fmin(a, b);
    if (large == 0.0) return 0.0;
    return large * std::pow(1.0 + std::pow(small / large, p), 1.0 / p);
}

/// The surface is where this is 1: it grows in proportion to the distance from the origin, and with each |coordinate|.
double norm(const Superellipsoid& s, const Vec3& p) {
    const double around = norm2(std::fabs(p.x), std::fabs(p.y), 2.0 / s.east_west);
    return norm2(around, std::fabs(p.z), 2.0 / s.north_south);
}

/// x^p with the sign of x, for unit scale.
double signed_power(double x, double p) { return std::copysign(std::pow(std::fabs(x), p), x); }

Vec3 gradient(const Superellipsoid& s, const Vec3& p) {
    const double a = 2.0 / s.east_west, c = 2.0 / s.north_south;
    const double around = norm2(std::fabs(p.x), std::fabs(p.y), a);
    const double whole = norm2(around, std::fabs(p.z), c);
    if (whole == 0.0) return Vec3(0.0);
    // d whole / d around = (around / whole)^(c - 1), d around / d x = (x / around)^(a - 1).
    const double by_z = signed_power(p.z / whole, c - 1.0);
    if (around == 0.0) return {0.0, 0.0, by_z};
    const double by_around = std::pow(around / whole, c - 1.0);
    return {by_around * signed_power(p.x / around, a - 1.0), by_around * signed_power(p.y / around, a - 1.0), by_z};
}

/// A line in units of the shape: its direction is unit.
struct Line {
    const Superellipsoid& shape;
    Vec3 o, d;
    Vec3 at(double s) const { return o + s * d; }
    double value(double s) const { return norm(shape, at(s)) - 1.0; }
    double slope(double s) const { return dot(gradient(shape, at(s)), d); }
    double root(double from, double to, bool rising) const {
        constexpr double tolerance = 0x1p-54;
        return bracketed_root(
            from, to, rising, tolerance, [&](double s) { return value(s); }, [&](double s) { return slope(s); });
    }
};

/// Cuts the line to the cube around the shape.
bool clip(const Line& line, double& from, double& to) {
    constexpr double half = 1.0 + 1e-9;
    for (int axis = 0; axis < 3; ++axis) {
        if (line.d[axis] == 0.0) {
            if (std::fabs(line.o[axis]) > half) return false;
            continue;
        }
        const double a = (-half - line.o[axis]) / line.d[axis], b = (half - line.o[axis]) / line.d[axis];
        from = std::fmax(from, std::fmin(a, b));
        to = std::fmin(to, std::fmax(a, b));
    }
    return from < to;
}

/// A place between from and to where the norm, which is convex along the line, is below 1. The tangents at both ends bound it from below:
/// where they meet is the next place to look at.
bool find_inside(const Line& line, double from, double to, double& inside) {
    constexpr int most_steps = 200;
    double low = line.value(from), high = line.value(to), low_slope = line.slope(from), high_slope = line.slope(to);
    if (!(low > 0.0 && high > 0.0)) {  // the cube's faces touch the shape
        inside = low > 0.0 ? to : from;
        return true;
    }
    for (int i = 0; i < most_steps && low_slope < 0.0 && high_slope > 0.0; ++i) {
        double s = (high - low + low_slope * from - high_slope * to) / (low_slope - high_slope);
        if (low + low_slope * (s - from) > 0.0) return false;
        if (!(s > from && s < to) || i % 4 == 3) s = 0.5 * (from + to);
        if (!(s > from && s < to)) return false;
        const double value = line.value(s), slope = line.slope(s);
        if (value < 0.0) {
            inside = s;
            return true;
        }
        (slope < 0.0 ? from : to) = s;
        (slope < 0.0 ? low : high) = value;
        (slope < 0.0 ? low_slope : high_slope) = slope;
    }
    return false;
}

/// Visits the roots of a shape that is not convex between two places without a change of sign of a coordinate: halves the stretch until the
/// norm is surely above or below 1 on it, or the stretch is short.
template <typename Visit>
void search(const Line& line, double from, double to, int depth, Visit visit) {
    constexpr int deepest = 12;
    const Vec3 a = glm::abs(line.at(from)), b = glm::abs(line.at(to));
    if (norm(line.shape, glm::min(a, b)) > 1.0 || norm(line.shape, glm::max(a, b)) < 1.0) return;
    if (depth == deepest) {
        const bool in = line.value(from) < 0.0, out = line.value(to) < 0.0;
        if (in != out) visit(line.root(from, to, in));
        return;
    }
    const double middle = 0.5 * (from + to);
    search(line, from, middle, depth + 1, visit);
    search(line, middle, to, depth + 1, visit);
}

}  // namespace

void find_hits(const Superellipsoid& shape, const Ray& ray, HitSink& sink) {
    const double speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const double shift = -dot(ray.origin, d);
    const Line line{shape, ray.origin + shift * d, d};
    double from = -2.0, to = 2.0;
    if (!clip(line, from, to)) return;
    const auto offer = [&](double s) { sink.offer({.t = (s + shift) / speed}); };
    if (shape.east_west <= 2.0 && shape.north_south <= 2.0) {
        double inside = 0.0;
        if (!find_inside(line, from, to, inside)) return;
        if (inside > from) offer(line.root(from, inside, false));
        if (inside < to) offer(line.root(inside, to, true));
        return;
    }
    std::array<double, 5> cuts{from, to, to, to, to};
    for (int axis = 0; axis < 3; ++axis) cuts[2 + axis] = std::fmin(std::fmax(-line.o[axis] / line.d[axis], from), to);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        if (cuts[i] < cuts[i + 1]) search(line, cuts[i], cuts[i + 1], 0, offer);
}

Vec3 normal(const Superellipsoid& shape, const Vec3& point, const ShapeHit&) {
    const Vec3 g = gradient(shape, point);
    return is_finite(g) && g != Vec3(0.0) ? g : point;
}

bool contains(const Superellipsoid& shape, const Vec3& point) { return norm(shape, point) < 1.0; }

Bounds bounds(const Superellipsoid&) { return rounded_outward({Vec3(-1.0), Vec3(1.0)}); }

}  // namespace rt
