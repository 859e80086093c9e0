// How far apart two pictures may be: idiff's limits and its verdict.
#pragma once

#include <cstdint>
#include <limits>

#include "film/image_file.h"

namespace rt {

/// Differences are of one channel, 0..1 of full scale.
struct DifferenceLimits {
    double fail = 1e-6;                                          ///< a pixel fails beyond this
    double fail_percent = 0.0;                                   ///< of the pixels may fail
    double hard_fail = std::numeric_limits<double>::infinity();  ///< no pixel may be beyond this
    double warn = 1e-6;
    double warn_percent = 0.0;
    double hard_warn = std::numeric_limits<double>::infinity();
};

enum class Verdict { same = 0, warning = 1, failure = 2, size_differs = 3, unreadable = 4 };  ///< values are the exit status

struct PixelCounts {
    std::uint64_t failing = 0;
    std::uint64_t warning = 0;
    double largest = 0.0;
};

/// Both pictures have the same size. A missing colour channel of a grey picture is its grey; alpha counts where both have it.
PixelCounts count_pixels(const StoredImage& a, const StoredImage& b, const DifferenceLimits& limits);
Verdict verdict(const PixelCounts& counts, std::uint64_t pixels, const DifferenceLimits& limits);

}  // namespace rt
