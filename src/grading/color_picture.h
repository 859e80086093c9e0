// A picture as three numbers a pixel, whatever its file held: what judgements about its content work on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "film/image_file.h"
#include "grading/pixel_sources.h"

namespace rt {

using Color = std::array<float, 3>;

struct ColorPicture {
    int width = 0, height = 0;
    std::vector<Color> pixels;  ///< 0..1 of full scale, row by row from the top; linear floats as they are

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    const Color& at(int x, int y) const { return pixels[index(x, y)]; }
    const Color& at(const std::array<int, 2>& place) const { return at(place[0], place[1]); }
    /// Outside is what its border has.
    const Color& nearest(int x, int y) const { return at(nearest_place(*this, x, y)); }
};

/// Grey pictures have their value in all three; alpha is left out.
inline ColorPicture color_picture(const StoredImage& image) {
    const std::size_t channels = static_cast<std::size_t>(image.channels), pixels = image.values.size() / channels;
    const float scale = image.max_value > 0 ? 1.0f / static_cast<float>(image.max_value) : 1.0f;
    ColorPicture picture{image.width, image.height, std::vector<Color>(pixels)};
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) picture.pixels[i][c] = image.values[i * channels + (channels < 3 ? 0 : c)] * scale;
    return picture;
}

/// The largest difference of a channel.
inline float apart(const Color& a, const Color& b) {
    return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

}  // namespace rt
