// Which interiors a ray is inside of, in the order in which it entered them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world/world.h"

namespace rt {

/// Meeting the surface of an object while inside the interiors of a list. Membership decides whether it is entered or left, not the normal.
struct Crossing {
    static constexpr std::size_t outside = static_cast<std::size_t>(-1);
    std::uint32_t interior = 0;
    std::size_t position = outside;  ///< of `interior` in the list; `outside` when it is being entered
    double ratio = 1.0;              ///< index before the surface over the index behind it
    double fresnel_eta = 1.0;        ///< relative index of the surface's own reflection
    bool leaves() const { return position != outside; }
};

inline double ratio_of_indices(double before, double behind) {
    const double ratio = before / behind;
    return ratio == 0.0 || !std::isfinite(ratio) ? 1.0 : ratio;
}

inline Crossing meet(const World& world, std::span<const std::uint32_t> inside, std::uint32_t interior) {
    Crossing c;
    c.interior = interior;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (inside[i] == interior) c.position = i;
    }
    const double own = world.interiors[interior].ior;
    const auto ior = [&](std::size_t i) { return world.interiors[inside[i]].ior; };
    if (inside.empty()) {
        c.ratio = ratio_of_indices(1.0, own);
        c.fresnel_eta = own;
        return c;
    }
    const double last = ior(inside.size() - 1);
    if (!c.leaves()) {
        c.ratio = ratio_of_indices(last, own);
        c.fresnel_eta = own / last;
    } else {
        if (c.position + 1 == inside.size()) c.ratio = ratio_of_indices(own, inside.size() > 1 ? ior(inside.size() - 2) : 1.0);
        c.fresnel_eta = inside.size() == 1 ? 1.0 / own : last / own;
    }
    return c;
}

/// Passes through the surface: `list` from index `first` on is the list that `crossing` was met with.
inline void cross(std::vector<std::uint32_t>& list, std::size_t first, const Crossing& crossing) {
    if (crossing.leaves()) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(first + crossing.position));
    } else {
        list.push_back(crossing.interior);
    }
}

}  // namespace rt
