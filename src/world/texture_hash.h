// Hashes of what textures say.
#pragma once

#include <bit>
#include <cstdint>

#include "scene/texture.h"

namespace rt {

/// Combines numbers into a hash; equal values give equal hashes, zeros of both signs included.
class Hash {
public:
    Hash& operator<<(double x) { return mix(std::bit_cast<std::uint64_t>(x == 0.0 ? 0.0 : x)); }
    Hash& operator<<(const Vec3& v) { return *this << v.x << v.y << v.z; }
    Hash& mix(std::uint64_t bits) {
        state_ = (state_ ^ bits) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 29;
        return *this;
    }
    std::size_t value() const { return state_; }

private:
    std::uint64_t state_ = 0x243f6a8885a308d3u;
};

/// Equal textures have equal hashes; those that differ in a number mostly have different ones.
std::size_t content_hash(const std::vector<Texture>& layers);

}  // namespace rt
