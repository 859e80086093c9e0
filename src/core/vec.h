// Double vectors, matrices and colours: the one include of GLM. No policy, no epsilon.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rt {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
/// Linear colour in the scene's working space. Never clamped while tracing: values above 1 and below 0 survive.
using Rgb = glm::dvec3;

using glm::cross;
using glm::dot;

inline constexpr double pi = 3.14159265358979323846;

template <typename T>
constexpr T sqr(T x) {
    return x * x;
}

inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// v / |v|. One division per component: GLM multiplies by a rounded reciprocal, which is one rounding worse.
/// Undefined (NaN) for the zero vector; callers that can meet one test `length` first.
inline Vec3 unit(const Vec3& v) { return v / length(v); }

inline double radians(double degrees) { return degrees * (pi / 180.0); }

/// Zero times an infinity or a NaN is a NaN, and so is its sum with anything.
inline bool is_finite(const Vec3& v) { return 0.0 * v.x + 0.0 * v.y + 0.0 * v.z == 0.0; }

inline double max_component(const Vec3& v) { return std::fmax(v.x, std::fmax(v.y, v.z)); }

/// POV-Ray's luminance weights.
inline double grey(const Rgb& c) { return 0.297 * c.r + 0.589 * c.g + 0.114 * c.b; }

}  // namespace rt
