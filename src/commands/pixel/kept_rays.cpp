#include "commands/pixel/kept_rays.h"

#include <algorithm>
#include <numeric>

namespace rt {

namespace {

/// Places of the rays that stay, in order: by the number of their ancestors, then by place.
std::vector<std::uint32_t> nearest_to_the_camera(const RayLog& log, std::size_t most) {
    std::vector<std::uint32_t> ancestors(log.nodes.size(), 0), rays(log.nodes.size());
    for (std::size_t i = 0; i < log.nodes.size(); ++i)
        if (log.nodes[i].parent != RayNode::none) ancestors[i] = ancestors[log.nodes[i].parent] + 1;
    std::iota(rays.begin(), rays.end(), 0u);
    std::stable_sort(rays.begin(), rays.end(), [&](std::uint32_t a, std::uint32_t b) { return ancestors[a] < ancestors[b]; });
    rays.resize(std::min(rays.size(), std::max<std::size_t>(most, 1)));
    std::sort(rays.begin(), rays.end());
    return rays;
}

}  // namespace

std::vector<KeptRay> keep_rays(const RayLog& log, std::size_t most) {
    std::vector<KeptRay> kept;
    /// For every ray the place among the kept ones of itself, or of its last ancestor that is kept.
    std::vector<std::uint32_t> place(log.nodes.size(), RayNode::none);
    const std::vector<std::uint32_t> rays = nearest_to_the_camera(log, most);
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < log.nodes.size(); ++i) {
        const std::uint32_t parent = log.nodes[i].parent;
        const std::uint32_t above = parent == RayNode::none ? RayNode::none : place[parent];
        if (next < rays.size() && rays[next] == i) {
            ++next;
            place[i] = static_cast<std::uint32_t>(kept.size());
            kept.push_back({i, above, 0});
        } else {
            place[i] = above;
            ++kept[above].left_out;
        }
    }
    return kept;
}

}  // namespace rt
