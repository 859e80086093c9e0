// From a surface's kind to the shape behind it.
#pragma once

#include <stdexcept>

#include "world/surfaces.h"

namespace rt {

/// Calls `f` with shape number `first` of a kind that is neither triangles nor a part.
template <typename F>
auto visit_shape(const Surfaces& all, SurfaceKind kind, std::uint32_t first, F f) {
    switch (kind) {
        case SurfaceKind::sphere:
            return f(all.spheres[first]);
        case SurfaceKind::plane:
            return f(all.planes[first]);
        case SurfaceKind::placed_sphere:
            return f(all.placed_spheres[first]);
        case SurfaceKind::box:
            return f(all.boxes[first]);
        case SurfaceKind::cone:
            return f(all.cones[first]);
        case SurfaceKind::torus:
            return f(all.toruses[first]);
        case SurfaceKind::disc:
            return f(all.discs[first]);
        case SurfaceKind::polygon:
            return f(all.polygons[first]);
        case SurfaceKind::further:
            return f(all.further[first]);
        case SurfaceKind::part:
        case SurfaceKind::triangles:
        case SurfaceKind::part_triangles:
            break;
    }
    throw std::logic_error("triangles are visited face by face");
}

/// Calls `f` with the shape behind a surface that is not made of triangles.
template <typename F>
auto visit_shape(const Surfaces& all, const Surface& s, F f) {
    return visit_shape(all, s.kind == SurfaceKind::part ? all.parts[s.part].kind : s.kind, s.first, f);
}

template <typename T>
inline constexpr bool is_placed = false;
template <typename S>
inline constexpr bool is_placed<Placed<S>> = true;

}  // namespace rt
