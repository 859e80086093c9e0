#include "patterns/density.h"

#include <array>

namespace rt {

namespace {

/// The numbers that one axis takes part with: from `first` on (which may lie outside, the grid wraps), with these weights.
struct AxisWeights {
    int first = 0;
    int count = 1;
    std::array<double, 4> weight{1.0};
};

AxisWeights weights_at(double t, int size, int interpolate) {
    const double u = t * size, whole = std::floor(u), p = u - whole, q = 1.0 - p;
    const int cell = static_cast<int>(whole);
    switch (interpolate) {
        case 0:
            return {cell, 1, {1.0}};
        case 1:
            return {cell, 2, {q, p}};
        default:
            break;
    }
    return {
        cell - 1, 4, {-p * q * q / 2.0, q * (q * (3.0 * p + 1.0) + 1.0) / 2.0, p * (p * (4.0 - 3.0 * p) + 1.0) / 2.0, -q * p * p / 2.0}};
}

/// Past its end the grid begins again. Before its beginning POV-Ray repeats the first number in x and z and wraps in y.
std::size_t wrapped(int i, int size) { return static_cast<std::size_t>((i % size + size) % size); }
std::size_t held(int i, int size) { return i < 0 ? 0 : wrapped(i, size); }

std::size_t number_from(std::string_view bytes) {
    std::size_t number = 0;
    for (const char c : bytes) number = number << 8U | static_cast<unsigned char>(c);
    return number;
}

}  // namespace

std::optional<ValueGrid> read_df3(std::string_view bytes) {
    if (bytes.size() < 6) return std::nullopt;
    const auto size = [&](std::size_t at) { return static_cast<int>(number_from(bytes.substr(at, 2))); };
    ValueGrid grid{size(0), size(2), size(4), {}};
    const auto count = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height) * static_cast<std::size_t>(grid.depth);
    bytes.remove_prefix(6);
    for (const std::size_t width : {1U, 2U, 4U}) {
        if (bytes.size() != width * count) continue;
        const double largest = std::pow(256.0, static_cast<double>(width)) - 1.0;
        grid.values.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            grid.values.push_back(static_cast<float>(static_cast<double>(number_from(bytes.substr(i * width, width))) / largest));
        return grid;
    }
    return std::nullopt;
}

double density(const DensityNumbers& numbers, const Vec3& p) {
    const ValueGrid& grid = *numbers.grid;
    const bool inside = p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0 && p.z >= 0.0 && p.z < 1.0;
    if (!inside || grid.values.empty()) return 0.0;
    const AxisWeights x = weights_at(p.x, grid.width, numbers.interpolate);
    const AxisWeights y = weights_at(p.y, grid.height, numbers.interpolate);
    const AxisWeights z = weights_at(p.z, grid.depth, numbers.interpolate);
    double sum = 0.0;
    for (int c = 0; c < z.count; ++c)
        for (int b = 0; b < y.count; ++b) {
            const std::size_t layer = held(z.first + c, grid.depth) * static_cast<std::size_t>(grid.height);
            const std::size_t row = (layer + wrapped(y.first + b, grid.height)) * static_cast<std::size_t>(grid.width);
            const double weight = z.weight[static_cast<std::size_t>(c)] * y.weight[static_cast<std::size_t>(b)];
            for (int a = 0; a < x.count; ++a)
                sum += weight * x.weight[static_cast<std::size_t>(a)] * grid.values[row + held(x.first + a, grid.width)];
        }
    return std::fmax(0.0, sum);
}

}  // namespace rt
