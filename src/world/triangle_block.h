// Four triangles that lie close together, tested in single precision at once by a test that never rejects what a test in doubles accepts.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "world/local_frame.h"
#include "world/surfaces.h"

namespace rt {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 smallest(Float4 a, Float4 b, Float4 c) {
    const Float4 ab = a < b ? a : b;
    return ab < c ? ab : c;
}
inline Float4 largest(Float4 a, Float4 b, Float4 c) {
    const Float4 ab = a > b ? a : b;
    return ab > c ? ab : c;
}
/// Bit i is set if lane i is true.
inline std::uint32_t lane_bits(Int4 lanes) {
#ifdef __SSE__
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(std::bit_cast<Float4>(lanes)));
#else
    const Int4 bits = lanes & Int4{1, 2, 4, 8};
    return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

/// A ray in local single precision, sheared as in `TriangleRay`; every number four times.
struct BlockRay {
    BlockRay(const Vec3& local_origin, const TriangleRay& r)
        : kx(r.kx),
          ky(r.ky),
          kz(r.kz),
          sx(Float4{} + static_cast<float>(r.sx)),
          sy(Float4{} + static_cast<float>(r.sy)),
          sz(Float4{} + static_cast<float>(r.sz)),
          ox(Float4{} + static_cast<float>(local_origin[r.kx])),
          oy(Float4{} + static_cast<float>(local_origin[r.ky])),
          oz(Float4{} + static_cast<float>(local_origin[r.kz])) {}
    int kx, ky, kz;
    Float4 sx, sy, sz;
    Float4 ox, oy, oz;
};

struct TriangleBlock {
    Float4 corner[3][3];  ///< [corner][axis], local
    Float4 error;         ///< of an edge function of a ray that meets the triangle
    std::array<std::uint32_t, 4> face;
    std::array<std::uint8_t, 4> seen;  ///< `Surface::seen` of each
    std::uint32_t lanes;               ///< bit i: lane i holds a triangle

    /// With local coordinates in [-1, 1] every sheared coordinate is wrong by less than delta: 2^-25 from each of corner and origin, 2^-24
    /// of a number up to 2 from each of the differences, the shear, the product and the last subtraction, in all less than 2e-6; the rest
    /// covers the rounding of the edge functions and of the test in doubles.
    static constexpr float delta = 4e-6f;

    /// If the line meets a triangle, no corner is farther from it than the longest edge, and after the shear |x| + |y| is at most sqrt(6)
    /// times that; so the edge function cx by - cy bx is wrong by less than 2 sqrt(6) longest delta + 2 delta^2.
    static constexpr float error_bound(float longest) { return 5.0f * delta * longest + 4.0f * delta * delta; }
};

/// Bits of the lanes whose triangle the ray may meet between 0 and `far`: a lane is dropped only if two edge functions have opposite signs
/// beyond their error, or all its corners lie before or behind that part of the ray.
inline std::uint32_t lanes_met(const TriangleBlock& block, const BlockRay& ray, float far) {
    Float4 x[3], y[3], z[3];
    for (int i = 0; i < 3; ++i) {
        z[i] = block.corner[i][ray.kz] - ray.oz;
        x[i] = block.corner[i][ray.kx] - ray.ox - ray.sx * z[i];
        y[i] = block.corner[i][ray.ky] - ray.oy - ray.sy * z[i];
        z[i] *= ray.sz;
    }
    const Float4 u = x[2] * y[1] - y[2] * x[1];
    const Float4 v = x[0] * y[2] - y[0] * x[2];
    const Float4 w = x[1] * y[0] - y[1] * x[0];
    const Float4 last = Float4{} + (far + TriangleBlock::delta), first = Float4{} - TriangleBlock::delta;
    const Int4 beside = (smallest(u, v, w) < -block.error) & (largest(u, v, w) > block.error);
    const Int4 away = (smallest(z[0], z[1], z[2]) > last) | (largest(z[0], z[1], z[2]) < first);
    return ~lane_bits(beside | away) & block.lanes;
}

/// The block of one to four faces.
TriangleBlock make_block(const Surfaces& surfaces, std::span<const std::uint32_t> faces, const LocalFrame& frame);

}  // namespace rt
