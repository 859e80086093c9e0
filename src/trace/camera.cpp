#include "trace/camera.h"

#include <cmath>

namespace rt {

namespace {

/// `v` turned about the unit vector `axis` (Rodrigues).
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
    return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1.0 - std::cos(angle)) * dot(axis, v) * axis;
}

Vec3 fisheye(const CameraBasis& camera, double x, double y) {
    const double across = 2.0 * x * length(camera.right), upwards = 2.0 * y * length(camera.up);
    const double q = std::hypot(across, upwards);
    if (q > 1.0) return Vec3(0.0);
    if (q == 0.0) return unit(camera.direction);
    const double t = 0.5 * q * camera.angle;
    return std::cos(t) * unit(camera.direction) + std::sin(t) / q * (across * unit(camera.right) + upwards * unit(camera.up));
}

Vec3 ultra_wide(const CameraBasis& camera, double x, double y) {
    const double a = camera.angle * x, b = camera.angle * y * length(camera.up) / length(camera.right);
    return std::sin(a) * unit(camera.right) + std::sin(b) * unit(camera.up) + std::cos(a) * std::cos(b) * unit(camera.direction);
}

Vec3 panoramic(const CameraBasis& camera, double x, double y) {
    const double a = pi * x, b = pi * y;
    return std::sin(a) * std::cos(b) * camera.right + std::sin(b) * camera.up + std::cos(a) * std::cos(b) * camera.direction;
}

Vec3 spherical(const CameraBasis& camera, double x, double y) {
    return turned(turned(unit(camera.direction), unit(camera.right), -camera.vertical_angle * y), unit(camera.up), camera.angle * x);
}

/// Round the cylinder whose axis is at right angles to `side`.
Vec3 around(const CameraBasis& camera, const Vec3& side, double place) {
    return std::sin(camera.angle * place) * unit(side) + std::cos(camera.angle * place) * unit(camera.direction);
}

Ray unscaled(const CameraBasis& camera, double x, double y) {
    switch (camera.projection) {
        case Projection::fisheye:
            return {camera.origin, fisheye(camera, x, y)};
        case Projection::ultra_wide_angle:
            return {camera.origin, ultra_wide(camera, x, y)};
        case Projection::panoramic:
            return {camera.origin, panoramic(camera, x, y)};
        case Projection::spherical:
            return {camera.origin, spherical(camera, x, y)};
        case Projection::cylinder_1:
            return {camera.origin, around(camera, camera.right, x) + y * camera.up};
        case Projection::cylinder_2:
            return {camera.origin, around(camera, camera.up, y) + x * camera.right};
        case Projection::cylinder_3:
            return {camera.origin + y * camera.up, around(camera, camera.right, x)};
        case Projection::cylinder_4:
            return {camera.origin + x * camera.right, around(camera, camera.up, y)};
        case Projection::perspective:
        case Projection::orthographic:
            break;
    }
    return {camera.origin, Vec3(0.0)};
}

}  // namespace

Ray wide_ray(const CameraBasis& camera, double x, double y) {
    const Ray ray = unscaled(camera, x, y);
    const double size = length(ray.direction);
    return {ray.origin, size > 0.0 ? ray.direction / size : Vec3(0.0)};
}

double pixel_angle(const CameraBasis& camera, int width, int height) {
    if (camera.projection == Projection::orthographic) return 0.0;
    if (camera.projection == Projection::perspective) {
        const double distance = length(camera.direction);
        return std::atan(std::max(length(camera.right) / width, length(camera.up) / height) / distance);
    }
    const Vec3 middle = wide_ray(camera, 0.0, 0.0).direction;
    const auto to = [&](double x, double y) { return std::asin(std::min(length(cross(middle, wide_ray(camera, x, y).direction)), 1.0)); };
    return std::max(to(1.0 / width, 0.0), to(0.0, 1.0 / height));
}

}  // namespace rt
