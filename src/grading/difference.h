// Two pictures -> every figure of difference in one pass, and a verdict under given limits. Knows two images and no case.
#pragma once

#include <cstdint>
#include <string>

#include "film/image_file.h"

namespace rt {

struct DifferenceOptions {
    double fuzz_percent = 5.0;  ///< as ImageMagick 6 -fuzz N%
};

struct Difference {
    bool same_size = false;
    std::uint64_t pixels = 0;
    std::uint64_t differing = 0;        ///< pixels whose colour distance exceeds the fuzz, exactly as ImageMagick 6 counts them (AE)
    std::uint64_t differing_0 = 0;      ///< the same at fuzz 0
    std::uint64_t differing_1 = 0;      ///< the same at fuzz 1 %
    double max = 0.0;                   ///< largest channel difference, 0..1 of full scale
    int max_x = 0, max_y = 0, max_channel = 0;
    double max_a = 0.0, max_b = 0.0;    ///< both values there
    double mean_absolute = 0.0;
    double rmse = 0.0;                  ///< over all channels, 0..1
    double psnr = 0.0;                  ///< dB, infinite for equal pictures
    double p99 = 0.0;                   ///< 99th percentile of the pixels' largest channel difference
    double flip_mean = 0.0, flip_median = 0.0, flip_q1 = 0.0, flip_q3 = 0.0, flip_min = 0.0, flip_max = 0.0;  ///< LDR-FLIP; quartiles are weighted
};

Difference compare(const StoredImage& reference, const StoredImage& test, const DifferenceOptions& options);

}  // namespace rt
