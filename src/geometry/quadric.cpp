#include "geometry/quadric.h"

#include "core/products.h"

namespace rt {

namespace {

/// The symmetric matrix Q with p . Q p for the terms of second degree, times two.
Mat3 doubled_matrix(const Quadric& q) {
    return {2.0 * q.squares.x, q.products.x, q.products.y, q.products.x,     2.0 * q.squares.y,
            q.products.z,      q.products.y, q.products.z, 2.0 * q.squares.z};
}

double value(const Quadric& q, const Vec3& p) {
    return dot(q.squares, p * p) + q.products.x * p.x * p.y + q.products.y * p.x * p.z + q.products.z * p.y * p.z + dot(q.linear, p) +
           q.constant;
}

Vec3 gradient(const Quadric& q, const Vec3& p) { return doubled_matrix(q) * p + q.linear; }

/// Both roots of a t^2 + 2 b t + c, the smaller first; false if there is none. A double root, where the line touches, is one.
bool solve(double a, double b, double c, double& t0, double& t1) {
    const double discriminant = difference_of_products(b, b, a, c);
    if (!(discriminant >= 0.0)) return false;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0.0 && a == 0.0) return false;
    t0 = a == 0.0 ? c / q : q / a;
    t1 = q == 0.0 ? t0 : c / q;
    if (t0 > t1) std::swap(t0, t1);
    return true;
}

}  // namespace

// From the point of the line nearest to the origin on, so that a far origin does not drown the terms of the surface.
void find_hits(const Quadric& shape, const Ray& ray, HitSink& sink) {
    const Vec3& d = ray.direction;
    const double shift = -dot(ray.origin, d) / dot(d, d);
    const Vec3 o = ray.origin + shift * d;
    const double a = dot(shape.squares, d * d) + shape.products.x * d.x * d.y + shape.products.y * d.x * d.z + shape.products.z * d.y * d.z;
    const double b = 0.5 * dot(gradient(shape, o), d);
    double t0 = 0.0, t1 = 0.0;
    if (!solve(a, b, value(shape, o), t0, t1)) return;
    sink.offer({.t = shift + t0});
    sink.offer({.t = shift + t1});
}

Vec3 normal(const Quadric& shape, const Vec3& point, const ShapeHit&) { return gradient(shape, point); }

bool contains(const Quadric& shape, const Vec3& point) { return value(shape, point) < 0.0; }

// Around its middle m an ellipsoid is (p - m) . Q (p - m) <= k, and reaches as far as sqrt(k (Q^-1)_ii) along axis i.
Bounds bounds(const Quadric& shape) {
    const Mat3 q = 0.5 * doubled_matrix(shape);
    const double minor = q[0][0] * q[1][1] - sqr(q[0][1]);
    const double determinant = glm::determinant(q);
    const double size = std::fabs(q[0][0]) + std::fabs(q[1][1]) + std::fabs(q[2][2]);
    constexpr double clearly = 1e-9;  // of a nearly flat one rounding could say anything
    if (!(q[0][0] > clearly * size && minor > clearly * sqr(size) && determinant > clearly * sqr(size) * size)) return Bounds::everything();
    const Mat3 inverse = glm::inverse(q);
    const Vec3 middle = -0.5 * (inverse * shape.linear);
    const double k = -value(shape, middle);
    if (!(k > 0.0)) return {middle, middle};
    const Vec3 reach = (1.0 + 1e-6) * glm::sqrt(k * Vec3(inverse[0][0], inverse[1][1], inverse[2][2]));
    return rounded_outward({middle - reach, middle + reach});
}

}  // namespace rt
