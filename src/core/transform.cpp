#include "core/transform.h"

#include <stdexcept>

namespace rt {

namespace {

/// sin and cos of an angle in degrees, exact at the multiples of 90.
struct SinCos {
    double sin;
    double cos;
};

SinCos sin_cos(double degrees) {
    const double quarter = degrees / 90.0;
    if (std::fabs(quarter) < 1e15 && quarter == std::floor(quarter)) {
        constexpr SinCos exact[4] = {{0.0, 1.0}, {1.0, 0.0}, {0.0, -1.0}, {-1.0, 0.0}};
        return exact[static_cast<long long>(quarter) & 3];
    }
    return {std::sin(radians(degrees)), std::cos(radians(degrees))};
}

/// Columns are the images of the axes. Positive angles turn y to z, z to x, x to y.
Mat3 about_x(double degrees) {
    const auto [s, c] = sin_cos(degrees);
    return Mat3(Vec3(1, 0, 0), Vec3(0, c, s), Vec3(0, -s, c));
}

Mat3 about_y(double degrees) {
    const auto [s, c] = sin_cos(degrees);
    return Mat3(Vec3(c, 0, -s), Vec3(0, 1, 0), Vec3(s, 0, c));
}

Mat3 about_z(double degrees) {
    const auto [s, c] = sin_cos(degrees);
    return Mat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1));
}

}  // namespace

Transform Transform::translate(const Vec3& by) { return {Mat3(1.0), by, Mat3(1.0), -by}; }

Transform Transform::scale(const Vec3& by) {
    Transform t;
    for (int i = 0; i < 3; ++i) {
        t.linear[i][i] = by[i];
        t.inverse_linear[i][i] = 1.0 / by[i];
    }
    return t;
}

// The matrices of both conventions are the same: a left-handed turn seen in left-handed axes has the numbers of a right-handed turn seen
// in right-handed ones. Only the order differs.
Transform Transform::rotate(const Vec3& degrees, Rotation convention) {
    const Mat3 x = about_x(degrees.x);
    const Mat3 y = about_y(degrees.y);
    const Mat3 z = about_z(degrees.z);
    Transform t;
    t.linear = convention == Rotation::povray ? z * (y * x) : x * (y * z);
    t.inverse_linear = glm::transpose(t.linear);
    return t;
}

Transform Transform::matrix(const double (&m)[12]) {
    Transform t;
    t.linear = Mat3(Vec3(m[0], m[1], m[2]), Vec3(m[3], m[4], m[5]), Vec3(m[6], m[7], m[8]));
    t.offset = Vec3(m[9], m[10], m[11]);
    // Scaled first, so that tiny or huge but regular matrices do not under- or overflow in the determinant.
    double largest = 0.0;
    for (int i = 0; i < 9; ++i) largest = std::fmax(largest, std::fabs(m[i]));
    const Mat3 scaled = t.linear / largest;
    if (!(std::fabs(glm::determinant(scaled)) > 0.0) || !std::isfinite(largest)) throw std::domain_error("singular matrix");
    t.inverse_linear = glm::inverse(scaled) / largest;
    t.inverse_offset = -(t.inverse_linear * t.offset);
    return t;
}

Transform Transform::then(const Transform& later) const {
    return {later.linear * linear, later.linear * offset + later.offset, inverse_linear * later.inverse_linear,
            inverse_linear * later.inverse_offset + inverse_offset};
}

Bounds Transform::bounds(const Bounds& b) const {
    if (!b.is_finite()) return Bounds::everything();
    Bounds image;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p((corner & 1) ? b.max.x : b.min.x, (corner & 2) ? b.max.y : b.min.y, (corner & 4) ? b.max.z : b.min.z);
        image.extend(point(p));
    }
    return image;
}

}  // namespace rt
