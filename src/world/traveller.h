// A ray on its way through the index, and the tests of the primitives that it comes by.
#pragma once

#include <bit>
#include <optional>
#include <vector>

#include "world/triangle_block.h"

namespace rt {

/// What is in the index, by kind.
struct IndexData {
    IndexData(const Surfaces& s, const Bounds& box) : surfaces(s), frame(box) {}
    const Surfaces& surfaces;
    std::vector<IndexedSphere> spheres;  ///< objects that are spheres in world space
    std::vector<std::uint32_t> bodies;   ///< the other objects that are not made of triangles
    std::vector<std::uint32_t> faces;    ///< all triangles but those of parts of sets
    std::vector<TriangleBlock> blocks;   ///< the same in blocks, if they are tested in doubles
    std::vector<std::uint32_t> part_faces;
    std::vector<TriangleBlock> part_blocks;
    LocalFrame frame;
};

/// A ray in the index: its query, and its local form from where it enters the box.
struct Traveller {
    /// Room above the distance that a search in single precision may cull by.
    static constexpr double far_slack = 4e-6;

    Traveller(const LocalFrame& frame, Query& q, double start)
        : query(q), t_start(start), inverse_scale(frame.inverse_scale), origin(frame.to_local(q.ray.at(start))) {}
    /// The local distance beyond which nothing can be the nearest hit, rounded up.
    float far(double t) const { return static_cast<float>((t - t_start) * inverse_scale * (1.0 + 1e-6) + far_slack); }
    /// Made when the first block is met: most rays of most scenes meet none.
    const BlockRay& block_ray() {
        if (!block_ray_) block_ray_.emplace(origin, query.sheared());
        return *block_ray_;
    }

    Query& query;
    double t_start;  ///< where the ray enters the scene's box
    double inverse_scale;
    Vec3 origin;  ///< local, at t_start

private:
    std::optional<BlockRay> block_ray_;
};

// Each offers the primitive of that number in its list to the ray's query; true if it is the best hit so far. `far` is the local distance
// beyond which nothing counts; with `any`, one hit is enough.

inline bool test_sphere(const IndexData& data, Traveller& ray, unsigned index, float, bool) { return data.spheres[index].test(ray.query); }

inline bool test_body(const IndexData& data, Traveller& ray, unsigned index, float, bool) {
    return data.surfaces.test(data.bodies[index], ray.query);
}

/// Tests the triangles of some lanes in doubles until one is met, or all of them. Kept out of the callbacks: most blocks are dropped there,
/// and they should not pay for the registers that this needs.
template <bool of_part>
[[gnu::noinline]] bool test_lanes(const IndexData& data, const TriangleBlock& block, std::uint32_t lanes, Query& query, bool any) {
    bool met = false;
    for (; lanes != 0 && !(met && any); lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        if (!(block.seen[lane] & query.seen)) continue;
        if constexpr (of_part)
            met |= data.surfaces.test_part_face(block.face[lane], query);
        else
            met |= data.surfaces.test_face(block.face[lane], query);
    }
    return met;
}

template <bool of_part>
bool test_lanes_met(const IndexData& data, Traveller& ray, const TriangleBlock& block, float far, bool any) {
    const std::uint32_t lanes = lanes_met(block, ray.block_ray(), far);
    return lanes != 0 && test_lanes<of_part>(data, block, lanes, ray.query, any);
}

inline bool test_block(const IndexData& data, Traveller& ray, unsigned index, float far, bool any) {
    return test_lanes_met<false>(data, ray, data.blocks[index], far, any);
}

inline bool test_part_block(const IndexData& data, Traveller& ray, unsigned index, float far, bool any) {
    return test_lanes_met<true>(data, ray, data.part_blocks[index], far, any);
}

}  // namespace rt
