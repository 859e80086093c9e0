// Patterns of cells: which of its colours a point has. `p` is in pattern space.
#pragma once

#include "core/vec.h"
#include "patterns/checker.h"
#include "patterns/pattern.h"

namespace rt {

/// 0 mortar, 1 brick.
int brick(const BrickNumbers& numbers, const Vec3& p);
/// Hexagons with sides of length 1 in the plane of x and z: 0 to 2.
int hexagon(const Vec3& p);
/// Unit squares in the plane of x and z: 0 to 3.
int square(const Vec3& p);
/// Equilateral triangles with sides of length 1 in the plane of x and z: 0 to 5.
int triangular(const Vec3& p);
/// The face of a cube around the origin that `p` is seen through: 0 to 5.
int cubic(const Vec3& p);

}  // namespace rt
