#include "grading/neighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rt {

namespace {

using Color = std::array<float, 3>;

std::vector<Color> colors_of(const StoredImage& image) {
    const std::size_t channels = static_cast<std::size_t>(image.channels), pixels = image.values.size() / channels;
    const float scale = image.max_value > 0 ? 1.0f / static_cast<float>(image.max_value) : 1.0f;
    std::vector<Color> colors(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) colors[i][c] = image.values[i * channels + (channels < 3 ? 0 : c)] * scale;
    return colors;
}

float apart(const Color& a, const Color& b) { return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])}); }

/// Mean over the pixels of `from` of the distance to the nearest in colour of the nine around its place in `to`.
double one_way(const std::vector<Color>& from, const std::vector<Color>& to, int width, int height) {
    double sum = 0.0;
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color& color = from[at(x, y)];
            float least = apart(color, to[at(x, y)]);
            if (least == 0.0f) continue;
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, height - 1); ++ny)
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, width - 1); ++nx)
                    least = std::min(least, apart(color, to[at(nx, ny)]));
            sum += static_cast<double>(least);
        }
    return sum / static_cast<double>(from.size());
}

}  // namespace

double neighbourhood_difference(const StoredImage& a, const StoredImage& b) {
    const std::vector<Color> as = colors_of(a), bs = colors_of(b);
    return std::max(one_way(as, bs, a.width, a.height), one_way(bs, as, a.width, a.height));
}

}  // namespace rt
