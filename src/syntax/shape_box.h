// The boxes that POV-Ray puts around shapes, measured: often looser than they need be.
#pragma once

#include <optional>

#include "geometry/shape.h"

namespace rt {

/// The box around the moved corners.
Bounds around_moved(const Bounds& box, const Mat3& linear, const Vec3& offset);
Bounds shape_box(const Shape& shape, const std::optional<Transform>& transform);

}  // namespace rt
