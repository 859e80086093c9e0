// A surface by the course's rules, and how its light and that of its further rays share the pixel.
#pragma once

#include "core/vec.h"
#include "trace/ray_log.h"

namespace rt::course {

/// One surface as the course's scenes describe it.
struct Surface {
    Rgb pigment{0.0};
    double filter = 0.0;  ///< share of light that passes; above 0 the object is transparent
    double ambient = 0.0, diffuse = 0.0, specular = 0.0;
    double roughness = 1.0;
    double reflection = 0.0;
    double ior = 1.0;
};

/// How a point's own light and that of its two further rays share the pixel; they sum to 1. `F` is Schlick's reflectance under -fresnel,
/// else 0; `total`: no ray can pass, its share is mirrored.
inline RayNode::Shares shares(const Surface& s, double F, bool total) {
    const double f = s.filter, k = s.reflection;
    const double passes = f * (1.0 - F);
    return {(1.0 - f) * (1.0 - k), (1.0 - f) * k + f * F + (total ? passes : 0.0), total ? 0.0 : passes};
}

}  // namespace rt::course
