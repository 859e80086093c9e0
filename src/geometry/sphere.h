// Sphere.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Sphere {
    Vec3 center{0.0};
    double radius = 1.0;
    bool operator==(const Sphere&) const = default;
};

/// Haines, Guenther, Akenine-Moeller 2019, "Precision Improvements for Ray/Sphere Intersection": the discriminant comes from the distance
/// of the centre from the ray, which does not cancel for small or far spheres, and the roots from the form that adds like signs.
[[gnu::always_inline]] inline bool intersect(const Sphere& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    const Vec3 f = ray.origin - shape.center;
    const Vec3& d = ray.direction;
    const double a = dot(d, d);
    const double b = -dot(f, d);
    const Vec3 nearest = f + (b / a) * d;
    const double r2 = shape.radius * shape.radius;
    const double discriminant = r2 - dot(nearest, nearest);
    if (!(discriminant >= 0.0)) return false;
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    const double c = dot(f, f) - r2;
    const double t_q = q / a;
    const double t_c = c / q;
    const double t_near = b > 0.0 ? t_c : t_q;
    const double t_far = b > 0.0 ? t_q : t_c;
    if (range.contains(t_near))
        hit.t = t_near;
    else if (range.contains(t_far))
        hit.t = t_far;
    else
        return false;
    return true;
}

inline Vec3 normal(const Sphere& shape, const Vec3& point, const ShapeHit&) { return point - shape.center; }

inline bool contains(const Sphere& shape, const Vec3& p) { return dot(p - shape.center, p - shape.center) < sqr(shape.radius); }

inline Bounds bounds(const Sphere& shape) {
    const Vec3 r(std::fabs(shape.radius));
    return rounded_outward({shape.center - r, shape.center + r});
}

}  // namespace rt
