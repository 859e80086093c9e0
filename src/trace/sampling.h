// How the pixels of a tile become samples. Pure algorithms on any function of the picture plane: no world, no threads.
#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <vector>

#include "core/vec.h"
#include "film/film.h"
#include "trace/options.h"

namespace rt {

/// Columns [x0, x1) and rows [y0, y1) of the full picture.
struct Region {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

/// Every pixel of a grid has n x n samples, any other one to begin with.
int samples_a_side(const Sampling& sampling);

/// The picture at points (x, y), in pixels of a picture `scale` times as wide and high; pixel (i, j) of the picture itself has its centre
/// at (i + 1/2, j + 1/2) with scale 1. Asked outside the picture, too. The same point gives the same pixel whenever and in whatever company
/// it is asked for; neighbours asked for together are cheaper.
using Samples = std::function<void(std::span<const Vec2> points, int scale, std::span<Pixel> pixels)>;

/// What makes of a colour the number that anti-aliasing compares: linear light to the power of 1 / Antialias_Gamma.
struct Comparison {
    double exponent = 1.0 / 2.5;  ///< working gamma / Antialias_Gamma
    bool srgb = false;            ///< the sRGB curve is decoded first
    double operator()(double value) const;
};

/// Everything but the rectangle.
struct SamplingTask {
    Sampling sampling;
    Comparison comparison;
    const std::atomic<bool>* stop = nullptr;  ///< looked at before every row, or before every pixel that may take several samples
    Samples samples;

    Pixel sample(double x, double y) const {
        const Vec2 point(x, y);
        Pixel pixel;
        samples({&point, 1}, 1, {&pixel, 1});
        return pixel;
    }
    bool stopped() const { return stop && stop->load(std::memory_order_relaxed); }
};

/// Samples of a tile, row by row from its top; all values unclamped averages in the working space.
/// Returns how many rows are final: all of them unless stopped. For POV-Ray's first method `tile` is one of its blocks, cut by the
/// picture's edges only.
int sample_tile(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels);

int sample_centres(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels);
/// The centres of n x n sub-pixels: exactly the pixels of a picture n times as large.
int sample_grid(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels);
/// POV-Ray's non-adaptive method: pixels that differ from the left or upper neighbour are sampled again n x n times.
int sample_povray1(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels);
/// POV-Ray's adaptive method: corners of pixels, divided in four while they differ, at most depth - 1 times.
int sample_povray2(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels);

/// Sum of samples in double precision.
struct PixelSum {
    double r = 0.0, g = 0.0, b = 0.0, transmittance = 0.0;
    void add(const Pixel& p) { r += p.r, g += p.g, b += p.b, transmittance += p.transmittance; }
    void add(const PixelSum& s) { r += s.r, g += s.g, b += s.b, transmittance += s.transmittance; }
    PixelSum over(double count) const { return {r / count, g / count, b / count, transmittance / count}; }
    Pixel pixel() const { return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b), static_cast<float>(transmittance)}; }
};

/// A pixel as anti-aliasing compares it: colours as numbers of a comparison, transmittance as it is.
struct Contrast {
    double r = 0.0, g = 0.0, b = 0.0, transmittance = 0.0;
    Contrast() = default;
    Contrast(const Pixel& p, const Comparison& comparison);
};

/// Sum of the absolute differences, what the threshold is compared with.
double distance(const Contrast& a, const Contrast& b);

}  // namespace rt
