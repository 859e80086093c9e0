// Two pictures -> every figure of difference in one pass. Knows two images and no case.
#pragma once

#include <cstdint>

#include "film/image_file.h"

namespace rt {

struct DifferenceOptions {
    double fuzz_percent = 5.0;  ///< as ImageMagick 6 -fuzz N%
};

/// Channels are red, green, blue and, if either picture has one, alpha; a grey picture has its value in all three colours, a picture
/// without alpha is opaque. All channel values are fractions of full scale, whatever the bit depth. If only one picture holds linear
/// floats it is encoded with sRGB's curve first; two such pictures are compared as they are. A value that is no number differs from
/// every number by full scale.
struct Difference {
    bool same_size = false;  ///< if not, all other figures are 0
    std::uint64_t pixels = 0;
    std::uint64_t differing = 0;    ///< pixels with a colour that differs by more than the fuzz, exactly as ImageMagick 6 counts them (AE)
    std::uint64_t differing_0 = 0;  ///< the same at fuzz 0
    std::uint64_t differing_1 = 0;  ///< the same at fuzz 1 %
    double max = 0.0;               ///< largest channel difference, 0..1 of full scale
    int max_x = 0, max_y = 0, max_channel = 0;  ///< where it is (the first such pixel), counted from the top left
    double max_a = 0.0, max_b = 0.0;            ///< both values there
    double mean_absolute = 0.0;
    double rmse = 0.0;  ///< over all channels, 0..1
    double psnr = 0.0;  ///< dB, infinite for equal pictures
    double p99 = 0.0;   ///< 99 % of the pixels have no larger channel difference
    double flip_mean = 0.0, flip_median = 0.0, flip_q1 = 0.0, flip_q3 = 0.0, flip_min = 0.0,
           flip_max = 0.0;         ///< LDR-FLIP; quartiles are weighted
    double flip_mean_exact = 0.0;  ///< flip_mean as its authors' program sums it up, in single precision; this one without that error
};

Difference compare(const StoredImage& reference, const StoredImage& test, const DifferenceOptions& options);

/// The absolute difference of every colour channel times `scale`, clamped to 0..255, as an 8-bit RGB picture.
/// Throws OptionError if the sizes differ.
StoredImage difference_picture(const StoredImage& reference, const StoredImage& test, double scale);

}  // namespace rt
