// All the hits of a ray with a shape, in order.
#pragma once

#include "geometry/hit.h"

namespace rt {

/// Calls `visit` with each hit inside `range`, nearest first, until it returns true; true if it did. This one works for every shape, by
/// asking for the nearest hit beyond the last one; a shape that has all of them at hand overloads it.
template <typename S, typename Visit>
bool visit_hits(const S& shape, const Ray& ray, Interval range, Visit visit) {
    ShapeHit hit;
    while (intersect(shape, ray, range, hit)) {
        if (visit(hit)) return true;
        range.min = hit.t;
        hit = {};
    }
    return false;
}

}  // namespace rt
