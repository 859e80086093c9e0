// Four triangles that lie close together, tested in single precision at once by a test that never rejects what a test in doubles accepts.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "world/surfaces.h"

namespace rt {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// The scene's box mapped to [-1, 1]^3: Embree's single precision then has the same absolute error whatever the scene's units and place.
struct LocalFrame {
    Vec3 centre{0.0};
    double scale = 1.0;  ///< a power of two, at least half the longest side
    double inverse_scale = 1.0;

    explicit LocalFrame(const Bounds& box);
    Vec3 to_local(const Vec3& p) const { return (p - centre) * inverse_scale; }
};

/// A ray in local single precision, sheared as in `TriangleRay`.
struct BlockRay {
    BlockRay(const Vec3& local_origin, const TriangleRay& r)
        : kx(r.kx), ky(r.ky), kz(r.kz), sx(static_cast<float>(r.sx)), sy(static_cast<float>(r.sy)) {
        ox = static_cast<float>(local_origin[kx]);
        oy = static_cast<float>(local_origin[ky]);
        oz = static_cast<float>(local_origin[kz]);
    }
    int kx, ky, kz;
    float sx, sy;
    float ox, oy, oz;
};

struct TriangleBlock {
    Float4 corner[3][3];  ///< [corner][axis], local
    std::array<std::uint32_t, 4> face;
    std::uint32_t lanes;  ///< bit i: lane i holds a triangle
};

/// Bits of the lanes whose triangle the line of the ray may meet. With local coordinates in [-1, 1] every sheared coordinate is wrong by
/// less than 2e-6: 2^-25 from each of corner and origin, 2^-24 of a number up to 2 from each of the differences, the shear, the product
/// and the last subtraction. An edge function cx by - cy bx is then wrong by less than delta (|bx| + |by| + |cx| + |cy|) + 2 delta^2 with
/// delta = 3e-6, its own rounding included; a lane is dropped only if two edge functions have opposite signs beyond that. 1e-6 are left
/// for the rounding of the test in doubles.
inline std::uint32_t lanes_met(const TriangleBlock& block, const BlockRay& ray) {
    constexpr float delta = 4e-6f;
    Float4 x[3], y[3];
    Float4 size{};
    for (int i = 0; i < 3; ++i) {
        const Float4 z = block.corner[i][ray.kz] - ray.oz;
        x[i] = block.corner[i][ray.kx] - ray.ox - ray.sx * z;
        y[i] = block.corner[i][ray.ky] - ray.oy - ray.sy * z;
        size += (x[i] < 0.0f ? -x[i] : x[i]) + (y[i] < 0.0f ? -y[i] : y[i]);
    }
    const Float4 error = delta * size + 2.0f * delta * delta;
    const Float4 u = x[2] * y[1] - y[2] * x[1];
    const Float4 v = x[0] * y[2] - y[0] * x[2];
    const Float4 w = x[1] * y[0] - y[1] * x[0];
    const Int4 negative = (u < -error) | (v < -error) | (w < -error);
    const Int4 positive = (u > error) | (v > error) | (w > error);
    const Int4 met = ~(negative & positive) & Int4{1, 2, 4, 8};
    return static_cast<std::uint32_t>(met[0] | met[1] | met[2] | met[3]) & block.lanes;
}

/// Groups the given faces into blocks of neighbours.
std::vector<TriangleBlock> make_blocks(const Surfaces& surfaces, const std::vector<std::uint32_t>& faces, const LocalFrame& frame);

}  // namespace rt
