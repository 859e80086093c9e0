// Where a function takes a value, inside of a box or a ball. As POV-Ray searches it: not exact, but cut in halves down to an accuracy.
#pragma once

#include <memory>
#include <variant>

#include "core/function.h"
#include "geometry/box.h"
#include "geometry/hit_sink.h"
#include "geometry/sphere.h"

namespace rt {

struct Isosurface {
    std::shared_ptr<const Function> function;  ///< of x, y and z; what is inside lies below the threshold
    double threshold = 0.0;
    double max_gradient = 1.1;  ///< where the function is steeper, surfaces are missed
    double accuracy = 1e-3;     ///< in the world's lengths, if the ray's direction is unit there
    int max_trace = 1;          ///< hits of a ray
    bool open = false;          ///< the container has no surface where it cuts what is inside
    std::variant<Box, Sphere> container = Box{};
    static constexpr const char* word = "isosurface";
    bool operator==(const Isosurface&) const = default;
};

/// POV-Ray's `all_intersections`, and the most that `max_trace` may be.
inline constexpr int most_isosurface_hits = 10;

/// Only beyond the ray's origin. `part` is 0 for the surface, and above it where it is the container's.
void find_hits(const Isosurface& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Isosurface& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const Isosurface& shape, const Vec3& point);
Bounds bounds(const Isosurface& shape);

}  // namespace rt
