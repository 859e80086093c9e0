// What the extreme scenes say, as the program's own parser reads them, reduced to what the second renderer knows: spheres and planes, point
// lamps, the general form with terms D, G and F, and glass that mirrors by Fresnel.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "shading/terms.h"

namespace rt::extremes {

struct Surface {
    bool plane = false;
    Vec3 center{0.0};     ///< or a plane's unit normal
    double radius = 1.0;  ///< or a plane's distance
    Rgb pigment{0.0}, ambient{0.0};
    double diffuse = 0.0, s = 0.0, roughness = 0.0;
    bool direct = false;  ///< roughness is alpha itself, not its root
    double ior = 1.5, k = 0.0;
    Distribution D = Distribution::ggx;
    Masking G = Masking::ggx;
    Fresnel F = Fresnel::schlick;
    bool glass = false;  ///< mirrors by Fresnel, lets the rest through and has no other light
    bool casts_shadow = true;
};

struct Lamp {
    Vec3 location{0.0};
    Rgb color{0.0};
};

struct Description {
    Camera camera;
    std::vector<Surface> surfaces;
    std::vector<Lamp> lamps;
    Rgb background{0.0};
    int max_trace_level = 5;
};

/// Reads a scene file. Throws std::runtime_error for what the second renderer has not, and what the parser throws.
Description describe(const std::string& path);

}  // namespace rt::extremes
