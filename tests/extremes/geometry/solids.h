// What the scenes of geometry at the extremes say, as the program's own parser reads them, reduced to what the reference knows: spheres,
// planes, boxes, closed cylinders and triangles, moved and scaled evenly; point lamps; matte surfaces, mirrors, and glass without shadows.
#pragma once

#include <string>
#include <vector>

#include "tests/extremes/description.h"

namespace rt::extremes {

struct Solid {
    enum class Kind { sphere, plane, box, cylinder, triangle };
    Kind kind = Kind::sphere;
    Vec3 a{0.0}, b{0.0}, c{0.0};  ///< centre; or a unit normal; or two corners; or base and cap; or three corners
    double size = 0.0;            ///< a radius, or a plane's distance
    double scale = 1.0;           ///< applied before `offset`
    Vec3 offset{0.0};
    std::size_t object = 0;          ///< its number in the scene
    Rgb ambient{0.0}, diffuse{0.0};  ///< with the pigment's colour
    Rgb mirror{0.0};
    bool glass = false;  ///< mirrors by Fresnel, lets the rest through and has no other light
    double ior = 1.0;
    bool seen = true;  ///< by the camera
    bool casts_shadow = true;
};

struct Solids {
    Camera camera;
    std::vector<Solid> solids;
    std::size_t objects = 0;
    std::vector<Lamp> lamps;
    Rgb background{0.0};
    int max_trace_level = 5;

    /// The largest coordinate that a ray starts from or ends at: of the camera and of bounded solids.
    double extent() const;
};

/// Reads a scene file. Throws std::runtime_error for what the reference has not, and what the parser throws.
Solids read_solids(const std::string& path);

}  // namespace rt::extremes
