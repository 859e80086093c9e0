// Prism: an area of the xz plane swept along y; conic ones are as wide as they are high, with their tip at the origin.
#pragma once

#include "core/shared.h"
#include "geometry/outline.h"

namespace rt {

struct Prism {
    Shared<Outline> outline;  ///< in (x, z); of a conic one at y = 1
    double low = 0.0, high = 1.0;
    bool conic = false;
    bool open = false;  ///< without the two flat ends
    static constexpr const char* word = "prism";
    bool operator==(const Prism&) const = default;
};

/// Parts as those of a sweep: 0 and 1 the ends, 2 + i the wall over piece i.
void find_hits(const Prism& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Prism& shape, const Vec3& point, const ShapeHit& hit);
/// An open prism is closed by its ends here.
bool contains(const Prism& shape, const Vec3& point);
Bounds bounds(const Prism& shape);

}  // namespace rt
