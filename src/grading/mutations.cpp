#include "grading/mutations.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "grading/pixel_sources.h"

namespace rt {

namespace {

/// The picture whose pixel (x, y) is the pixel source(x, y) of `image`.
template <typename Source>
StoredImage rearranged(const StoredImage& image, Source source) {
    StoredImage result = image;
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    const auto at = [&](int x, int y) {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * channels;
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto [sx, sy] = source(x, y);
            std::copy_n(image.values.begin() + static_cast<std::ptrdiff_t>(at(sx, sy)), channels,
                        result.values.begin() + static_cast<std::ptrdiff_t>(at(x, y)));
        }
    return result;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

StoredImage scaled(const StoredImage& image, double factor) {
    StoredImage result = image;
    const std::size_t channels = static_cast<std::size_t>(image.channels), colors = channels < 3 ? 1 : 3;
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        if (i % channels >= colors) continue;
        const double value = static_cast<double>(result.values[i]) * factor;
        result.values[i] =
            static_cast<float>(image.max_value > 0 ? std::min(std::round(value), static_cast<double>(image.max_value)) : value);
    }
    return result;
}

StoredImage mirrored(const StoredImage& image) {
    return rearranged(image, [&](int x, int y) { return mirrored_place(image, x, y); });
}

StoredImage shifted(const StoredImage& image, int dx, int dy) {
    return rearranged(image, [&](int x, int y) { return nearest_place(image, x - dx, y - dy); });
}

std::optional<std::string> one_digit_changed(std::string_view text) {
    for (std::size_t end = text.size(); end > 0; --end) {
        if (!is_digit(text[end - 1])) continue;
        std::size_t begin = end;
        while (begin > 0 && is_digit(text[begin - 1])) --begin;
        if (begin > 1 && text[begin - 1] == '.' && is_digit(text[begin - 2])) {
            std::string changed(text);
            char& digit = changed[end - 1];
            digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
            return changed;
        }
        end = begin + 1;
    }
    return std::nullopt;
}

}  // namespace rt
