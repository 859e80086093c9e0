// What can only be compared in a picture: normals, slopes, and patterns that POV-Ray gives no function for. Each case covers a cap of a
// sphere of radius 2.9 around its own origin, seen from above.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "patterns/pattern.h"

namespace rt {

/// A point of the sphere, its unit normal and the ray's direction.
struct CapPoint {
    Vec3 p;
    Vec3 normal;
    Vec3 direction{0.0, -1.0, 0.0};
};

struct PictureCase {
    std::string text;  ///< what stands in `texture { ... }`
    std::function<Rgb(const CapPoint&)> expected;
};

std::vector<PictureCase> picture_cases();

/// Points on the cap, `cap_points` x `cap_points` of them, a row at a time from -x, +z.
inline constexpr int cap_points = 6;
CapPoint cap_point(int column, int row);
/// Towards the three lights, red, green and blue, of the cases of normals.
extern const Vec3 light_directions[3];

}  // namespace rt
