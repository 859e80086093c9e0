// Shapes that only some scenes use. The world keeps all of them in one list, so a new one is added here and to `find_shape` alone.
#pragma once

#include <variant>

#include "geometry/blob.h"
#include "geometry/height_field.h"
#include "geometry/isosurface.h"
#include "geometry/lathe.h"
#include "geometry/poly.h"
#include "geometry/prism.h"
#include "geometry/quadric.h"
#include "geometry/sor.h"
#include "geometry/sphere_sweep.h"
#include "geometry/superellipsoid.h"
#include "geometry/text.h"

namespace rt {

using FurtherShape = std::variant<Quadric, Poly, Prism, Text, Lathe, Sor, Blob, Superellipsoid, HeightField, SphereSweep, Isosurface>;

/// As a scene writes it.
inline const char* name(const FurtherShape& shape) {
    return std::visit([](const auto& one) { return one.word; }, shape);
}

inline void find_hits(const FurtherShape& shape, const Ray& ray, HitSink& sink) {
    std::visit([&](const auto& one) { find_hits(one, ray, sink); }, shape);
}
inline Vec3 normal(const FurtherShape& shape, const Vec3& point, const ShapeHit& hit) {
    return std::visit([&](const auto& one) { return normal(one, point, hit); }, shape);
}
/// The normal of the shape moved, at a point of its own space.
inline Vec3 moved_normal(const FurtherShape& shape, const Transform& to_world, const Vec3& point, const ShapeHit& hit) {
    if (const auto* field = std::get_if<HeightField>(&shape)) return moved_normal(*field, to_world, point, hit);
    return to_world.normal(normal(shape, point, hit));
}
inline bool contains(const FurtherShape& shape, const Vec3& point) {
    return std::visit([&](const auto& one) { return contains(one, point); }, shape);
}
inline Bounds bounds(const FurtherShape& shape) {
    return std::visit([](const auto& one) { return bounds(one); }, shape);
}
/// Whether all that `contains` holds of is inside the bounds, which are those of the surface.
inline bool bounds_hold_inside(const FurtherShape& shape) { return !std::holds_alternative<HeightField>(shape); }
/// Whether what the shape is bounded by is met before it, as of sets; of all other shapes POV-Ray takes nothing but the box.
inline bool keeps_bounds(const FurtherShape& shape) {
    if (const auto* quadric = std::get_if<Quadric>(&shape))
        return max_component(quadric->squares) > 0.0 && max_component(-quadric->squares) > 0.0;
    return std::holds_alternative<Poly>(shape) || std::holds_alternative<Text>(shape);
}

}  // namespace rt
