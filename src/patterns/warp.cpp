#include "patterns/warp.h"

#include <algorithm>

#include "patterns/hash.h"
#include "patterns/noise.h"

namespace rt {

namespace {

bool is_odd(double whole) { return std::fabs(std::fmod(whole, 2.0)) == 1.0; }

Vec3 warp(const RepeatWarp& repeat, Vec3 p) {
    const int axis = repeat.axis;
    const float width = repeat.width;
    const auto block = static_cast<float>(std::floor(p[axis] / width));
    p[axis] -= block * width;  // rounded to single precision, as POV-Ray does
    if (is_odd(block)) {
        for (int i = 0; i < 3; ++i)
            if (repeat.flip[i] != 0.0) p[i] = -p[i];
        if (repeat.flip[axis] != 0.0) p[axis] += static_cast<double>(width);
    }
    return p + static_cast<double>(block) * repeat.offset;
}

Vec3 warp(const BlackHoleWarp& hole, const Vec3& p) {
    Vec3 center = hole.center;
    if (hole.repeat != Vec3(0.0)) {
        Vec3 block(0.0);
        for (int i = 0; i < 3; ++i)
            if (hole.repeat[i] > 0.0) block[i] = std::floor(p[i] / hole.repeat[i]);
        center += block * hole.repeat;
        if (hole.turbulence != Vec3(0.0)) {
            const auto seed = static_cast<std::size_t>(hash3(cell_of(block.x), cell_of(block.y), cell_of(block.z)));
            const auto& u = cell_numbers();
            center += hole.turbulence * Vec3(u[seed], u[seed + 1], u[seed + 2]);
        }
    }
    const Vec3 d = p - center;
    const double distance = length(d);
    if (!(distance < hole.radius)) return p;
    const double pull = std::fmin(1.0, hole.strength * std::pow((hole.radius - distance) / hole.radius, hole.falloff));
    return hole.inverse ? p - pull * d : p + pull * d;
}

/// (u, v, w) of a surface whose own z is `o`, in the space around.
Vec3 oriented(const Vec3& o, double u, double v, double w) {
    return {o.x * w + o.y * u + o.z * u, o.x * v - o.y * w + o.z * v, -o.x * u + o.y * v + o.z * w};
}

Vec3 warp(const MappingWarp& map, const Vec3& p) {
    double u = turn_about_y(p), v = p.y, w = 0.0;
    switch (map.kind) {
        case MappingWarp::Kind::planar:
            return oriented(map.orientation, p.x, p.y, map.distance);
        case MappingWarp::Kind::cylindrical:
            w = std::sqrt(p.x * p.x + p.z * p.z);
            u *= std::pow(std::fabs(w), map.distance_exponent);
            break;
        case MappingWarp::Kind::spherical:
            w = length(p);
            v = w == 0.0 ? 0.5 : 0.5 + std::asin(p.y / w) / pi;
            break;
        case MappingWarp::Kind::toroidal: {
            const double out = std::sqrt(p.x * p.x + p.z * p.z) - map.major_radius;
            w = std::sqrt(out * out + p.y * p.y);
            const double phi = w == 0.0 ? 0.0 : std::acos(-out / w) / (2.0 * pi);
            v = p.y > 0.0 ? 1.0 - phi : phi;
            break;
        }
    }
    if (map.kind != MappingWarp::Kind::cylindrical) {
        const double stretch = std::pow(std::fabs(w), map.distance_exponent);
        u *= stretch;
        v *= stretch;
    }
    return oriented(map.orientation, u, v, w);
}

/// The cross that six faces unfold to, four squares wide and three high; the third component is the distance to the cube's centre plane.
Vec3 warp(const CubicWarp&, const Vec3& p) {
    const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
    const double b = std::max({ax, ay, az});
    if (b == 0.0) return Vec3(0.0);
    const Vec3 h = 0.5 * (p / b + 1.0);
    if (p.x >= 0.0 && ax == b) return {0.75 - h.z / 4.0, 1.0 / 3.0 + h.y / 3.0, b};
    if (p.y >= 0.0 && ay == b) return {0.25 + h.x / 4.0, 1.0 - h.z / 3.0, b};
    if (p.z >= 0.0 && az == b) return {0.25 + h.x / 4.0, 1.0 / 3.0 + h.y / 3.0, b};
    if (p.x < 0.0 && ax == b) return {h.z / 4.0, 1.0 / 3.0 + h.y / 3.0, b};
    if (p.y < 0.0 && ay == b) return {0.25 + h.x / 4.0, h.z / 3.0, b};
    return {1.0 - h.x / 4.0, 1.0 / 3.0 + h.y / 3.0, b};
}

Vec3 warp(const Transform& transform, const Vec3& p) { return transform.inverse_point(p); }
Vec3 warp(const Turbulence& turbulence, const Vec3& p) { return p + turbulence.amount * vector_turbulence(turbulence, p); }

}  // namespace

double turn_about_y(const Vec3& p) {
    const double turns = std::atan2(p.z, p.x) / (2.0 * pi);
    return turns < 0.0 ? turns + 1.0 : turns;
}

bool fit_repeat(BlackHoleWarp& hole) {
    const BlackHoleWarp stated = hole;
    for (int i = 0; i < 3; ++i) {
        if (!(hole.repeat[i] > 0.0)) continue;
        hole.center[i] = std::max(hole.center[i], hole.radius);
        hole.repeat[i] = std::max(hole.repeat[i], hole.center[i] + hole.radius + hole.turbulence[i]);
    }
    return hole != stated;
}

Vec3 warped(const Warp& step, const Vec3& p) {
    return std::visit([&](const auto& one) { return warp(one, p); }, step);
}

}  // namespace rt
