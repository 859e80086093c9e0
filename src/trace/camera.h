// Pixel and sub-pixel position to camera ray.
#pragma once

#include <algorithm>

#include "world/world.h"

namespace rt {

/// (x, y) in pixel units from the top left corner of the picture: pixel (i, j) has its centre at (i + 1/2, j + 1/2).
inline Ray camera_ray(const CameraBasis& camera, double x, double y, int width, int height) {
    const double u = x / width - 0.5;
    const double v = 0.5 - y / height;
    const Vec3 across = u * camera.right + v * camera.up;
    if (camera.orthographic) return {camera.origin + across, unit(camera.direction)};
    return {camera.origin, unit(camera.direction + across)};
}

/// Angle in radians between the rays of two neighbouring pixels in the middle of the picture, the larger of both ways; 0 for rays that are
/// parallel.
inline double pixel_angle(const CameraBasis& camera, int width, int height) {
    if (camera.orthographic) return 0.0;
    const double distance = length(camera.direction);
    return std::atan(std::max(length(camera.right) / width, length(camera.up) / height) / distance);
}

}  // namespace rt
