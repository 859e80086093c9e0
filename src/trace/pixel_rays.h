// One pixel of a picture, explained: the light it has in the picture, and every ray that brought it.
#pragma once

#include <vector>

#include "trace/render.h"

namespace rt {

struct PixelRays {
    Pixel pixel;                  ///< as `render` makes it, bit for bit
    std::vector<RayLog> samples;  ///< one for each camera ray, row by row from the top
};

/// Pixel (x, y) of the picture that `options` describe, counted from the top left, with the rays of its samples: one, or those of a grid
/// (with anti-aliasing that looks at the neighbours, the one through the centre). `x` and `y` are inside the picture.
PixelRays trace_pixel(const World& world, RenderOptions options, int x, int y);

}  // namespace rt
