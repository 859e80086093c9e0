// A picture in linear light.
#pragma once

#include <vector>

#include "core/vec.h"

namespace rt::extremes {

/// Row by row from the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<Rgb> pixels;
};

}  // namespace rt::extremes
