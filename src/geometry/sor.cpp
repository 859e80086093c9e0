#include "geometry/sor.h"

#include <algorithm>

#include "geometry/bernstein.h"
#include "geometry/roots.h"

namespace rt {

namespace {

using Cubic = std::array<double, 4>;

double widest2(const SorSlice& slice) { return std::max(0.0, *std::max_element(slice.radius2.begin(), slice.radius2.end())); }

/// A line from the point nearest to the middle: radius^2 = c + 2 b s + a s^2.
struct SliceRay {
    double y, climb, a, b, c;
    double radius2(double s) const { return c + (2.0 * b + a * s) * s; }
};

/// Where the line is between the planes of the slice and near enough to the axis. Planes are met at the same s from both sides.
bool clip(const SliceRay& ray, const SorSlice& slice, double& s0, double& s1) {
    constexpr double room = 1.0 + 1e-6;
    const double widest = room * widest2(slice);
    if (ray.climb != 0.0) {
        const double a = (slice.low - ray.y) / ray.climb, b = (slice.high - ray.y) / ray.climb;
        s0 = std::fmin(a, b);
        s1 = std::fmax(a, b);
    } else if (ray.y < slice.low || ray.y >= slice.high) {
        return false;
    }
    if (ray.a == 0.0) return ray.c <= widest && s0 < s1;
    const double half = ray.b * ray.b - ray.a * (ray.c - widest);
    if (half < 0.0) return false;
    s0 = std::fmax(s0, (-ray.b - std::sqrt(half)) / ray.a);
    s1 = std::fmin(s1, (-ray.b + std::sqrt(half)) / ray.a);
    return s0 < s1;
}

/// r^2 of the slice minus that of the line, on s0..s1 as a cubic in [0, 1].
Cubic gap(const SliceRay& ray, const SorSlice& slice, double s0, double s1) {
    const double height = slice.high - slice.low;
    const auto v = [&](double s) { return std::fmin(std::fmax((ray.y + s * ray.climb - slice.low) / height, 0.0), 1.0); };
    Cubic f = part(slice.radius2, v(s0), v(s1));
    const double first = ray.radius2(s0), last = ray.radius2(s1);
    const double middle = ray.c + ray.b * (s0 + s1) + ray.a * s0 * s1;  // the quadratic's other Bernstein coefficient
    f[0] -= first;
    f[1] -= (first + 2.0 * middle) / 3.0;
    f[2] -= (2.0 * middle + last) / 3.0;
    f[3] -= last;
    return f;
}

}  // namespace

void find_hits(const Sor& shape, const Ray& ray, HitSink& sink) {
    const std::vector<SorSlice>& slices = *shape.slices;
    const double speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const double shift = -dot(ray.origin - Vec3(0.0, 0.5 * (slices.front().low + slices.back().high), 0.0), d);
    const Vec3 o = ray.origin + shift * d;
    const SliceRay line{o.y, d.y, sqr(d.x) + sqr(d.z), o.x * d.x + o.z * d.z, sqr(o.x) + sqr(o.z)};
    if (!shape.open && d.y != 0.0) {
        const double s[2] = {(slices.front().low - o.y) / d.y, (slices.back().high - o.y) / d.y};
        if (line.radius2(s[0]) <= slices.front().radius2[0]) sink.offer({.t = (s[0] + shift) / speed, .part = 0});
        if (line.radius2(s[1]) <= slices.back().radius2[3]) sink.offer({.t = (s[1] + shift) / speed, .part = 1});
    }
    for (std::size_t i = 0; i < slices.size(); ++i) {
        double s0 = -infinity, s1 = infinity;
        if (!clip(line, slices[i], s0, s1)) continue;
        const Cubic f = gap(line, slices[i], s0, s1);
        SignChanges changes(f, SignChanges::Basis::bernstein, f[0] == 0.0 ? 1 : 0);  // zero counts as positive, for both neighbours
        const auto offer = [&](double u) {
            sink.offer({.t = ((1.0 - u) * s0 + u * s1 + shift) / speed, .part = static_cast<std::uint32_t>(2 + i)});
        };
        for (double u = -1.0; changes.next(u, u);) offer(u);
        if (f[3] == 0.0 && changes.sign() < 0) offer(1.0);
    }
}

Vec3 normal(const Sor& shape, const Vec3& point, const ShapeHit& hit) {
    if (hit.part < 2) return {0.0, hit.part == 0 ? -1.0 : 1.0, 0.0};
    const SorSlice& slice = (*shape.slices)[hit.part - 2];
    const double height = slice.high - slice.low;
    return {point.x, -0.5 * slope_at(slice.radius2, (point.y - slice.low) / height) / height, point.z};
}

double along_curve(const Sor& shape, const Vec3& point, const ShapeHit& hit) {
    if (hit.part < 2) return hit.part;
    const SorSlice& slice = (*shape.slices)[hit.part - 2];
    return (hit.part - 2 + (point.y - slice.low) / (slice.high - slice.low)) / static_cast<double>(shape.slices->size());
}

bool contains(const Sor& shape, const Vec3& point) {
    for (const SorSlice& slice : *shape.slices)
        if (point.y > slice.low && point.y <= slice.high)
            return sqr(point.x) + sqr(point.z) < value_at(slice.radius2, (point.y - slice.low) / (slice.high - slice.low));
    return false;
}

Bounds bounds(const Sor& shape) {
    double widest = 0.0;
    for (const SorSlice& slice : *shape.slices) widest = std::fmax(widest, std::sqrt(widest2(slice)));
    return rounded_outward({{-widest, shape.slices->front().low, -widest}, {widest, shape.slices->back().high, widest}});
}

}  // namespace rt
