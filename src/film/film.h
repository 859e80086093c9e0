// Pixels of one picture: linear radiance in the scene's working space, and the transmittance of the camera ray.
#pragma once

#include <cstddef>
#include <vector>

namespace rt {

/// Single precision, as POV-Ray keeps its colours. `transmittance` is 1 where the ray reached a transparent background, 0 on opaque things.
struct Pixel {
    float r = 0.0f, g = 0.0f, b = 0.0f, transmittance = 0.0f;
    bool operator==(const Pixel&) const = default;
};

struct Film {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;  ///< row by row from the top

    Film() = default;
    Film(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    Pixel& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
    const Pixel& at(int x, int y) const { return const_cast<Film*>(this)->at(x, y); }
};

}  // namespace rt
