#include "film/quantiser.h"

#include <cmath>
#include <limits>

namespace rt {
namespace {

/// The smallest float that `encoding` quantises to k or more: the inverse curve's guess, moved to the exact place.
float threshold(std::size_t k, double levels, const Encoding& encoding) {
    Encoding inverse = encoding;
    std::swap(inverse.working, inverse.file);
    constexpr float infinite = std::numeric_limits<float>::infinity();
    float v = static_cast<float>(encode((static_cast<double>(k) - 0.5) / levels, inverse));
    while (v > 0.0f && quantise(v, encoding) >= k) v = std::nextafter(v, -infinite);
    while (quantise(v, encoding) < k) v = std::nextafter(v, infinite);
    return v;
}

}  // namespace

Quantiser::Quantiser(const Encoding& encoding, std::size_t expected) : encoding_(encoding) {
    const std::size_t levels = (std::size_t{1} << encoding.bits) - 1;
    if (expected < 8 * levels) return;
    thresholds_.resize(levels + 1);
    for (std::size_t k = 1; k <= levels; ++k) thresholds_[k] = threshold(k, static_cast<double>(levels), encoding);
    shift_ = encoding.bits == 8 ? 16 : 10;
    base_ = std::bit_cast<std::uint32_t>(thresholds_[1]) >> shift_;
    first_.resize(bucket(thresholds_[levels]) + 1);
    std::size_t k = 0;
    for (std::size_t b = 0; b < first_.size(); ++b) {
        const float start = std::bit_cast<float>((static_cast<std::uint32_t>(b) + base_) << shift_);
        while (k < levels && thresholds_[k + 1] <= start) ++k;
        first_[b] = static_cast<std::uint16_t>(k);
    }
}

}  // namespace rt
