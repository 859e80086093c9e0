// Pixel and sub-pixel position to camera ray.
#pragma once

#include <algorithm>

#include "world/world.h"

namespace rt {

/// The ray of a projection that is neither perspective nor orthographic. With x = u, y = v in [-1/2, 1/2], the camera's angle a and the
/// unit vectors r, u, d of its right R, up U and direction D, as POV-Ray has them:
///     fisheye           d cos t + (r X + u Y) sin t / q, where X = 2 x |R|, Y = 2 y |U|, q = |(X, Y)|, t = q a/2; no ray where q > 1
///     ultra_wide_angle  r sin A + u sin B + d cos A cos B, where A = a x, B = a y |U| / |R|
///     panoramic         R sin(pi x) cos(pi y) + U sin(pi y) + D cos(pi x) cos(pi y)
///     spherical         d turned about r by -y times the vertical angle, then about u by a x
///     cylinder 1, 3     r sin(a x) + d cos(a x), and for 1 besides y U; 3 begins at the origin + y U
///     cylinder 2, 4     u sin(a y) + d cos(a y), and for 2 besides x R; 4 begins at the origin + x R
Ray wide_ray(const CameraBasis& camera, double x, double y);

/// Where a camera sees nothing: a ray without a direction.
inline bool is_no_ray(const Ray& ray) { return ray.direction == Vec3(0.0); }

/// (x, y) in pixel units from the top left corner of the picture: pixel (i, j) has its centre at (i + 1/2, j + 1/2).
inline Ray camera_ray(const CameraBasis& camera, double x, double y, int width, int height) {
    const double u = x / width - 0.5;
    const double v = 0.5 - y / height;
    if (camera.projection > Projection::orthographic) return wide_ray(camera, u, v);
    const Vec3 across = u * camera.right + v * camera.up;
    if (camera.projection == Projection::orthographic) return {camera.origin + across, unit(camera.direction)};
    return {camera.origin, unit(camera.direction + across)};
}

/// Angle in radians between the rays of two neighbouring pixels in the middle of the picture, the larger of both ways; 0 for rays that are
/// parallel.
double pixel_angle(const CameraBasis& camera, int width, int height);

}  // namespace rt
