#include "patterns/plain_patterns.h"

#include <algorithm>

namespace rt {

namespace {

/// 1 at the centre, 0 from distance 1 on.
double falling(double distance) { return 1.0 - std::fmin(1.0, distance); }

/// The angle of a spiral's arm at (x, y), from -y over +x, in radians: 0 to 2 pi.
double spiral_angle(const Vec3& p, double r) {
    if (r == 0.0) return 0.0;
    const double rise = std::asin(std::clamp(p.y / r, -1.0, 1.0));
    return p.x >= 0.0 ? pi / 2.0 + rise : 1.5 * pi - rise;
}

/// (v - lo) / (hi - lo), or v where there is no range.
double in_range(double v, const Vec2& range) { return range.x == range.y ? v : (v - range.x) / (range.y - range.x); }

}  // namespace

double triangle_wave(double v) {
    const double f = v - std::floor(v);
    return f < 0.5 ? 2.0 * f : 2.0 * (1.0 - f);
}

double boxed(const Vec3& p) { return falling(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)})); }
double cylindrical(const Vec3& p) { return falling(std::sqrt(p.x * p.x + p.z * p.z)); }
double spherical(const Vec3& p) { return falling(length(p)); }
double planar(const Vec3& p) { return falling(std::fabs(p.y)); }

double gradient(const GradientNumbers& numbers, const Vec3& p) {
    const double along = dot(p, unit(numbers.direction));
    return along > 1.0 ? along - std::floor(along) : along;
}

double leopard(const Vec3& p) { return sqr((std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3.0); }

double onion(const Vec3& p) {
    const double r = length(p);
    return r - std::floor(r);
}

double radial(const Vec3& p) {
    if (std::fabs(p.x) < 0.001 && std::fabs(p.z) < 0.001) return 0.25;
    return 0.25 + (std::atan2(p.x, p.z) + pi) / (2.0 * pi);
}

double quilt_profile(const QuiltedNumbers& numbers, double t) {
    const double rest = 1.0 - t;
    return t * t * t + 3.0 * t * rest * rest * numbers.control0 + 3.0 * t * t * rest * numbers.control1;
}

double quilted(const QuiltedNumbers& numbers, const Vec3& p) {
    const Vec3 u = glm::abs(p - glm::floor(p) - 0.5);
    return std::fabs(quilt_profile(numbers, length(u))) * 1.154700538 * (u.x + u.y + u.z) / 3.0;
}

double spiral1(const SpiralNumbers& numbers, const Vec3& p) {
    const double r = std::sqrt(p.x * p.x + p.y * p.y);
    return p.z + r + numbers.arms * spiral_angle(p, r) / (2.0 * pi);
}

double spiral2(const SpiralNumbers& numbers, const Vec3& p) {
    return triangle_wave(std::sqrt(p.x * p.x + p.y * p.y)) + triangle_wave(spiral1(numbers, p));
}

double slope(const SlopeNumbers& numbers, const Vec3& p, const PatternSurface& surface) {
    if (surface.normal == Vec3(0.0)) return 0.0;
    const double steepness = length(numbers.slope);
    const double rise = std::clamp(dot(surface.normal, numbers.slope) / steepness, -1.0, 1.0);
    double value = in_range(0.5 + std::asin(rise) / pi, numbers.slope_range);
    const double height = length(numbers.altitude);
    if (height > 0.0) {
        const double altitude = in_range(dot(p, numbers.altitude) / height, numbers.altitude_range);
        value = (steepness * value + height * altitude) / (steepness + height);
    }
    return value == 1.0 ? 1.0 : std::fmod(value, 1.0);
}

double angle_of_incidence(const PatternSurface& surface) {
    if (surface.normal == Vec3(0.0)) return 0.0;
    return std::acos(std::clamp(dot(surface.normal, surface.direction), -1.0, 1.0)) / pi;
}

}  // namespace rt
