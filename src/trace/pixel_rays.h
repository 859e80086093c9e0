// Pixels of a picture, explained: the light they have in the picture, and every ray that brought it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "trace/render.h"
#include "world/compile.h"

namespace rt {

struct PixelRays {
    Pixel pixel;                  ///< as `render` makes it, bit for bit
    std::vector<RayLog> samples;  ///< one for each camera ray, row by row from the top
};

/// How few rays `trace_pixel` follows with these options, where `scene_level` is the scene's max_trace_level; unset where they are many.
std::optional<FewRays> few_rays_of_pixel(const RenderOptions& options, int scene_level);

/// Pixel (x, y) of the picture that `options` describe, counted from the top left, with the rays of its samples: one, or those of a grid
/// (with anti-aliasing that looks at the neighbours, the one through the centre). `x` and `y` are inside the picture.
PixelRays trace_pixel(const World& world, RenderOptions options, int x, int y);

/// Column and row, counted from the top left.
struct PixelPlace {
    int x = 0, y = 0;
    bool operator==(const PixelPlace&) const = default;
};

/// Takes the samples of the pixel with this number, as trace_pixel() has them. Called once for each, by several threads at a time. False
/// where no more pixels are wanted.
using TakeRays = std::function<bool(std::size_t number, const std::vector<RayLog>& samples)>;

/// Rays of many pixels, on `options.threads` threads. False if they are not all: `options.stop` was raised, or `take` wanted no more.
bool trace_pixels(const World& world, const RenderOptions& options, std::span<const PixelPlace> places, const TakeRays& take);

}  // namespace rt
