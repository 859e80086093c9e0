// Numbers of any precision and vectors of them. Quad has 113 bits, so that a textbook's formula loses 20 digits and still has 13.
#pragma once

#include <quadmath.h>

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace rt::extremes {

using Quad = __float128;

// The names of <cmath> for every kind of number.
using std::erf;
using std::erfc;
using std::exp;
using std::fabs;
using std::log;
using std::log1p;
using std::pow;
using std::sqrt;
inline Quad erf(Quad x) { return erfq(x); }
inline Quad erfc(Quad x) { return erfcq(x); }
inline Quad exp(Quad x) { return expq(x); }
inline Quad fabs(Quad x) { return fabsq(x); }
inline Quad log(Quad x) { return logq(x); }
inline Quad log1p(Quad x) { return log1pq(x); }
inline Quad pow(Quad x, Quad y) { return powq(x, y); }
inline Quad sqrt(Quad x) { return sqrtq(x); }

template <typename T>
bool is_finite(T x) {
    return x - x == T(0);
}

/// pi to 113 bits, as the sum of two doubles and a rest.
template <typename T>
T pi_of() {
    return T(3.141592653589793116) + T(1.2246467991473531772e-16) + T(-2.9947698097183396659e-33);
}

template <typename T>
struct Vec {
    T x{}, y{}, z{};

    Vec() = default;
    Vec(T a, T b, T c) : x(a), y(b), z(c) {}
    /// A stated vector of doubles, rounded where T has fewer digits.
    explicit Vec(const Vec3& v) : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z)) {}
    template <typename U>
    explicit Vec(const Vec<U>& v) : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z)) {}
    friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec operator-(const Vec& a) { return {-a.x, -a.y, -a.z}; }
    friend Vec operator*(T k, const Vec& a) { return {k * a.x, k * a.y, k * a.z}; }
    /// Colours, channel by channel.
    friend Vec operator*(const Vec& a, const Vec& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
};

template <typename T>
T dot(const Vec<T>& a, const Vec<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename T>
T length(const Vec<T>& a) {
    return sqrt(dot(a, a));
}
template <typename T>
Vec<T> unit(const Vec<T>& a) {
    return T(1) / length(a) * a;
}

}  // namespace rt::extremes
