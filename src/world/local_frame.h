// The box of the indexed surfaces: its local coordinates for single precision, and where rays enter it.
#pragma once

#include <algorithm>

#include "core/ray.h"

namespace rt {

/// The scene's box mapped to [-1, 1]^3: Embree's single precision then has the same absolute error whatever the scene's units and place.
struct LocalFrame {
    Vec3 centre{0.0};
    double scale = 1.0;  ///< a power of two, at least half the longest side
    double inverse_scale = 1.0;

    explicit LocalFrame(const Bounds& box);
    Vec3 to_local(const Vec3& p) const { return (p - centre) * inverse_scale; }
};

inline Bounds grown(const Bounds& box, double by) { return {box.min - Vec3(by), box.max + Vec3(by)}; }

/// Cuts the range to its part inside the box; false if there is none.
inline bool clip(const Ray& ray, const Bounds& box, Interval& range) {
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0.0) {
            if (o < box.min[axis] || o > box.max[axis]) return false;
            continue;
        }
        const double inverse = 1.0 / d;
        const double a = (box.min[axis] - o) * inverse;
        const double b = (box.max[axis] - o) * inverse;
        range.min = std::max(range.min, std::min(a, b));
        range.max = std::min(range.max, std::max(a, b));
    }
    return range.min <= range.max;
}

}  // namespace rt
