// How far the means of a picture's pixels may be from the converged picture, and which pixels deserve more samples.
#pragma once

#include <cstdint>
#include <vector>

#include "film/encode.h"
#include "trace/sampling.h"

namespace rt {

/// The samples of every pixel of a picture, as sums, with what they tell of its error. Different pixels may be added to by different
/// threads.
class SampledPicture {
public:
    /// Errors are those of encoded channels, 0..1; with alpha there are four.
    SampledPicture(int width, int height, const Encoding& display);

    std::size_t size() const { return pixels_.size(); }
    int samples(std::size_t pixel) const { return pixels_[pixel].count; }
    /// Mean of the pixel's samples; not finite if one of them was not.
    Pixel mean(std::size_t pixel) const;

    /// Adds samples. A pixel whose light is not finite has no error and is never chosen.
    void add(std::size_t pixel, std::span<const Pixel> samples);
    /// Updates the errors of all pixels; between rounds.
    void estimate();
    /// Estimated root of the mean squared error, as of the last estimate().
    double error() const;
    /// The pixels that lessen the error most for each further sample, as many of them as may bring it to `target`, but at most about half
    /// of what is to gain in this round. In order. None if none may have more than `most_samples`.
    std::vector<std::uint32_t> worst(double target, int most_samples) const;
    /// How many samples a pixel gets when it is chosen.
    int next_batch(std::size_t pixel) const { return samples(pixel) < 2 ? 3 : samples(pixel); }

private:
    struct Shown {
        float r = 0.0f, g = 0.0f, b = 0.0f, alpha = 0.0f;
    };
    struct Sampled {
        PixelSum sum;
        Shown shown;          ///< the mean
        float spread = 0.0f;  ///< squared error that a single sample is estimated to have
        float error = 0.0f;   ///< estimated squared error of the mean, in its surroundings
        int count = 0;
        bool finite = true;
    };
    Shown show(const PixelSum& mean) const;
    double squared(const Shown& a, const Shown& b) const;
    double contrast(int x, int y) const;
    double surroundings(int x, int y) const;

    int width_, height_;
    Encoding display_;
    std::vector<Sampled> pixels_;
    double total_ = 0.0;  ///< sum of the squared errors
};

}  // namespace rt
