// Quadruple precision for the oracles: the textbook formulas, which cancel badly, have 60 bits to spare in it.
#pragma once

#include <random>

#include "core/ray.h"

namespace rt::test {

using Quad = __float128;

inline Quad abs(Quad x) { return x < 0 ? -x : x; }
inline Quad min(Quad a, Quad b) { return a < b ? a : b; }
inline Quad max(Quad a, Quad b) { return a > b ? a : b; }

/// Newton's method from the double result: each step doubles the digits.
inline Quad sqrt(Quad x) {
    if (!(x > 0)) return 0;
    Quad r = std::sqrt(static_cast<double>(x));
    if (r == 0) return 0;
    for (int i = 0; i < 3; ++i) r = (r + x / r) / 2;
    return r;
}

struct Quad3 {
    Quad x, y, z;
    Quad3(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
    Quad3(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: implicit, it is exact
    Quad operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
inline Quad3 operator+(const Quad3& a, const Quad3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Quad3 operator-(const Quad3& a, const Quad3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Quad3 operator*(Quad k, const Quad3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Quad dot(const Quad3& a, const Quad3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Quad length(const Quad3& a) { return sqrt(dot(a, a)); }
inline Quad3 cross(const Quad3& a, const Quad3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Quad3 at(const Ray& ray, Quad t) { return Quad3(ray.origin) + t * Quad3(ray.direction); }

/// Random numbers with a fixed seed.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double a, double b) { return a + (b - a) * (static_cast<double>(engine_()) / 18446744073709551616.0); }
    std::size_t index(std::size_t count) { return engine_() % count; }
    bool coin() { return engine_() & 1; }
    Vec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube(1.0);
            if (dot(v, v) > 1e-3 && dot(v, v) < 1.0) return unit(v);
        }
    }
    /// 10^e with e uniform.
    double magnitude(double least, double most) { return std::pow(10.0, between(std::log10(least), std::log10(most))); }

private:
    std::mt19937_64 engine_;
};

/// A ray through (about) `target` from a distance of up to a million sizes, its direction of any length.
inline Ray aimed_at(const Vec3& target, double size, Random& random) {
    const double distance = size * (random.coin() ? random.between(0.0, 3.0) : random.magnitude(1.0, 1e6));
    const Vec3 origin = target + distance * random.direction();
    const Vec3 direction = target - origin;
    if (length(direction) == 0.0) return {origin, random.direction()};
    return {origin, random.magnitude(1e-2, 1e2) * unit(direction)};
}

}  // namespace rt::test
