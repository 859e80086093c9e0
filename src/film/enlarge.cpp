#include "film/enlarge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {

namespace {

/// The weight of a known pixel at a distance x of at most 2: Keys' cubic convolution with a = -1/2, which is Catmull and Rom's spline.
double weight(double x) {
    x = std::fabs(x);
    if (x < 1.0) return (1.5 * x - 2.5) * x * x + 1.0;
    return ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0;
}

template <class Change>
void change_colors(Film& film, Change change) {
    for (Pixel& p : film.pixels) p.r = change(p.r), p.g = change(p.g), p.b = change(p.b);
}

}  // namespace

Stretch::Stretch(int small, int large, int begin, int end) {
    const auto clamped = [&](int place) { return std::clamp(place, 0, small - 1); };
    const auto place_of = [&](int pixel) { return (pixel + 0.5) * small / large - 0.5; };
    const auto nearest_below = [&](int pixel) { return static_cast<int>(std::floor(place_of(pixel))); };
    first_ = clamped(nearest_below(begin) - 1);
    last_ = clamped(nearest_below(end - 1) + 2) + 1;
    for (int pixel = begin; pixel < end; ++pixel) {
        Taps& taps = taps_.emplace_back();
        for (int k = 0; k < 4; ++k) {
            const int place = nearest_below(pixel) - 1 + k;
            taps.places[k] = clamped(place) - first_;
            taps.weights[k] = static_cast<float>(weight(place_of(pixel) - place));
        }
    }
}

Pixel Stretch::at(int i, const Pixel* line, std::ptrdiff_t stride) const {
    const Taps& taps = taps_[static_cast<std::size_t>(i)];
    Pixel sum;
    for (int k = 0; k < 4; ++k) {
        const Pixel& p = line[taps.places[k] * stride];
        const float w = taps.weights[k];
        sum.r += w * p.r, sum.g += w * p.g, sum.b += w * p.b, sum.transmittance += w * p.transmittance;
    }
    // Beside an edge the cubic goes beyond the known values, and so beyond the largest number.
    const auto finite = [](float v) { return std::clamp(v, -std::numeric_limits<float>::max(), std::numeric_limits<float>::max()); };
    sum.r = finite(sum.r), sum.g = finite(sum.g), sum.b = finite(sum.b);
    return sum;
}

Film enlarge(Film small, const Stretch& across, const Stretch& down, Filtered filtered) {
    if (filtered == Filtered::square_roots) change_colors(small, [](float v) { return std::sqrt(std::max(v, 0.0f)); });
    Film wide(across.count(), small.height);
    for (int y = 0; y < wide.height; ++y)
        for (int x = 0; x < wide.width; ++x) wide.at(x, y) = across.at(x, &small.at(0, y), 1);
    Film large(across.count(), down.count());
    for (int y = 0; y < large.height; ++y) {
        for (int x = 0; x < large.width; ++x) {
            const Pixel p = down.at(y, &wide.at(x, 0), wide.width);
            large.at(x, y) = {std::max(p.r, 0.0f), std::max(p.g, 0.0f), std::max(p.b, 0.0f), std::clamp(p.transmittance, 0.0f, 1.0f)};
        }
    }
    if (filtered == Filtered::square_roots)
        change_colors(large, [](float v) { return std::min(v * v, std::numeric_limits<float>::max()); });
    return large;
}

}  // namespace rt
