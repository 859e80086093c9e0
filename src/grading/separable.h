// Separable filtering of one plane of numbers; beyond the border the nearest pixel is repeated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rt {

/// An odd number of taps, the middle one at distance 0.
using Kernel = std::vector<float>;

/// One number a pixel, row by row from the top.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    float* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    const float* row(int y) const { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

/// Weighted sum of `taps` rows of `count` numbers. Sums are kept in registers over a block of pixels; each pixel adds its taps in order.
template <typename RowOfTap>
void weighted_sum(const Kernel& kernel, RowOfTap row_of_tap, int count, float* out) {
    constexpr int block = 16;
    int x = 0;
    for (; x + block <= count; x += block) {
        float sum[block] = {};
        for (int i = 0; i < static_cast<int>(kernel.size()); ++i) {
            const float* row = row_of_tap(i) + x;
            for (int j = 0; j < block; ++j) sum[j] += kernel[static_cast<std::size_t>(i)] * row[j];
        }
        std::copy(sum, sum + block, out + x);
    }
    for (; x < count; ++x) {
        float sum = 0.0f;
        for (int i = 0; i < static_cast<int>(kernel.size()); ++i) sum += kernel[static_cast<std::size_t>(i)] * row_of_tap(i)[x];
        out[x] = sum;
    }
}

/// `in` filtered along its rows.
inline Plane filter_rows(const Plane& in, const Kernel& kernel) {
    const int radius = static_cast<int>(kernel.size()) / 2;
    Plane out(in.width, in.height);
    std::vector<float> padded(static_cast<std::size_t>(in.width + 2 * radius));
    for (int y = 0; y < in.height; ++y) {
        const float* row = in.row(y);
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy(row, row + in.width, padded.begin() + radius);
        std::fill_n(padded.begin() + radius + in.width, radius, row[in.width - 1]);
        weighted_sum(
            kernel, [&](int i) { return padded.data() + i; }, in.width, out.row(y));
    }
    return out;
}

/// Row `y` of `in` filtered along its columns.
inline void filter_column(const Plane& in, int y, const Kernel& kernel, std::vector<float>& out) {
    const int radius = static_cast<int>(kernel.size()) / 2;
    out.resize(static_cast<std::size_t>(in.width));
    weighted_sum(
        kernel, [&](int i) { return in.row(std::clamp(y + i - radius, 0, in.height - 1)); }, in.width, out.data());
}

}  // namespace rt
