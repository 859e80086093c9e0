#include "world/triangle_block.h"

#include <algorithm>
#include <glm/common.hpp>
#include <span>

namespace rt {

namespace {

struct Centre {
    std::array<float, 3> at;
    std::uint32_t face;
};

TriangleBlock make_block(const Surfaces& surfaces, std::span<const Centre> group, const LocalFrame& frame) {
    TriangleBlock block{};
    block.lanes = (1u << group.size()) - 1u;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        // Empty lanes repeat the first triangle: their numbers must be ordinary ones.
        const std::uint32_t face = group[lane < group.size() ? lane : 0].face;
        block.face[lane] = face;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p = frame.to_local(surfaces.vertices[surfaces.faces[face][corner]]);
            for (int axis = 0; axis < 3; ++axis) block.corner[corner][axis][lane] = static_cast<float>(p[axis]);
        }
    }
    return block;
}

/// Halves at the median of the longest axis, the left half a multiple of four so that only the last block is not full.
void split(const Surfaces& surfaces, std::span<Centre> group, const LocalFrame& frame, std::vector<TriangleBlock>& out) {
    if (group.size() <= 4) {
        out.push_back(make_block(surfaces, group, frame));
        return;
    }
    std::array<float, 3> low = group[0].at, high = group[0].at;
    for (const Centre& c : group) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], c.at[axis]);
            high[axis] = std::max(high[axis], c.at[axis]);
        }
    }
    std::size_t axis = 0;
    for (std::size_t other = 1; other < 3; ++other)
        if (high[other] - low[other] > high[axis] - low[axis]) axis = other;
    const std::size_t half = (group.size() / 2 + 3) / 4 * 4;
    std::nth_element(
        group.begin(), group.begin() + static_cast<std::ptrdiff_t>(half), group.end(),
        [axis](const Centre& a, const Centre& b) { return a.at[axis] < b.at[axis] || (a.at[axis] == b.at[axis] && a.face < b.face); });
    split(surfaces, group.first(half), frame, out);
    split(surfaces, group.subspan(half), frame, out);
}

}  // namespace

LocalFrame::LocalFrame(const Bounds& box) : centre(0.5 * box.min + 0.5 * box.max) {
    // Far from the origin the rounding of doubles themselves must stay small against the unit.
    const double away = max_component(glm::abs(centre));
    const double half = std::fmax(0.5 * max_component(box.max - box.min), std::ldexp(away, -27));
    int exponent = 0;
    std::frexp(half > 0.0 ? half : 1.0, &exponent);
    // The largest power of two whose inverse is a normal number bounds the other end.
    scale = std::ldexp(1.0, std::max(exponent, -1020));
    inverse_scale = 1.0 / scale;
}

std::vector<TriangleBlock> make_blocks(const Surfaces& surfaces, const std::vector<std::uint32_t>& faces, const LocalFrame& frame) {
    std::vector<Centre> centres;
    centres.reserve(faces.size());
    for (const std::uint32_t face : faces) {
        const auto& f = surfaces.faces[face];
        const Vec3 a = frame.to_local(surfaces.vertices[f[0]]);
        const Vec3 b = frame.to_local(surfaces.vertices[f[1]]);
        const Vec3 c = frame.to_local(surfaces.vertices[f[2]]);
        const glm::vec3 middle((a + b + c) / 3.0);
        centres.push_back({{middle.x, middle.y, middle.z}, face});
    }
    std::vector<TriangleBlock> blocks;
    blocks.reserve((centres.size() + 3) / 4);
    if (!centres.empty()) split(surfaces, centres, frame, blocks);
    return blocks;
}

}  // namespace rt
