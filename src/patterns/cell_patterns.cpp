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
    // Every other course is moved by half a brick: across in x, along in z.
    const bool upper = fraction(course.y / 2.0) > 0.5;
    const double x = fraction(upper ? course.x + 0.5 : course.x);
    const double z = fraction(upper ? course.z : course.z + 0.5);
    return fraction(course.y) > mortar.y && x > mortar.x && z > mortar.z ? 1 : 0;  // mortar where a size of 0 leaves no number
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

int square(const Vec3& p) {
    static constexpr int cell[2][2] = {{0, 1}, {3, 2}};  // by column, then row
    return cell[whole_modulo(std::floor(p.x), 2)][whole_modulo(std::floor(p.z), 2)];
}

int triangular(const Vec3& p) {
    const double height = p.z / 0.8660254037844386;
    const double strip = std::floor(height), column = std::floor(p.x);
    const double t = height - strip, f = p.x - column;
    const auto third = [](double whole) { return whole_modulo(whole, 3); };
    if (whole_modulo(strip, 2) == 0) {  // triangles stand on whole numbers
        static constexpr int standing[3] = {0, 4, 2}, hanging[3] = {1, 3, 5};
        if (f >= 0.5 * t && f <= 1.0 - 0.5 * t) return standing[third(column)];
        return hanging[third(f < 0.5 ? column : column + 1.0)];
    }
    static constexpr int standing[3] = {4, 2, 0}, hanging[3] = {5, 1, 3};  // between them
    const double rest = 0.5 * (1.0 - t);
    if (f >= rest && f <= 1.0 - rest) return hanging[third(column)];
    return standing[third(f < 0.5 ? column : column + 1.0)];
}

int cubic(const Vec3& p) {
    const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
    if (p.x >= 0.0 && ax >= ay && ax >= az) return 0;
    if (p.y >= 0.0 && ay >= ax && ay >= az) return 1;
    if (p.z >= 0.0 && az >= ax && az >= ay) return 2;
    if (p.x < 0.0 && ax >= ay && ax >= az) return 3;
    return p.y < 0.0 && ay >= ax && ay >= az ? 4 : 5;
}

}  // namespace rt
