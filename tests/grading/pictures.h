// Pictures for the tests of grading.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "film/image_file.h"

namespace rt::test {

inline StoredImage picture(int width, int height, int channels, int max_value, std::vector<float> values) {
    return {width, height, channels, max_value, std::move(values)};
}

/// Every value drawn evenly from 0..max_value.
inline StoredImage random_picture(int width, int height, int channels, int max_value, std::mt19937& random) {
    StoredImage image = picture(width, height, channels, max_value, {});
    std::uniform_int_distribution<int> value(0, max_value);
    for (int i = 0; i < width * height * channels; ++i) image.values.push_back(static_cast<float>(value(random)));
    return image;
}

/// The same picture in which about half of the values move by up to `amount` of full scale.
inline StoredImage nudged(const StoredImage& image, double amount, std::mt19937& random) {
    StoredImage other = image;
    std::normal_distribution<double> step(0.0, amount * image.max_value);
    for (float& value : other.values) {
        if (random() % 2 == 0) continue;
        const double moved = std::round(static_cast<double>(value) + step(random));
        value = static_cast<float>(std::fmin(std::fmax(moved, 0.0), image.max_value));
    }
    return other;
}

}  // namespace rt::test
