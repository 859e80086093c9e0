#include "geometry/triangle.h"

namespace rt {

Bounds bounds(const Triangle& shape) {
    Bounds b{shape.a, shape.a};
    b.extend(shape.b);
    b.extend(shape.c);
    return b;
}

Bounds bounds(const SmoothTriangle& shape) { return bounds(Triangle{shape.a, shape.b, shape.c}); }

}  // namespace rt
