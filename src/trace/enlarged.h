// A picture of which fewer pixels are traced than it has.
#pragma once

#include "trace/render.h"

namespace rt {

/// How many pixels are traced along a side of `side` pixels.
constexpr int scaled_down(int side, int scale) { return (side - 1) / scale + 1; }

/// render() for a scale above 1.
RenderResult render_enlarged(const World& world, const RenderOptions& options);

}  // namespace rt
