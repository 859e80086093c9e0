// How large pictures may be that are compared: some 100 bytes for each pixel are needed then.
#pragma once

#include <fmt/format.h>

#include "core/source.h"

namespace rt {

constexpr long most_compared_pixels = 1l << 25;  ///< 7680 x 4320 is less

/// Throws OptionError for more pixels than that.
inline void expect_comparable_size(long width, long height) {
    if (width * height > most_compared_pixels)
        throw OptionError(fmt::format("{} x {} pixels are too many to compare; at most {} are", width, height, most_compared_pixels));
}

}  // namespace rt
