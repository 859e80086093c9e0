#include "tests/extremes/bytes.h"

#include <algorithm>
#include <cmath>

namespace rt::extremes {

namespace {

double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

}  // namespace

Bytes encode(const Picture& picture) {
    Bytes bytes{picture.width, picture.height, {}, 0};
    for (const Rgb& pixel : picture.pixels) {
        bytes.non_finite += !rt::is_finite(pixel);
        for (int k = 0; k < 3; ++k) {
            const double shown = srgb(pixel[k] > 0.0 ? std::min(pixel[k], 1.0) : 0.0);
            bytes.values.push_back(static_cast<std::uint8_t>(std::floor(255 * shown + 0.5)));
        }
    }
    return bytes;
}

int steps_apart(const Bytes& a, const Bytes& b, std::size_t pixel) {
    int steps = 0;
    for (std::size_t k = 3 * pixel; k < 3 * pixel + 3; ++k) steps = std::max(steps, std::abs(a.values.at(k) - b.values.at(k)));
    return steps;
}

Wrong wrong(const Bytes& picture, const Bytes& truth) {
    Wrong result;
    for (std::size_t i = 0; i < truth.values.size() / 3; ++i) {
        const int steps = steps_apart(picture, truth, i);
        result.pixels += steps > 1;
        result.steps = std::max(result.steps, steps);
    }
    return result;
}

}  // namespace rt::extremes
