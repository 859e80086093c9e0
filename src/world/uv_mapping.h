// Coordinates on surfaces, as POV-Ray lays them.
#pragma once

#include "world/shape_frame.h"

namespace rt {

/// (u, v) of a point of the surface, in world space. Spheres and tori are unrolled, u along the equator; boxes are unfolded to a cross;
/// of lathes and surfaces of revolution v runs along the curve;
/// meshes, of which face number `face` was met, state them; of what has no coordinates of its own they are x and y.
Vec2 uv_of(const ShapeFrame& frame, const Vec3& point, std::size_t face, const ShapeHit& hit);

}  // namespace rt
