#include "world/uv_mapping.h"

#include <algorithm>
#include <array>

namespace rt {

namespace {

double turns(double y, double x) {
    const double t = std::atan2(y, x) / (2.0 * pi);
    return t < 0.0 ? t + 1.0 : t;
}

Vec2 uv(const Sphere& s, const Vec3& p) {
    const Vec3 d = p - s.center;
    const double r = length(d);
    return {turns(d.z, d.x), r == 0.0 ? 0.5 : 0.5 + std::asin(std::clamp(d.y / r, -1.0, 1.0)) / pi};
}

/// The face that the point is nearest to, on a cross of three by four.
Vec2 uv(const Box& s, const Vec3& p) {
    const Vec3 at = (p - s.min) / (s.max - s.min);
    const std::array<double, 6> off{std::fabs(at.x),       std::fabs(at.x - 1.0), std::fabs(at.y),
                                    std::fabs(at.y - 1.0), std::fabs(at.z),       std::fabs(at.z - 1.0)};
    switch (std::min_element(off.begin(), off.end()) - off.begin()) {
        case 0:
            return {at.z / 4.0, 1.0 / 3.0 + at.y / 3.0};
        case 1:
            return {0.75 - at.z / 4.0, 1.0 / 3.0 + at.y / 3.0};
        case 2:
            return {0.25 + at.x / 4.0, at.z / 3.0};
        case 3:
            return {0.25 + at.x / 4.0, 1.0 - at.z / 3.0};
        case 4:
            return {1.0 - at.x / 4.0, 1.0 / 3.0 + at.y / 3.0};
        default:
            return {0.25 + at.x / 4.0, 1.0 / 3.0 + at.y / 3.0};
    }
}

Vec2 uv(const Torus& s, const Vec3& p) {
    const double out = std::sqrt(sqr(p.x) + sqr(p.z)) - s.major_radius;
    return {0.5 - std::atan2(p.z, p.x) / (2.0 * pi), 0.5 + std::atan2(p.y, out) / (2.0 * pi)};
}

Vec2 uv(const Lathe& s, const Vec3& p, const ShapeHit& hit) { return {turns(p.z, p.x), along_curve(s, hit)}; }
Vec2 uv(const Sor& s, const Vec3& p, const ShapeHit& hit) { return {turns(p.z, p.x), along_curve(s, p, hit)}; }

Vec2 further_uv(const FurtherShape& further, const Transform& to_world, const Vec3& point, const ShapeHit& hit) {
    return std::visit(
        [&](const auto& shape) -> Vec2 {
            if constexpr (requires { uv(shape, point, hit); })
                return uv(shape, to_world.inverse_point(point), hit);
            else
                return {point.x, point.y};
        },
        further);
}

}  // namespace

Vec2 uv_of(const ShapeFrame& frame, const Vec3& point, std::size_t face, const ShapeHit& hit) {
    if (const Mesh* mesh = std::get_if<Mesh>(&frame.shape)) return uv(*mesh->data, face, hit);
    return std::visit(
        [&](const auto& shape) -> Vec2 {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, FurtherShape>)
                return further_uv(shape, frame.to_world, point, hit);
            else if constexpr (requires { uv(shape, point); })
                return uv(shape, frame.to_world.inverse_point(point));
            else
                return {point.x, point.y};
        },
        frame.shape);
}

}  // namespace rt
