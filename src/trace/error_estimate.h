// How far the means of a picture's pixels may be from the converged picture, and which pixels deserve more samples.
//
// The points of a pixel (pixel_points.h) are spread so evenly that the squared error of the mean of n samples with variance s^2 falls as
// s^2 n^-1.5 where an edge crosses the pixel, and faster where the light is smooth. Two things tell of a pixel's error: the variance of its
// samples, and how much the mean of the last n/2 differs from that of the first n/2, which also sees what varies too finely for that law.
// The larger one counts, as few samples may agree by chance; for the same reason a pixel of few samples is thought to be like its
// neighbours, and one of a single sample as different from the converged picture as its neighbours are from it.
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
    /// Bytes.
    static std::uint64_t memory(int width, int height) { return static_cast<std::uint64_t>(width) * height * sizeof(Sampled); }

    std::size_t size() const { return pixels_.size(); }
    int samples(std::size_t pixel) const { return pixels_[pixel].count; }
    /// Mean of the pixel's samples; not finite if one of them was not.
    Pixel mean(std::size_t pixel) const;

    /// Adds samples. A pixel whose light is not finite has no error and is never chosen.
    void add(std::size_t pixel, std::span<const Pixel> samples);
    /// Updates the errors of all pixels; between rounds.
    void estimate();
    /// Estimated root of the mean squared error, as of the last estimate(). The true one is below it in nearly all pictures, and about half
    /// of it on the average.
    double error() const;
    /// The pixels that lessen the error most for each further sample, as many of them as may bring it to `target`, but at most about half
    /// of what is to gain in this round. In order. None if none may have more than `most_samples`.
    /// Where pixels that may not keep the picture from the target, the others are brought to half of its square, and no further.
    std::vector<std::uint32_t> worst(double target, int most_samples) const;
    /// How many samples a pixel gets when it is chosen: it has 1, 8, 16, 32, ... Four agree by chance too often across an edge.
    int next_batch(std::size_t pixel) const { return samples(pixel) < 2 ? 7 : samples(pixel); }

private:
    struct Channels {
        float r = 0.0f, g = 0.0f, b = 0.0f, alpha = 0.0f;
    };
    struct Sampled {
        PixelSum sum;
        Channels deviations;  ///< sums of squared deviations from the mean
        Channels shown;       ///< the mean, encoded
        float halves = 0.0f;  ///< squared error that a single sample is estimated to have, by the difference of halves
        float spread = 0.0f;  ///< the same by all that is known of the pixel alone
        float error = 0.0f;   ///< estimated squared error of the mean, in its surroundings
        int count = 0;
        bool finite = true;
    };
    Channels show(const PixelSum& mean) const;
    double squared(const Channels& a, const Channels& b) const;
    double variance_spread(const Sampled& p) const;
    double contrast(int x, int y) const;
    double surroundings(int x, int y) const;

    int width_, height_;
    Encoding display_;
    std::vector<Sampled> pixels_;
    double total_ = 0.0;  ///< sum of the squared errors
};

}  // namespace rt
