// Axis-aligned box. Part 0..5 is the face -x +x -y +y -z +z.
#pragma once

#include "geometry/hit.h"

namespace rt {

struct Box {
    Vec3 min{-1.0};  ///< componentwise <= max
    Vec3 max{1.0};
    bool operator==(const Box&) const = default;
};

/// Where a line is inside one pair of parallel planes, and on which of the faces it enters and leaves.
struct Slabs {
    double enter = -infinity, leave = infinity;
    std::uint32_t enter_face = 0, leave_face = 0;

    /// A line along the planes is inside for ever or never; the division that would give NaN is not made. A NaN from the ray itself sticks.
    bool clip(double min, double max, double origin, double direction, std::uint32_t axis) {
        if (direction == 0.0) return origin >= min && origin <= max;
        const bool backward = direction < 0.0;
        const double t_in = ((backward ? max : min) - origin) / direction;
        const double t_out = ((backward ? min : max) - origin) / direction;
        if (!(t_in <= enter)) {
            enter = t_in;
            enter_face = 2 * axis + backward;
        }
        if (!(t_out >= leave)) {
            leave = t_out;
            leave_face = 2 * axis + !backward;
        }
        return enter <= leave;
    }
};

/// Kay and Kajiya 1986, "Ray Tracing Complex Scenes", with one division per plane. Faces, edges and corners belong to the box.
[[gnu::always_inline]] inline bool intersect(const Box& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    Slabs slabs;
    const Vec3& o = ray.origin;
    const Vec3& d = ray.direction;
    if (!slabs.clip(shape.min.x, shape.max.x, o.x, d.x, 0)) return false;
    if (!slabs.clip(shape.min.y, shape.max.y, o.y, d.y, 1)) return false;
    if (!slabs.clip(shape.min.z, shape.max.z, o.z, d.z, 2)) return false;
    if (range.contains(slabs.enter)) {
        hit.t = slabs.enter;
        hit.part = slabs.enter_face;
    } else if (range.contains(slabs.leave)) {
        hit.t = slabs.leave;
        hit.part = slabs.leave_face;
    } else {
        return false;
    }
    return true;
}

inline Vec3 normal(const Box&, const Vec3&, const ShapeHit& hit) {
    const double side = hit.part % 2 == 0 ? -1.0 : 1.0;
    const std::uint32_t axis = hit.part / 2;
    return {axis == 0 ? side : 0.0, axis == 1 ? side : 0.0, axis == 2 ? side : 0.0};
}

inline bool contains(const Box& shape, const Vec3& p) {
    return p.x > shape.min.x && p.x < shape.max.x && p.y > shape.min.y && p.y < shape.max.y && p.z > shape.min.z && p.z < shape.max.z;
}

inline Bounds bounds(const Box& shape) { return {shape.min, shape.max}; }

}  // namespace rt
