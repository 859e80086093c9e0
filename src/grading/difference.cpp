#include "grading/difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/source.h"
#include "grading/flip.h"

namespace rt {

namespace {

constexpr double full_scale = 65535.0;  // ImageMagick's quantum: 8-bit values times 257, 16-bit ones as they are

double srgb_encode(double linear) {
    if (!(linear > 0.0)) return linear != linear ? linear : 0.0;
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double srgb_decode(double stored) { return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4); }

/// A picture as red, green, blue and alpha in quanta; single precision holds integer ones exactly.
class Quanta {
public:
    using Rgba = std::array<float, 4>;

    Quanta(const StoredImage& image, bool encode) : image_(image), encode_(encode), channels_(static_cast<std::size_t>(image.channels)) {
        for (int value = 0; value <= image.max_value && image.max_value > 0; ++value) {
            table_.push_back(static_cast<float>(std::floor(value * full_scale / image.max_value + 0.5)));
            linear_.push_back(static_cast<float>(srgb_decode(static_cast<double>(value) / image.max_value)));
        }
    }
    bool has_alpha() const { return channels_ == 2 || channels_ == 4; }

    Rgba at(std::size_t pixel) const {
        const float* value = image_.values.data() + pixel * channels_;
        const bool grey = channels_ < 3;
        const float opaque = static_cast<float>(full_scale);
        return {colour(value[0]), colour(value[grey ? 0 : 1]), colour(value[grey ? 0 : 2]),
                has_alpha() ? quantum(value[channels_ - 1]) : opaque};
    }

    /// Colours without alpha as linear light in 0..1, what FLIP looks at.
    void put_linear(std::size_t pixel, LinearPlanes& planes) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const float value = image_.values[pixel * channels_ + (channels_ < 3 ? 0 : i)];
            planes[i].values[pixel] = linear_.empty() ? std::clamp(value > 0.0f ? value : 0.0f, 0.0f, 1.0f) : linear_[index(value)];
        }
    }

private:
    std::size_t index(float value) const { return static_cast<std::size_t>(std::clamp(value, 0.0f, static_cast<float>(image_.max_value))); }
    float quantum(float value) const {
        if (!table_.empty()) return table_[index(value)];
        constexpr double limit = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp(static_cast<double>(value) * full_scale, -limit, limit));
    }
    float colour(float value) const {
        return encode_ ? static_cast<float>(std::min(srgb_encode(static_cast<double>(value)), 1e30) * full_scale) : quantum(value);
    }

    const StoredImage& image_;
    bool encode_;
    std::size_t channels_;
    std::vector<float> table_, linear_;
};

/// What ImageMagick 6 counts as a differing pixel (`compare -metric AE -fuzz N%`): any one of red, green and blue differs by the fuzz
/// or more; the fuzz is a share of 65536 and never less than sqrt(1/2). Alpha itself is not compared; if the first picture has an alpha
/// channel the colours of both are multiplied by their alpha.
class FuzzyCounter {
public:
    FuzzyCounter(double percent, bool multiply_by_alpha) : multiply_by_alpha_(multiply_by_alpha) {
        const double fuzz = std::max(percent / 100.0 * (full_scale + 1.0), std::sqrt(0.5));
        square_ = fuzz * fuzz;
    }
    void add(const Quanta::Rgba& a, const Quanta::Rgba& b) {
        const double alpha_a = multiply_by_alpha_ ? static_cast<double>(a[3]) / full_scale : 1.0;
        const double alpha_b = multiply_by_alpha_ ? static_cast<double>(b[3]) / full_scale : 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double difference = alpha_a * static_cast<double>(a[i]) - alpha_b * static_cast<double>(b[i]);
            const bool nan_in_one = std::isnan(a[i]) != std::isnan(b[i]);
            if (difference * difference >= square_ || nan_in_one) {
                ++count;
                return;
            }
        }
    }
    std::uint64_t count = 0;

private:
    bool multiply_by_alpha_;
    double square_ = 0.0;
};

/// Difference of two quanta as a share of full scale.
double channel_difference(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b) ? 0.0 : 1.0;
    return std::fabs(static_cast<double>(a) - static_cast<double>(b)) / full_scale;
}

/// Sums over channels and pixels.
class Totals {
public:
    Totals(std::size_t channels, std::size_t pixels) : channels_(channels) { largest_.reserve(pixels); }

    void add(const Quanta::Rgba& a, const Quanta::Rgba& b, Difference& result, int width) {
        double largest = 0.0;
        for (std::size_t i = 0; i < channels_; ++i) {
            const double difference = channel_difference(a[i], b[i]);
            absolute_ += difference;
            squares_ += difference * difference;
            largest = std::max(largest, difference);
            if (difference > result.max) {
                const std::size_t row_length = static_cast<std::size_t>(width);
                result.max = difference;
                result.max_x = static_cast<int>(largest_.size() % row_length);
                result.max_y = static_cast<int>(largest_.size() / row_length);
                result.max_channel = static_cast<int>(i);
                result.max_a = static_cast<double>(a[i]) / full_scale;
                result.max_b = static_cast<double>(b[i]) / full_scale;
            }
        }
        largest_.push_back(largest);
    }
    void add_equal() { largest_.push_back(0.0); }
    void finish(Difference& result) {
        const double count = static_cast<double>(largest_.size() * channels_);
        result.mean_absolute = absolute_ / count;
        result.rmse = std::sqrt(squares_ / count);
        result.psnr = squares_ > 0.0 ? -20.0 * std::log10(result.rmse) : std::numeric_limits<double>::infinity();
        const std::size_t rank = (largest_.size() * 99 + 99) / 100 - 1;
        std::nth_element(largest_.begin(), largest_.begin() + static_cast<std::ptrdiff_t>(rank), largest_.end());
        result.p99 = largest_[rank];
    }

private:
    std::size_t channels_;
    double absolute_ = 0.0, squares_ = 0.0;
    std::vector<double> largest_;
};

bool comparable(const StoredImage& a, const StoredImage& b) {
    return a.width == b.width && a.height == b.height && a.width > 0 && a.height > 0;
}

}  // namespace

Difference compare(const StoredImage& reference, const StoredImage& test, const DifferenceOptions& options) {
    Difference result;
    if (!comparable(reference, test)) return result;
    result.same_size = true;
    result.pixels = static_cast<std::uint64_t>(reference.width) * static_cast<std::uint64_t>(reference.height);

    const bool both_linear = reference.max_value == 0 && test.max_value == 0;
    const Quanta a(reference, reference.max_value == 0 && !both_linear), b(test, test.max_value == 0 && !both_linear);
    FuzzyCounter counters[] = {{options.fuzz_percent, a.has_alpha()}, {0.0, a.has_alpha()}, {1.0, a.has_alpha()}};
    Totals totals(a.has_alpha() || b.has_alpha() ? 4 : 3, result.pixels);
    const Plane blank(reference.width, reference.height);
    LinearPlanes linear_a{blank, blank, blank}, linear_b = linear_a;
    for (std::size_t pixel = 0; pixel < result.pixels; ++pixel) {
        const Quanta::Rgba pa = a.at(pixel), pb = b.at(pixel);
        if (pa == pb) {
            totals.add_equal();
        } else {
            for (FuzzyCounter& counter : counters) counter.add(pa, pb);
            totals.add(pa, pb, result, reference.width);
        }
        a.put_linear(pixel, linear_a);
        b.put_linear(pixel, linear_b);
    }
    result.differing = counters[0].count;
    result.differing_0 = counters[1].count;
    result.differing_1 = counters[2].count;
    totals.finish(result);

    const FlipSummary error = summarise(flip(linear_a, linear_b));
    result.flip_mean = error.mean;
    result.flip_mean_exact = error.mean_exact;
    result.flip_median = error.median;
    result.flip_q1 = error.q1;
    result.flip_q3 = error.q3;
    result.flip_min = error.min;
    result.flip_max = error.max;
    return result;
}

StoredImage difference_picture(const StoredImage& reference, const StoredImage& test, double scale) {
    if (!comparable(reference, test)) throw OptionError("pictures of different sizes have no difference picture");
    const bool both_linear = reference.max_value == 0 && test.max_value == 0;
    const Quanta a(reference, reference.max_value == 0 && !both_linear), b(test, test.max_value == 0 && !both_linear);
    StoredImage picture;
    picture.width = reference.width;
    picture.height = reference.height;
    picture.channels = 3;
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.values.reserve(3 * pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const Quanta::Rgba pa = a.at(pixel), pb = b.at(pixel);
        for (std::size_t i = 0; i < 3; ++i) {
            const double value = std::min(channel_difference(pa[i], pb[i]) * scale, 1.0);
            picture.values.push_back(static_cast<float>(std::floor(255.0 * value + 0.5)));
        }
    }
    return picture;
}

}  // namespace rt
