// Products whose differences keep their digits.
#pragma once

#include "core/vec.h"

namespace rt {

/// a b - c d to within 1.5 ulp, so with the right sign (Kahan's method; Jeannerod, Louvet, Muller 2013, "Further Analysis of Kahan's
/// Algorithm for the Accurate Computation of 2 x 2 Determinants").
inline double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// a x b without cancellation: the sine of a small angle keeps its relative accuracy.
inline Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// a . b as if summed in twice the precision and rounded once (Ogita, Rump, Oishi 2005, "Accurate Sum and Dot Product"): the cosine of a
/// grazing direction keeps its relative accuracy.
inline double accurate_dot(const Vec3& a, const Vec3& b) {
    const double x = a.x * b.x, y = a.y * b.y, z = a.z * b.z;
    const double rest = std::fma(a.x, b.x, -x) + std::fma(a.y, b.y, -y) + std::fma(a.z, b.z, -z);
    const double xy = x + y, y_taken = xy - x;
    const double xyz = xy + z, z_taken = xyz - xy;
    return xyz + (rest + ((x - (xy - y_taken)) + (y - y_taken)) + ((xy - (xyz - z_taken)) + (z - z_taken)));
}

}  // namespace rt
