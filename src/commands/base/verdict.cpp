#include "commands/base/verdict.h"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

/// Channels of one picture by the meaning they share with the other, as 0..1.
class Channels {
public:
    explicit Channels(const StoredImage& image)
        : image_(image), scale_(image.max_value > 0 ? 1.0 / image.max_value : 1.0), colors_(image.channels >= 3 ? 3 : 1) {}

    bool has_alpha() const { return image_.channels > colors_; }
    /// c = 0, 1, 2 are red, green and blue; 3 is alpha.
    double at(std::size_t pixel, int c) const {
        const int channel = c == 3 ? colors_ : std::min(c, colors_ - 1);
        return scale_ * image_.values[pixel * static_cast<std::size_t>(image_.channels) + static_cast<std::size_t>(channel)];
    }

private:
    const StoredImage& image_;
    double scale_;
    int colors_;
};

/// A difference with NaN on one side only is infinite.
double difference(double a, double b) {
    const double d = std::fabs(a - b);
    if (!std::isnan(d)) return d;
    return (std::isnan(a) && std::isnan(b)) || a == b ? 0.0 : HUGE_VAL;
}

std::size_t pixels_of(const StoredImage& image) { return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height); }

}  // namespace

PixelCounts count_pixels(const StoredImage& a, const StoredImage& b, const DifferenceLimits& limits) {
    const Channels left(a), right(b);
    const int channels = left.has_alpha() && right.has_alpha() ? 4 : 3;
    PixelCounts counts;
    for (std::size_t pixel = 0; pixel < pixels_of(a); ++pixel) {
        double largest = 0.0;
        for (int c = 0; c < channels; ++c) largest = std::max(largest, difference(left.at(pixel, c), right.at(pixel, c)));
        counts.failing += largest > limits.fail;
        counts.warning += largest > limits.warn;
        counts.largest = std::max(counts.largest, largest);
    }
    return counts;
}

Verdict verdict(const PixelCounts& counts, std::uint64_t pixels, const DifferenceLimits& limits) {
    const auto n = static_cast<double>(pixels);
    if (static_cast<double>(counts.failing) > limits.fail_percent / 100.0 * n || counts.largest > limits.hard_fail) return Verdict::failure;
    if (static_cast<double>(counts.warning) > limits.warn_percent / 100.0 * n || counts.largest > limits.hard_warn) return Verdict::warning;
    return Verdict::same;
}

}  // namespace rt
