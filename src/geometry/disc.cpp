#include "geometry/disc.h"

namespace rt {

Bounds bounds(const Disc& shape) {
    // Along each axis the disc reaches r sin(angle between axis and normal); the two other components give that sine without cancellation.
    const Vec3 n2 = shape.normal * shape.normal;
    const Vec3 reach(std::sqrt(n2.y + n2.z), std::sqrt(n2.z + n2.x), std::sqrt(n2.x + n2.y));
    const Vec3 r = std::fabs(shape.radius) * reach;
    return rounded_outward({shape.center - r, shape.center + r});
}

}  // namespace rt
