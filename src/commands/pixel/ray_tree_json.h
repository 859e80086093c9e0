// The rays of one pixel as JSON: everything that the record holds, with numbers that read back to the same bits.
#pragma once

#include <string>

#include "commands/pixel/course_text.h"
#include "trace/pixel_rays.h"
#include "world/compile.h"

namespace rt {

/// A pixel with its rays, and what it takes to tell of them.
struct TracedPixel {
    std::string scene_name;
    std::string shading;  ///< by name
    Profile profile = Profile::povray;
    int width = 0, height = 0;
    Scene scene;
    CameraBasis camera;
    PixelName name;  ///< `y` from the bottom under the course's profile, else from the top
    PixelRays rays;
};

/// One JSON object, one ray a line:
///     format       "raytrace ray tree 1"
///     scene, width, height, profile, shading
///     camera       projection, location, direction, right, up; a pixel's ray goes along direction + u right + v up, u and v in
///                  -1/2..1/2 (orthographic: along direction, from location + u right + v up; others: trace/camera.h)
///     pixel        x, y from 0; origin "top left" or "bottom left"; radiance (linear), color (bytes of the picture)
///     samples      for each camera ray the list of its rays, parents before children, mirrors before what lies behind
/// and of each ray
///     parent       its place in the list, from 0; null for the camera ray
///     kind         camera, reflected, refracted, straight (unbent), total (totally reflected)
///     level        1 for the camera ray; weight: how much its light can matter to the pixel
///     origin, direction
///     factor       on its radiance in its parent's; exponent: its radiance is raised to 1 / exponent before
///     end          surface, background, level or weight (not followed, too deep or too faint)
///     hit          of a surface: object (from 1), type, part, t, point, normal, inside, layers (rgb, filter, transmit; the top one first),
///                  shadows (light from 0, sample of an area light, transmitted, crossed: objects), and, where the object has a transform,
///                  object_ray (origin, direction in its own space)
///     ambient diffuse specular reflection refraction background, and radiance: the light along the ray
///     shares       local, reflection, transmission; by the course's rules alone
/// A number that is not finite is one of the strings "Infinity", "-Infinity", "NaN".
std::string ray_tree_json(const TracedPixel& pixel);

}  // namespace rt
