// Every shape there is. A shape's header holds its data, where a ray meets it, its normal and its bounds, in object space and in doubles:
//
//     bool intersect(const S&, const Ray&, const Interval&, ShapeHit&);   nearest hit with t inside the interval; true if there is one
//     Vec3 normal(const S&, const Vec3& point, const ShapeHit&);          not necessarily unit; as POV-Ray's "raw" normal, before any flip
//     Bounds bounds(const S&);                                            exact or outward; Bounds::everything() if unbounded
//     bool contains(const S&, const Vec3& point);                         inside of it as set operations ask: within `hit_error` of its
//                                                                         surface either answer will do; sheets contain nothing
//
// Set operations ask for one hit after the other: where a ray meets a shape must not depend on the interval it is asked for, so that the
// interval from one hit's t on begins with the next hit. A shape whose hits are costly to find anew has its own `visit_hits` (hits.h).
#pragma once

#include <variant>

#include "geometry/box.h"
#include "geometry/cone.h"
#include "geometry/disc.h"
#include "geometry/further_shape.h"
#include "geometry/mesh.h"
#include "geometry/plane.h"
#include "geometry/polygon.h"
#include "geometry/sphere.h"
#include "geometry/torus.h"
#include "geometry/triangle.h"

namespace rt {

using Shape = std::variant<Sphere, Plane, Box, Cone, Torus, Disc, Triangle, SmoothTriangle, Polygon, Mesh, FurtherShape>;

/// The shape's name as a scene writes it: "sphere", "smooth_triangle", ... A cone with equal radii is a "cylinder".
const char* name(const Shape& shape);

/// Surfaces without an inside, of which `contains` is always false.
bool is_sheet(const Shape& shape);

}  // namespace rt
