// Translate, scale, rotate and matrix: order and handedness are documented here and nowhere else.
//
// POV-Ray writes points as rows, p' = p M, and applies transforms in source order. `Transform` stores the same map for
// columns: p' = linear * p + offset.  `then` appends a later transform.
#pragma once

#include "core/ray.h"
#include "core/vec.h"

namespace rt {

/// How `rotate <a,b,c>` is read.
enum class Rotation {
    povray,  ///< about x by a, then y by b, then z by c, left-handed
    csc473,  ///< about z by c, then y by b, then x by a, right-handed
};

/// An invertible affine map together with its inverse. Both directions are composed step by step, so the inverse of a
/// product is the product of the exact inverses of its steps and no matrix is inverted numerically except a stated `matrix`.
struct Transform {
    Mat3 linear{1.0};
    Vec3 offset{0.0};
    Mat3 inverse_linear{1.0};
    Vec3 inverse_offset{0.0};

    static Transform translate(const Vec3& by);
    /// Every component must be non-zero (the parser replaces zeros by 1 with a warning, as POV-Ray does).
    static Transform scale(const Vec3& by);
    static Transform rotate(const Vec3& degrees, Rotation convention);
    /// POV-Ray's twelve numbers: the images of the x, y and z axis, then the translation. Throws std::domain_error if singular.
    static Transform matrix(const double (&m)[12]);

    Transform then(const Transform& later) const;
    Transform inverse() const { return {inverse_linear, inverse_offset, linear, offset}; }
    bool is_identity() const { return *this == Transform{}; }

    Vec3 point(const Vec3& p) const { return linear * p + offset; }
    Vec3 direction(const Vec3& d) const { return linear * d; }
    [[gnu::always_inline]] Vec3 inverse_point(const Vec3& p) const { return inverse_linear * p + inverse_offset; }
    [[gnu::always_inline]] Vec3 inverse_direction(const Vec3& d) const { return inverse_linear * d; }
    /// Normals go with the inverse transpose; not renormalised.
    Vec3 normal(const Vec3& n) const { return n * inverse_linear; }
    /// Object-space ray with the same parameter t.
    Ray inverse_ray(const Ray& r) const { return {inverse_point(r.origin), inverse_direction(r.direction)}; }
    /// A box that contains the image of `b`.
    Bounds bounds(const Bounds& b) const;

    bool operator==(const Transform&) const = default;
};

}  // namespace rt
