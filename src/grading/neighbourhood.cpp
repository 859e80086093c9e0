#include "grading/neighbourhood.h"

#include <algorithm>

#include "grading/color_picture.h"

namespace rt {

namespace {

/// Mean over the pixels of `from` of the distance to the nearest in colour of the nine around its place in `to`.
double one_way(const ColorPicture& from, const ColorPicture& to) {
    double sum = 0.0;
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x) {
            const Color& color = from.at(x, y);
            float least = apart(color, to.at(x, y));
            if (least == 0.0f) continue;
            for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, from.height - 1); ++ny)
                for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, from.width - 1); ++nx)
                    least = std::min(least, apart(color, to.at(nx, ny)));
            sum += static_cast<double>(least);
        }
    return sum / static_cast<double>(from.pixels.size());
}

}  // namespace

double neighbourhood_difference(const StoredImage& a, const StoredImage& b) {
    const ColorPicture as = color_picture(a), bs = color_picture(b);
    return std::max(one_way(as, bs), one_way(bs, as));
}

}  // namespace rt
