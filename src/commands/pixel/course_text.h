// Every text that the course's commands print: four decimals, vectors as {x y z}, colours as bytes, pixels counted from the bottom left.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "trace/ray_log.h"

namespace rt {

/// `sceneinfo`: camera, lights, objects.
std::string sceneinfo_text(const Scene& scene);

/// Four decimals; halves are rounded away from zero as on paper, also where double precision falls short of one by its own rounding.
std::string number_text(double x);
/// "{x y z}".
std::string vector_text(const Vec3& v);
/// "{x y z} -> {x y z}".
std::string ray_text(const Ray& ray);
/// "Sphere": the type of an object with a capital first letter.
std::string type_text(const Object& object);

/// Which pixel is told of, counted from the bottom left, and its colour in the picture.
struct PixelName {
    int x = 0, y = 0;
    std::array<unsigned, 3> color{};
};

/// `pixelray`: one line.
std::string pixelray_text(const PixelName& pixel, const Ray& ray);
/// `firsthit`: the ray, and distance, type and pigment of what it meets first.
std::string firsthit_text(const PixelName& pixel, const Scene& scene, const RayNode& camera_ray);
/// `pixelcolor`: the same with the name of the shading and the pixel's colour.
std::string pixelcolor_text(const PixelName& pixel, const Scene& scene, const RayNode& camera_ray, std::string_view brdf);

/// `printrays`: every ray of the pixel's samples one below the other, parents before children, mirrors before what lies behind.
std::string printrays_text(const PixelName& pixel, const Scene& scene, std::span<const RayLog> samples);
/// `pixeltrace`: the same as a tree with drawn branches, and what each lamp's shadow ray found.
std::string pixeltrace_text(const PixelName& pixel, const Scene& scene, std::span<const RayLog> samples);

}  // namespace rt
