#include "trace/error_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {

namespace {

/// The squared error of the mean of n samples, in parts of their variance.
double fall(int samples) { return 1.0 / (samples * std::sqrt(static_cast<double>(samples))); }

/// The halves of 2m samples make up for each other's errors: with e(m) = m^-1.5 and e(2m) = (1 + rho) / 2 e(m), rho = 2^-0.5 - 1. Their
/// means differ by 2 (1 - rho) e(m) = 4 (1 - rho) / (1 + rho) e(2m), squared and on the average.
constexpr double difference_of_halves = 4.0 * (2.0 - 0.70710678118654752) / 0.70710678118654752;

/// A pixel's neighbours say of it as much as so many samples.
constexpr double samples_of_neighbours = 20.0;

/// A pixel with nothing to be seen in it or about it may hide something yet: as much as so large a part of the picture's mean.
constexpr double unseen_share = 0.01;

/// What the estimate is multiplied with. Without it the true error was 0.4 to 1.22 times the estimate in pictures of 15 scenes at four
/// errors each, and below 1.1 in 95 % of them (tests/bench/validate_error tells of others).
constexpr double caution = 1.4;

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

SampledPicture::Channels SampledPicture::show(const PixelSum& mean) const {
    const auto channel = [&](double v) { return static_cast<float>(std::clamp(encode(v, display_), 0.0, 1.0)); };
    return {channel(mean.r), channel(mean.g), channel(mean.b), display_.alpha ? static_cast<float>(1.0 - mean.transmittance) : 0.0f};
}

double SampledPicture::squared(const Channels& a, const Channels& b) const {
    const double r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b, alpha = a.alpha - b.alpha;
    return (r * r + g * g + blue * blue + alpha * alpha) / (display_.alpha ? 4.0 : 3.0);
}

void SampledPicture::add(std::size_t pixel, std::span<const Pixel> samples) {
    Sampled& p = pixels_[pixel];
    PixelSum batch;
    for (const Pixel& sample : samples) batch.add(sample);
    const int count = static_cast<int>(samples.size()), old = p.count;
    const PixelSum last = batch.over(count), first = p.sum.over(std::max(old, 1));
    // Chan, Golub and LeVeque, 1979: deviations of both parts from their own means, and of the means from each other.
    const auto deviations = [&](float Pixel::*channel, double last_mean, double first_mean) {
        double sum = (last_mean - first_mean) * (last_mean - first_mean) * old * count / (old + count);
        for (const Pixel& sample : samples) sum += (sample.*channel - last_mean) * (sample.*channel - last_mean);
        return static_cast<float>(sum);
    };
    p.deviations.r += deviations(&Pixel::r, last.r, first.r);
    p.deviations.g += deviations(&Pixel::g, last.g, first.g);
    p.deviations.b += deviations(&Pixel::b, last.b, first.b);
    p.deviations.alpha += deviations(&Pixel::transmittance, last.transmittance, first.transmittance);
    const Channels before = p.shown;
    p.sum.add(batch);
    p.count += count;
    const PixelSum& sum = p.sum;
    p.finite = p.finite && std::isfinite(sum.r + sum.g + sum.b + sum.transmittance);
    p.spread = 0.0f;
    p.shown = p.finite ? show(p.sum.over(p.count)) : Channels{};
    if (old == 0 || !p.finite) return;
    const double apart = squared(before, show(last));
    if (old == 1) {
        p.halves = static_cast<float>(apart / (fall(old) + fall(count)));
    } else {
        p.halves = static_cast<float>(0.5 * (p.halves + apart / (difference_of_halves * fall(p.count))));
    }
    p.spread = std::max(p.halves, static_cast<float>(variance_spread(p)));
}

/// By the variance of samples: half the distance, as it is shown, between the mean's standard deviation above and below it.
double SampledPicture::variance_spread(const Sampled& p) const {
    const double scale = fall(p.count) / (p.count - 1);
    const PixelSum mean = p.sum.over(p.count);
    const auto moved = [&](double sign) {
        const auto deviation = [&](float sum) { return sign * std::sqrt(sum * scale); };
        return show({mean.r + deviation(p.deviations.r), mean.g + deviation(p.deviations.g), mean.b + deviation(p.deviations.b),
                     mean.transmittance + deviation(p.deviations.alpha)});
    };
    return 0.25 * squared(moved(1.0), moved(-1.0)) / fall(p.count);
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
    double all = 0.0;
    for (const Sampled& p : pixels_) all += p.spread;
    const double unseen = unseen_share * all / static_cast<double>(pixels_.size());
    total_ = 0.0;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            Sampled& p = pixels_[static_cast<std::size_t>(y) * width_ + x];
            const double neighbours = samples_of_neighbours / (samples_of_neighbours + p.count - 1);
            const double spread = neighbours * (surroundings(x, y) + unseen) + (1.0 - neighbours) * p.spread;
            p.error = static_cast<float>(p.finite ? caution * caution * spread * fall(p.count) : 0.0);
            total_ += p.error;
        }
    }
}

double SampledPicture::error() const { return pixels_.empty() ? 0.0 : std::sqrt(total_ / static_cast<double>(pixels_.size())); }

std::vector<std::uint32_t> SampledPicture::worst(double target, int most_samples) const {
    const auto gain = [&](const Sampled& p) { return p.error * (1.0 - fall(p.count < 2 ? 8 : 2)); };
    const auto value = [&](std::size_t i) {
        const Sampled& p = pixels_[i];
        return p.count + next_batch(i) > most_samples ? 0.0f : static_cast<float>(gain(p) / next_batch(i));
    };
    std::vector<double> gains(steps, 0.0);
    double open = 0.0;  // what the pixels that may have more are off
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const float v = value(i);
        gains[step_of(v)] += gain(pixels_[i]);
        if (v > 0.0f) open += pixels_[i].error;
    }
    const double allowed = target * target * static_cast<double>(pixels_.size());
    const bool out_of_reach = total_ - open >= allowed;
    const double wanted = out_of_reach ? std::min(open - 0.5 * allowed, 0.5 * open) : std::min(total_ - allowed, 0.5 * total_);
    if (out_of_reach && wanted <= 0.0) return {};
    std::size_t least = steps;
    for (double sum = 0.0; least > 1 && sum < wanted;) sum += gains[--least];
    std::vector<std::uint32_t> chosen;
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        if (const float v = value(i); v > 0.0f && step_of(v) >= least) chosen.push_back(static_cast<std::uint32_t>(i));
    return chosen;
}

}  // namespace rt
