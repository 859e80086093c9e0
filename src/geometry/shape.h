// Every shape there is. A shape's header holds its data, where a ray meets it, its normal and its bounds, in object space and in doubles:
//
//     bool intersect(const S&, const Ray&, const Interval&, ShapeHit&);   nearest hit with t inside the interval; true if there is one
//     Vec3 normal(const S&, const Vec3& point, const ShapeHit&);          not necessarily unit; as POV-Ray's "raw" normal, before any flip
//     Bounds bounds(const S&);                                            exact or outward; Bounds::everything() if unbounded
#pragma once

#include <variant>

#include "geometry/box.h"
#include "geometry/cone.h"
#include "geometry/disc.h"
#include "geometry/mesh.h"
#include "geometry/plane.h"
#include "geometry/polygon.h"
#include "geometry/sphere.h"
#include "geometry/torus.h"
#include "geometry/triangle.h"

namespace rt {

using Shape = std::variant<Sphere, Plane, Box, Cone, Torus, Disc, Triangle, SmoothTriangle, Polygon, Mesh>;

/// The shape's name as a scene writes it: "sphere", "smooth_triangle", ... A cone with equal radii is a "cylinder".
const char* name(const Shape& shape);

}  // namespace rt
