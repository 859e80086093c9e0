// Flat and smooth triangles. The ray test is watertight (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection") in doubles:
// a ray that crosses an edge or a vertex shared by several triangles meets at least one of them.
#pragma once

#include "core/products.h"
#include "geometry/hit.h"

namespace rt {

struct Triangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};
    bool operator==(const Triangle&) const = default;
};

/// Whether three corners span no plane: POV-Ray's test.
inline bool is_degenerate_triangle(const Vec3& a, const Vec3& b, const Vec3& c) { return !(length(cross(b - a, c - a)) > 0.0); }

struct SmoothTriangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};
    Vec3 normal_a{0.0}, normal_b{0.0}, normal_c{0.0};  ///< unit
    bool operator==(const SmoothTriangle&) const = default;
};

/// What the test of one ray against many triangles shares: the axis permutation and the shear that take the ray to the +z axis.
struct TriangleRay {
    explicit TriangleRay(const Ray& ray) : origin(ray.origin) {
        const Vec3& d = ray.direction;
        const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
        kz = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        sz = 1.0 / (&d.x)[kz];
        sx = (&d.x)[kx] / (&d.x)[kz];
        sy = (&d.x)[ky] / (&d.x)[kz];
    }
    Vec3 origin;
    int kx, ky, kz;
    double sx, sy, sz;
};

/// The triangle after the shear, seen along the ray: corners in the plane, depths, and twice the areas opposite to each corner.
struct ShearedTriangle {
    ShearedTriangle(const Vec3& a, const Vec3& b, const Vec3& c, const TriangleRay& ray) {
        const Vec3 A = a - ray.origin, B = b - ray.origin, C = c - ray.origin;
        az = (&A.x)[ray.kz], bz = (&B.x)[ray.kz], cz = (&C.x)[ray.kz];
        ax = (&A.x)[ray.kx] - ray.sx * az, ay = (&A.x)[ray.ky] - ray.sy * az;
        bx = (&B.x)[ray.kx] - ray.sx * bz, by = (&B.x)[ray.ky] - ray.sy * bz;
        cx = (&C.x)[ray.kx] - ray.sx * cz, cy = (&C.x)[ray.ky] - ray.sy * cz;
        u = cx * by - cy * bx;
        v = ax * cy - ay * cx;
        w = bx * ay - by * ax;
    }
    void refine() {
        u = difference_of_products(cx, by, cy, bx);
        v = difference_of_products(ax, cy, ay, cx);
        w = difference_of_products(bx, ay, by, ax);
    }
    /// Needles and triangles seen edge-on: the areas have lost too many digits to interpolate with.
    bool cancels() const {
        constexpr double lost = 16.0;
        const double reach = std::max({std::fabs(ax) + std::fabs(ay), std::fabs(bx) + std::fabs(by), std::fabs(cx) + std::fabs(cy)});
        return lost * std::fabs(u + v + w) < reach * reach;
    }
    double ax, ay, az, bx, by, bz, cx, cy, cz, u, v, w;
};

/// Vertices in counter- or clockwise order, both sides count; a triangle without area is never hit. Sets t, u (weight of b) and
/// v (weight of c). Rounding is monotone, so an area has the right sign or is zero, and zeros are decided exactly.
inline bool intersect(const Vec3& a, const Vec3& b, const Vec3& c, const TriangleRay& ray, const Interval& range, ShapeHit& hit) {
    ShearedTriangle s(a, b, c, ray);
    if (s.u == 0.0 || s.v == 0.0 || s.w == 0.0) [[unlikely]]
        s.refine();
    if ((s.u < 0.0 || s.v < 0.0 || s.w < 0.0) && (s.u > 0.0 || s.v > 0.0 || s.w > 0.0)) return false;
    if (s.cancels()) [[unlikely]]
        s.refine();
    const double area = s.u + s.v + s.w;
    if (area == 0.0) return false;
    const double t = (s.u * s.az + s.v * s.bz + s.w * s.cz) * ray.sz / area;
    if (!range.contains(t)) return false;
    const Vec3 n = cross(b - a, c - a);
    if (n.x == 0.0 && n.y == 0.0 && n.z == 0.0) return false;
    hit.t = t;
    hit.u = s.v / area;
    hit.v = s.w / area;
    return true;
}

inline bool intersect(const Triangle& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    return intersect(shape.a, shape.b, shape.c, TriangleRay(ray), range, hit);
}
inline bool intersect(const SmoothTriangle& shape, const Ray& ray, const Interval& range, ShapeHit& hit) {
    return intersect(shape.a, shape.b, shape.c, TriangleRay(ray), range, hit);
}

inline Vec3 normal(const Triangle& shape, const Vec3&, const ShapeHit&) { return cross(shape.b - shape.a, shape.c - shape.a); }
inline Vec3 normal(const SmoothTriangle& shape, const Vec3&, const ShapeHit& hit) {
    return (1.0 - hit.u - hit.v) * shape.normal_a + hit.u * shape.normal_b + hit.v * shape.normal_c;
}

inline bool contains(const Triangle&, const Vec3&) { return false; }
inline bool contains(const SmoothTriangle&, const Vec3&) { return false; }

Bounds bounds(const Triangle& shape);
Bounds bounds(const SmoothTriangle& shape);

}  // namespace rt
