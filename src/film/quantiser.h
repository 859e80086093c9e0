// quantise() for millions of single-precision values: the same numbers from a table of thresholds.
#pragma once

#include <bit>
#include <cstddef>

#include "film/encode.h"

namespace rt {

/// Equal to `quantise(value, encoding)` for every float. The formula never falls as the value grows, so the smallest float of every
/// output number tells everything; the table holds those floats, found with the formula itself.
class Quantiser {
public:
    /// Builds the table only when `expected` values repay it.
    Quantiser(const Encoding& encoding, std::size_t expected);

    std::uint16_t operator()(float value) const {
        if (thresholds_.empty()) return quantise(value, encoding_);
        if (!(value >= thresholds_[1])) return 0;
        if (value >= thresholds_.back()) return static_cast<std::uint16_t>(thresholds_.size() - 1);
        std::size_t k = first_[bucket(value)];
        while (value >= thresholds_[k + 1]) ++k;
        return static_cast<std::uint16_t>(k);
    }

private:
    std::size_t bucket(float value) const { return (std::bit_cast<std::uint32_t>(value) >> shift_) - base_; }

    Encoding encoding_;
    std::vector<float> thresholds_;     ///< [k]: the smallest float that becomes k or more
    std::vector<std::uint16_t> first_;  ///< by leading bits of the float: the number its bucket begins with
    int shift_ = 0;
    std::uint32_t base_ = 0;
};

}  // namespace rt
