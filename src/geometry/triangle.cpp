#include "geometry/triangle.h"

namespace rt {

double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

Bounds bounds(const Triangle& shape) {
    Bounds b{shape.a, shape.a};
    b.extend(shape.b);
    b.extend(shape.c);
    return b;
}

Bounds bounds(const SmoothTriangle& shape) { return bounds(Triangle{shape.a, shape.b, shape.c}); }

}  // namespace rt
