// Separable filtering of one plane of numbers; beyond the border the nearest pixel is repeated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
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

/// Four floats that are added and multiplied at once (a compiler extension of GCC and clang).
using Float4 = float __attribute__((vector_size(16)));

/// Weighted sum of rows of `count` numbers: row `i` gets the weight kernel[i]. Each pixel adds its taps in order.
template <typename RowOfTap>
void weighted_sum(const Kernel& kernel, RowOfTap row_of_tap, int count, float* out) {
    constexpr int block = 16;
    const int taps = static_cast<int>(kernel.size());
    int x = 0;
    for (; x + block <= count; x += block) {
        Float4 sum[block / 4] = {};
        for (int i = 0; i < taps; ++i) {
            Float4 row[block / 4];
            std::memcpy(row, row_of_tap(i) + x, sizeof row);
            const float weight = kernel[static_cast<std::size_t>(i)];
            for (int j = 0; j < block / 4; ++j) sum[j] += weight * row[j];
        }
        std::memcpy(out + x, sum, sizeof sum);
    }
    for (; x < count; ++x) {
        float sum = 0.0f;
        for (int i = 0; i < taps; ++i) sum += kernel[static_cast<std::size_t>(i)] * row_of_tap(i)[x];
        out[x] = sum;
    }
}

/// A row with its end values repeated `margin` times on both sides.
class PaddedRow {
public:
    PaddedRow(int width, int margin) : width_(width), margin_(margin), values_(static_cast<std::size_t>(width + 2 * margin)) {}

    /// Fill these, then call `pad`.
    float* begin() { return values_.data() + margin_; }
    void pad() {
        std::fill_n(values_.begin(), margin_, *begin());
        std::fill_n(values_.end() - margin_, margin_, begin()[width_ - 1]);
    }
    void filter(const Kernel& kernel, float* out) const {
        const float* first = values_.data() + margin_ - static_cast<int>(kernel.size()) / 2;
        weighted_sum(
            kernel, [&](int i) { return first + i; }, width_, out);
    }

private:
    int width_, margin_;
    std::vector<float> values_;
};

/// The last rows of a picture that is read from top to bottom: as many as the largest kernel has taps.
class RowWindow {
public:
    RowWindow(int width, int height, int taps) : height_(height), taps_(taps), rows_(width, taps) {}

    float* row(int y) { return rows_.row(y % taps_); }
    /// Row `y` filtered along the columns; rows up to y + radius of the kernel must be there.
    void filter(int y, const Kernel& kernel, std::vector<float>& out) const {
        const int radius = static_cast<int>(kernel.size()) / 2;
        out.resize(static_cast<std::size_t>(rows_.width));
        const float* rows[max_taps];
        for (int i = 0; i < static_cast<int>(kernel.size()); ++i) rows[i] = rows_.row(std::clamp(y + i - radius, 0, height_ - 1) % taps_);
        weighted_sum(
            kernel, [&](int i) { return rows[i]; }, rows_.width, out.data());
    }
    static constexpr int max_taps = 64;

private:
    int height_, taps_;
    Plane rows_;
};

}  // namespace rt
