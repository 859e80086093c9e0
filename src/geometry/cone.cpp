#include "geometry/cone.h"

#include <utility>

namespace rt {

namespace {

/// The stretch of a line inside a convex body, and which part bounds it at either end.
struct Stretch {
    double enter = -infinity, leave = infinity;
    std::uint32_t enter_part = 0, leave_part = 0;
};

/// A line near the frustum: s is its height along the axis in axis lengths, counted from the middle; r the radius of the cone there.
struct LocalLine {
    Vec3 f_perp, d_perp;
    double f_s, d_s, f_r, d_r;
};

/// The part of the line inside the infinite side surface, on the nappe where the radius is positive. False if there is none.
bool clip_by_side(const LocalLine& line, Stretch& stretch) {
    const double a = dot(line.d_perp, line.d_perp) - sqr(line.d_r) + 0.0;  // + 0 turns -0 into +0: the sign of q / a matters
    const double b = dot(line.f_perp, line.d_perp) - line.f_r * line.d_r;
    const double c = dot(line.f_perp, line.f_perp) - sqr(line.f_r);
    double discriminant = b * b - a * c;
    if (a < 0.0) discriminant = std::fmax(discriminant, 0.0);  // a line steeper than the cone always meets it
    if (!(discriminant >= 0.0)) return false;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0.0 && a == 0.0) return c <= 0.0;  // along the side, or parallel to the axis of a cylinder
    double t0 = q / a;
    double t1 = q == 0.0 ? t0 : c / q;
    if (t0 > t1) std::swap(t0, t1);
    if (a >= 0.0) {
        stretch.enter = t0;
        stretch.leave = t1;
    } else if (line.d_r > 0.0) {
        stretch.enter = t1;
    } else {
        stretch.leave = t0;
    }
    return true;
}

/// Cuts the stretch to the heights between the caps.
bool clip_by_caps(const LocalLine& line, Stretch& stretch) {
    if (line.d_s == 0.0) return std::fabs(line.f_s) <= 0.5;
    const bool upward = line.d_s > 0.0;
    const double t_in = ((upward ? -0.5 : 0.5) - line.f_s) / line.d_s;
    const double t_out = ((upward ? 0.5 : -0.5) - line.f_s) / line.d_s;
    if (t_in > stretch.enter) {
        stretch.enter = t_in;
        stretch.enter_part = upward ? 1 : 2;
    }
    if (t_out < stretch.leave) {
        stretch.leave = t_out;
        stretch.leave_part = upward ? 2 : 1;
    }
    return stretch.enter <= stretch.leave;
}

bool is_double(const Cone& cone) {
    return std::fmin(cone.base_radius, cone.cap_radius) < 0.0 && std::fmax(cone.base_radius, cone.cap_radius) > 0.0;
}

/// The nearer hit of the two cones that a double one consists of.
bool intersect_double(const Cone& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    const Vec3 tip = shape.base + shape.base_radius / (shape.base_radius - shape.cap_radius) * (shape.cap - shape.base);
    const Cone lower{shape.base, std::fabs(shape.base_radius), tip, 0.0, shape.open};
    const Cone upper{tip, 0.0, shape.cap, std::fabs(shape.cap_radius), shape.open};
    const bool meets_lower = intersect(lower, ray, range, hit);
    ShapeHit other;
    if (!intersect(upper, ray, range, other) || (meets_lower && hit.t < other.t)) return meets_lower;
    hit = other;
    return true;
}

}  // namespace

// The frustum is convex, so the line is inside for one stretch: that of the side cut by that of the caps. Deciding by stretches instead of
// testing side and discs each for itself leaves no gap at the rims. Far origins are first moved next to the axis, where squares are small.
bool intersect(const Cone& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    if (is_double(shape)) return intersect_double(shape, ray, range, hit);
    const Vec3 axis = shape.cap - shape.base;
    const double axis2 = dot(axis, axis);
    const Vec3& d = ray.direction;
    const double d2 = dot(d, d);
    const Vec3 far = ray.origin - 0.5 * (shape.base + shape.cap);
    const double to_middle = -dot(far, d) / d2;
    Vec3 f = far + to_middle * d;

    LocalLine line;
    line.d_s = dot(d, axis) / axis2;
    line.d_perp = d - line.d_s * axis;
    const double limit = std::sqrt(axis2 / d2);
    const double to_axis = -dot(f, line.d_perp) / dot(line.d_perp, line.d_perp);
    const double step = std::isfinite(to_axis) ? std::fmin(std::fmax(to_axis, -limit), limit) : 0.0;
    const double shift = to_middle + step;
    f = far + shift * d;
    line.f_s = dot(f, axis) / axis2;
    line.f_perp = f - line.f_s * axis;
    const double growth = shape.cap_radius - shape.base_radius;
    line.f_r = 0.5 * (shape.base_radius + shape.cap_radius) + growth * line.f_s;
    line.d_r = growth * line.d_s;

    Stretch stretch;
    if (!clip_by_side(line, stretch) || !clip_by_caps(line, stretch)) return false;
    const double t_enter = shift + stretch.enter;
    const double t_leave = shift + stretch.leave;
    if (range.contains(t_enter) && !(shape.open && stretch.enter_part != 0)) {
        hit.t = t_enter;
        hit.part = stretch.enter_part;
    } else if (range.contains(t_leave) && !(shape.open && stretch.leave_part != 0)) {
        hit.t = t_leave;
        hit.part = stretch.leave_part;
    } else {
        return false;
    }
    return true;
}

Vec3 normal(const Cone& shape, const Vec3& point, const ShapeHit& hit) {
    const Vec3 axis = shape.cap - shape.base;
    if (hit.part != 0) return hit.part == 1 ? -axis : axis;
    const double axis2 = dot(axis, axis);
    const Vec3 p = point - 0.5 * (shape.base + shape.cap);
    const Vec3 perp = p - (dot(p, axis) / axis2) * axis;
    const double distance = length(perp);
    const double change = shape.cap_radius - shape.base_radius;
    const double radius = 0.5 * (shape.base_radius + shape.cap_radius) + change * dot(p, axis) / axis2;
    const double growth = radius < 0.0 ? -change : change;
    if (distance == 0.0) return growth > 0.0 ? -axis : axis;  // the tip has no tangent plane: face along the axis
    return perp / distance - (growth / axis2) * axis;
}

bool contains(const Cone& shape, const Vec3& point) {
    const Vec3 axis = shape.cap - shape.base;
    const Vec3 from_base = point - shape.base;
    const double along = dot(from_base, axis) / dot(axis, axis);
    if (!(along > 0.0 && along < 1.0)) return false;
    return length(from_base - along * axis) < std::fabs(shape.base_radius + along * (shape.cap_radius - shape.base_radius));
}

Bounds bounds(const Cone& shape) {
    const Vec3 axis = shape.cap - shape.base;
    const Vec3 w2 = axis * axis / dot(axis, axis);
    // A disc reaches r sin(angle between coordinate axis and cone axis); the two other components give it without cancellation.
    const Vec3 reach(std::sqrt(w2.y + w2.z), std::sqrt(w2.z + w2.x), std::sqrt(w2.x + w2.y));
    const Vec3 base = std::fabs(shape.base_radius) * reach;
    const Vec3 cap = std::fabs(shape.cap_radius) * reach;
    Bounds b{shape.base - base, shape.base + base};
    b.extend(Bounds{shape.cap - cap, shape.cap + cap});
    return rounded_outward(b);
}

}  // namespace rt
