// Rays, parameter intervals and axis-aligned boxes.
#pragma once

#include <limits>

#include "core/vec.h"

namespace rt {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Points origin + t * direction. World-space directions are unit vectors; object-space ones keep world t and need not be.
struct Ray {
    Vec3 origin;
    Vec3 direction;
    Vec3 at(double t) const { return origin + t * direction; }
};

/// The open interval of ray parameters in which a hit counts: min < t < max.
struct Interval {
    double min = 0.0;
    double max = infinity;
    bool contains(double t) const { return t > min && t < max; }
};

/// Axis-aligned box. The default one is empty; `is_finite` false marks an unbounded shape.
struct Bounds {
    Vec3 min{infinity};
    Vec3 max{-infinity};

    static Bounds everything() { return {Vec3(-infinity), Vec3(infinity)}; }
    void extend(const Vec3& p) {
        min = glm::dvec3(std::fmin(min.x, p.x), std::fmin(min.y, p.y), std::fmin(min.z, p.z));
        max = glm::dvec3(std::fmax(max.x, p.x), std::fmax(max.y, p.y), std::fmax(max.z, p.z));
    }
    void extend(const Bounds& b) {
        extend(b.min);
        extend(b.max);
    }
    bool is_finite() const { return rt::is_finite(min) && rt::is_finite(max); }
    bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
};

/// Faces, edges and corners belong to the box.
inline bool contains(const Bounds& box, const Vec3& p) {
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y && p.z >= box.min.z && p.z <= box.max.z;
}

/// What lies in both boxes; empty if nothing does.
inline Bounds common(const Bounds& a, const Bounds& b) {
    return {Vec3(std::fmax(a.min.x, b.min.x), std::fmax(a.min.y, b.min.y), std::fmax(a.min.z, b.min.z)),
            Vec3(std::fmin(a.max.x, b.max.x), std::fmin(a.max.y, b.max.y), std::fmin(a.max.z, b.max.z))};
}

}  // namespace rt
