#include "geometry/shape.h"

namespace rt {

namespace {

struct NameOf {
    const char* operator()(const Sphere&) const { return "sphere"; }
    const char* operator()(const Plane&) const { return "plane"; }
    const char* operator()(const Box&) const { return "box"; }
    const char* operator()(const Cone& cone) const { return cone.base_radius == cone.cap_radius ? "cylinder" : "cone"; }
    const char* operator()(const Torus&) const { return "torus"; }
    const char* operator()(const Disc&) const { return "disc"; }
    const char* operator()(const Triangle&) const { return "triangle"; }
    const char* operator()(const SmoothTriangle&) const { return "smooth_triangle"; }
    const char* operator()(const Polygon&) const { return "polygon"; }
    const char* operator()(const Mesh&) const { return "mesh"; }
    const char* operator()(const FurtherShape& shape) const { return name(shape); }
};

}  // namespace

bool is_sheet(const Shape& shape) {
    return std::holds_alternative<Triangle>(shape) || std::holds_alternative<SmoothTriangle>(shape) ||
           std::holds_alternative<Polygon>(shape) || std::holds_alternative<Mesh>(shape);
}

const char* name(const Shape& shape) { return std::visit(NameOf{}, shape); }

}  // namespace rt
