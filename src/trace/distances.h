// Where a ray that leaves a surface begins and how far it looks: POV-Ray's absolute lengths, or lengths that follow the error of the hit
// point.
#pragma once

#include <algorithm>

#include "core/ray.h"
#include "trace/options.h"

namespace rt {

struct Footprint;

/// A point where a ray met a surface.
struct SurfacePoint {
    Vec3 point{0.0};
    Vec3 normal{0.0};     ///< unit, turned against the ray
    Vec3 side{0.0};       ///< unit, of either sign: stands on the surface itself, where `normal` may be interpolated
    Vec3 direction{0.0};  ///< the ray's, unit
    double t = 0.0;       ///< length of the ray up to here
    double error = 0.0;   ///< bound of the distance between `point` and the surface; 0 where it does not matter
    std::uint32_t object = 0;
    bool inside = false;                   ///< the ray came from the side away from the shape's own normal
    const Footprint* footprint = nullptr;  ///< of a camera's ray, where highlights are widened
};

class DistanceRules {
public:
    /// Of `World`: the largest coordinate of its bounded surfaces, and how large they are together.
    DistanceRules(Distances kind, double scene_extent, double scene_size)
        : povray_(kind == Distances::povray), floor_(16.0 * epsilon * scene_extent), size_(far * scene_size) {}

    /// Rounding of a point reached by a ray of length t, and of the shape there: never below the spacing of the largest coordinate in the
    /// scene. What a shape's own equation loses is relative to the lengths that it is made of, and generous (2^-33): a torus is a quartic,
    /// a triangle may be a needle. Coordinates far beyond the scene's size say only where it is; of them a few roundings are left, and
    /// those of a transform that stretches (2^-44).
    double point_error(const Vec3& p, double t) const {
        if (povray_) return 0.0;
        const double largest = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        const double own = std::min(largest, size_);
        return floor_ + relative * (own + t) + of_place * (largest - own);
    }

    /// Origin of a ray from `at` towards `direction`. Scaled rule: moved off the surface along the normal, so that a grazing ray clears it
    /// too (Waechter, Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection").
    Vec3 leave(const SurfacePoint& at, const Vec3& direction) const {
        if (povray_) return at.point;
        return at.point + (dot(at.side, direction) < 0.0 ? -at.error : at.error) * at.side;
    }

    /// Where traced rays find hits.
    Interval traced() const { return povray_ ? Interval{1e-4, 1e7} : Interval{0.0, infinity}; }

    /// Where a ray of length `distance` towards a light finds blockers.
    Interval shadow(double distance, double error) const {
        if (povray_) return {1e-3, std::min(distance - 1e-3, 1e7)};
        return {0.0, distance * (1.0 - relative) - 2.0 * error};
    }

private:
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();
    static constexpr double relative = 0x1p-33;
    static constexpr double of_place = 0x1p-44;
    static constexpr double far = 256.0;
    bool povray_;
    double floor_;
    double size_;
};

}  // namespace rt
