// Blob: where the fields of spheres and round-ended cylinders add up to a threshold.
#pragma once

#include <vector>

#include "core/shared.h"
#include "geometry/hit_sink.h"
#include "geometry/texture_weight.h"

namespace rt {

/// Of strength (1 - (rho / radius)^2)^2 at the distance rho from the segment between two points, in the component's own space.
struct BlobComponent {
    Vec3 base{0.0}, cap{0.0};  ///< equal for a sphere
    double radius = 1.0;
    double strength = 1.0;
    bool moved = false;                                ///< false: the two maps are identities
    std::uint32_t texture = TextureWeight::of_object;  ///< one of those that the blob states, by its number
    Mat3 to_own{1.0};                                  ///< from the blob's space: p -> to_own p + own_offset
    Vec3 own_offset{0.0};
    Bounds box;  ///< in the blob's space
    bool operator==(const BlobComponent&) const;
};

struct BlobData {
    std::vector<BlobComponent> components;
    double threshold = 1.0;
    bool operator==(const BlobData&) const = default;
};

/// Inside is where the sum exceeds the threshold.
struct Blob {
    Shared<BlobData> data;
    static constexpr const char* word = "blob";
    bool operator==(const Blob&) const = default;
};

/// Along a ray the sum is a polynomial of degree 4 from one border of a component to the next. A hit is wrong by a small multiple of 2^-53
/// of the components' sizes and strengths, divided by the field's gradient. A ray that only touches has no hit.
void find_hits(const Blob& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Blob& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const Blob& shape, const Vec3& point);
Bounds bounds(const Blob& shape);
/// Appends what shows at a point of the surface, each texture once: that of a component by the share of its field, of either sign, in the
/// sum of all that act there; of components whose share is not below `least`.
void texture_weights(const Blob& shape, const Vec3& point, double least, std::vector<TextureWeight>& out);

}  // namespace rt
