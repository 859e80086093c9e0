#include "patterns/hash.h"

#include <random>
#include <utility>

namespace rt {

namespace {

constexpr std::array<std::uint16_t, 8192> make_permutation() {
    std::array<std::uint16_t, 8192> h{};
    for (std::uint16_t i = 0; i < 4096; ++i) h[i] = i;
    TableRandom draw;
    for (std::size_t i = 4096; i-- > 0;) std::swap(h[i], h[static_cast<std::size_t>(draw()) % 4096]);
    for (std::size_t i = 0; i < 4096; ++i) h[4096 + i] = h[i];
    return h;
}

}  // namespace

constinit const std::array<std::uint16_t, 8192> permutation = make_permutation();

const std::array<double, 4098>& cell_numbers() {
    static const auto numbers = [] {
        std::array<double, 4098> u{};
        std::mt19937 draw;  // with its standard seed, 5489
        for (double& x : u) x = static_cast<double>(draw()) * 0x1p-32;
        return u;
    }();
    return numbers;
}

}  // namespace rt
