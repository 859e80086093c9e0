// The numbers behind every pattern that looks random: drawn once from fixed generators, the same in every run.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/vec.h"

namespace rt {

/// A linear congruential generator that yields 15 bits at a time.
struct TableRandom {
    std::uint32_t state = 0;
    constexpr int operator()() {
        state = 1812433253U * state + 12345U;
        return static_cast<int>((state >> 16) & 0x7FFFU);
    }
};

/// A permutation of 0..4095, twice over: indices may run one past a table's end or be combined with a number below 4096 and one more.
extern const std::array<std::uint16_t, 8192> permutation;

/// 0..4095 from a cell's three whole coordinates.
inline int hash3(std::int64_t a, std::int64_t b, std::int64_t c) {
    const auto low = [](std::int64_t n) { return static_cast<unsigned>(n) & 4095U; };
    return permutation[permutation[permutation[low(a)] ^ low(b)] ^ low(c)];
}

/// floor(x) as a whole number; 0 where x has no fraction any more (|x| >= 2^52) or is none.
inline std::int64_t cell_of(double x) { return std::fabs(x) < 4503599627370496.0 ? static_cast<std::int64_t>(std::floor(x)) : 0; }

/// Uniform numbers in 0..1, by hash: three for each cell (`hash3` and the two after it).
const std::array<double, 4098>& cell_numbers();

}  // namespace rt
