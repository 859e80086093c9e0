// From a surface's kind to the shape behind it.
#pragma once

#include <stdexcept>

#include "world/surfaces.h"

namespace rt {

/// Calls `f` with the shape behind a surface that is not made of triangles.
template <typename F>
auto visit_shape(const Surfaces& all, const Surface& s, F f) {
    switch (s.kind) {
        case SurfaceKind::sphere:
            return f(all.spheres[s.first]);
        case SurfaceKind::plane:
            return f(all.planes[s.first]);
        case SurfaceKind::placed_sphere:
            return f(all.placed_spheres[s.first]);
        case SurfaceKind::box:
            return f(all.boxes[s.first]);
        case SurfaceKind::cone:
            return f(all.cones[s.first]);
        case SurfaceKind::torus:
            return f(all.toruses[s.first]);
        case SurfaceKind::disc:
            return f(all.discs[s.first]);
        case SurfaceKind::polygon:
            return f(all.polygons[s.first]);
        case SurfaceKind::further:
            return f(all.further[s.first]);
        case SurfaceKind::part: {
            Surface shape = s;
            shape.kind = all.parts[s.part].kind;
            return visit_shape(all, shape, f);
        }
        case SurfaceKind::triangles:
        case SurfaceKind::part_triangles:
            break;
    }
    throw std::logic_error("triangles are visited face by face");
}

template <typename T>
inline constexpr bool is_placed = false;
template <typename S>
inline constexpr bool is_placed<Placed<S>> = true;

}  // namespace rt
