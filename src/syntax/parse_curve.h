// What shapes that are made of plane curves read alike.
#pragma once

#include <vector>

#include "geometry/outline.h"
#include "syntax/reader.h"

namespace rt {

/// linear_spline, quadratic_spline, cubic_spline or bezier_spline.
bool accept_spline(Reader& reader, SplineKind& spline);
/// `count` points in the plane, with commas or without, also before the first.
std::vector<Vec2> parse_points(Reader& reader, std::size_t count);

}  // namespace rt
