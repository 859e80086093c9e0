#include "trace/error_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {

namespace {

/// Well spread samples of an edge through a pixel: the squared error of the mean of n falls as n^-1.5.
double fall(int samples) { return 1.0 / (samples * std::sqrt(static_cast<double>(samples))); }

/// Orders positive numbers as they are, in steps of 1/16 octave.
std::uint32_t step_of(float value) { return std::bit_cast<std::uint32_t>(value) >> 19; }
constexpr std::size_t steps = std::size_t{1} << 12;

}  // namespace

SampledPicture::SampledPicture(int width, int height, const Encoding& display)
    : width_(width), height_(height), display_(display), pixels_(static_cast<std::size_t>(width) * height) {}

Pixel SampledPicture::mean(std::size_t pixel) const {
    const Sampled& p = pixels_[pixel];
    return p.sum.over(p.count).pixel();
}

SampledPicture::Shown SampledPicture::show(const PixelSum& mean) const {
    const auto channel = [&](double v) { return static_cast<float>(std::clamp(encode(v, display_), 0.0, 1.0)); };
    return {channel(mean.r), channel(mean.g), channel(mean.b), display_.alpha ? static_cast<float>(1.0 - mean.transmittance) : 0.0f};
}

double SampledPicture::squared(const Shown& a, const Shown& b) const {
    const double r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b, alpha = a.alpha - b.alpha;
    return (r * r + g * g + blue * blue + alpha * alpha) / (display_.alpha ? 4.0 : 3.0);
}

void SampledPicture::add(std::size_t pixel, std::span<const Pixel> samples) {
    Sampled& p = pixels_[pixel];
    PixelSum batch;
    for (const Pixel& sample : samples) batch.add(sample);
    const int count = static_cast<int>(samples.size());
    const Shown before = p.shown, now = show(batch.over(count));
    const int old = p.count;
    p.sum.add(batch);
    p.count += count;
    p.shown = show(p.sum.over(p.count));
    const double all = p.sum.r + p.sum.g + p.sum.b + p.sum.transmittance;
    p.finite = p.finite && std::isfinite(all);
    if (!p.finite) {
        p.shown = {};
        p.spread = 0.0f;
        return;
    }
    if (old == 0) return;
    const double spread = squared(before, now) / (fall(old) + fall(count));
    p.spread = static_cast<float>(old == 1 ? spread : 0.5 * (p.spread + spread));
}

/// A single sample on one side of an edge of height d is off by d^2/24 on the average; of the eight neighbours of a pixel three are beyond
/// such an edge.
double SampledPicture::contrast(int x, int y) const {
    const Sampled& centre = pixels_[static_cast<std::size_t>(y) * width_ + x];
    double sum = 0.0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i)
            sum += squared(pixels_[static_cast<std::size_t>(j) * width_ + i].shown, centre.shown);
    return sum / 72.0;
}

double SampledPicture::surroundings(int x, int y) const {
    double sum = 0.0;
    int count = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i, ++count)
            sum += pixels_[static_cast<std::size_t>(j) * width_ + i].spread;
    }
    return sum / count;
}

void SampledPicture::estimate() {
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            Sampled& p = pixels_[static_cast<std::size_t>(y) * width_ + x];
            if (p.count == 1) p.spread = static_cast<float>(p.finite ? contrast(x, y) : 0.0);
        }
    }
    total_ = 0.0;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            Sampled& p = pixels_[static_cast<std::size_t>(y) * width_ + x];
            p.error = static_cast<float>(p.finite ? 0.5 * (p.spread + surroundings(x, y)) * fall(p.count) : 0.0);
            total_ += p.error;
        }
    }
}

double SampledPicture::error() const { return pixels_.empty() ? 0.0 : std::sqrt(total_ / static_cast<double>(pixels_.size())); }

std::vector<std::uint32_t> SampledPicture::worst(double target, int most_samples) const {
    const auto gain = [&](const Sampled& p) { return p.error * (1.0 - fall(2)); };
    const auto value = [&](std::size_t i) {
        const Sampled& p = pixels_[i];
        return p.count + next_batch(i) > most_samples ? 0.0f : static_cast<float>(gain(p) / next_batch(i));
    };
    std::vector<double> gains(steps, 0.0);
    for (std::size_t i = 0; i < pixels_.size(); ++i) gains[step_of(value(i))] += gain(pixels_[i]);
    const double wanted = std::min(total_ - target * target * static_cast<double>(pixels_.size()), 0.5 * total_);
    std::size_t least = steps;
    for (double sum = 0.0; least > 1 && sum < wanted;) sum += gains[--least];
    std::vector<std::uint32_t> chosen;
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        if (const float v = value(i); v > 0.0f && step_of(v) >= least) chosen.push_back(static_cast<std::uint32_t>(i));
    return chosen;
}

}  // namespace rt
