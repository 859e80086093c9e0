// The triangles of a bicubic patch, as many as its shape asks for.
#pragma once

#include "core/transform.h"
#include "geometry/mesh.h"

namespace rt {

/// As POV-Ray does it: pieces are halved along u and v together while they may be and are not flat, and become two smooth triangles each.
/// How flat they are counts after `to_world`, which the mesh is still to be moved by.
MeshData triangles_of(const BezierPatch& patch, const Transform& to_world);

}  // namespace rt
