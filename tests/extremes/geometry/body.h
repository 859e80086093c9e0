// A solid placed in the world in any precision, and a ray that knows where it starts.
#pragma once

#include "tests/extremes/geometry/solids.h"
#include "tests/extremes/number.h"

namespace rt::extremes {

template <typename T>
struct Body {
    explicit Body(const Solid& s) : solid(&s), a(placed(s.a)), b(placed(s.b)), c(placed(s.c)), size(T(s.scale) * T(s.size)) {
        if (s.kind == Solid::Kind::plane) a = Vec<T>(s.a), size = size + dot(a, Vec<T>(s.offset));
        if (s.kind == Solid::Kind::cylinder) height = length(b - a), c = unit(b - a);
    }
    Vec<T> placed(const Vec3& p) const { return T(solid->scale) * Vec<T>(p) + Vec<T>(solid->offset); }

    const Solid* solid;
    Vec<T> a, b, c;  ///< as in Solid; of a cylinder c is the axis, unit
    T size{}, height{};
};

template <typename T>
struct BodyRay {
    Vec<T> origin, direction;       ///< unit
    const Body<T>* from = nullptr;  ///< whose surface it leaves
    bool into = false;              ///< to that body's inner side
};

/// Where a ray meets a body: how far, and the normal that points out of it, not unit.
template <typename T>
struct Meeting {
    T t{};
    Vec<T> outward;
};

}  // namespace rt::extremes
