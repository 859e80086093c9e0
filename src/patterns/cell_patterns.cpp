#include "patterns/cell_patterns.h"

#include <array>

namespace rt {

namespace {

constexpr double face_offset = 1e-10;  ///< decides for points on a face

double fraction(double x) { return x - std::floor(x); }

/// x modulo n in [0, n), as a whole number; 0 for what is no number.
int whole_modulo(double x, int n) {
    const double rest = x - n * std::floor(x / n);
    return rest >= 0.0 && rest < n ? static_cast<int>(rest) : 0;
}

}  // namespace

int brick(const BrickNumbers& numbers, const Vec3& p) {
    const Vec3 q = p + numbers.mortar + face_offset;
    const Vec3 mortar = numbers.mortar / numbers.size;
    const Vec3 course = q / numbers.size;
    if (fraction(course.y) <= mortar.y) return 0;
    // Every other course is moved by half a brick: across in x, along in z.
    const bool upper = fraction(course.y / 2.0) > 0.5;
    const double x = fraction(upper ? course.x + 0.5 : course.x);
    const double z = fraction(upper ? course.z : course.z + 0.5);
    return x <= mortar.x || z <= mortar.z ? 0 : 1;
}

int hexagon(const Vec3& p) {
    const double x = std::fabs(p.x), z = p.z < 0.0 ? 5.196152424 - std::fabs(p.z) : p.z;
    const double half = x / 0.5, height = z / 0.8660254;
    const double xs = half - 6.0 * std::floor(half / 6.0), zs = height - 6.0 * std::floor(height / 6.0);
    const int xm = whole_modulo(xs, 6), zm = whole_modulo(zs, 6);
    static constexpr int edge[6] = {0, 1, 1, 2, 2, 0}, middle[6] = {2, 2, 0, 0, 1, 1};
    static constexpr int below[6] = {0, 2, 1, 0, 2, 1}, above[6] = {2, 1, 0, 2, 1, 0};
    if (xm == 0 || xm == 5) return edge[zm];
    if (xm == 2 || xm == 3) return middle[zm];
    double across = xs - xm;
    const double up = zs - zm;
    if ((xm + zm) % 2 == 1) across = 1.0 - across;
    if (across == 0.0) across = 1e-4;
    return up / across < 1.0 ? below[zm] : above[zm];
}

int square(const Vec3& p) { return whole_modulo(std::floor(p.x), 2) + 2 * whole_modulo(std::floor(p.z), 2); }

int triangular(const Vec3&) { return 0; }

int cubic(const Vec3& p) {
    const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
    if (p.x >= 0.0 && ax >= ay && ax >= az) return 0;
    if (p.y >= 0.0 && ay >= ax && ay >= az) return 1;
    if (p.z >= 0.0 && az >= ax && az >= ay) return 2;
    if (p.x < 0.0 && ax >= ay && ax >= az) return 3;
    return p.y < 0.0 && ay >= ax && ay >= az ? 4 : 5;
}

}  // namespace rt
