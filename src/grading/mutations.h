// Right answers made wrong in one way: what a test cannot tell from the right one it cannot notice in a program either.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "film/image_file.h"

namespace rt {

/// Every colour channel times `factor`, rounded; alpha stays.
StoredImage scaled(const StoredImage& image, double factor);
/// Left and right exchanged.
StoredImage mirrored(const StoredImage& image);
/// Moved to the right and down by whole pixels; what comes into view repeats the border.
StoredImage shifted(const StoredImage& image, int dx, int dy);
/// The last digit of the last number with a decimal point becomes the next one (9: 8); empty if the text has no such number.
std::optional<std::string> one_digit_changed(std::string_view text);

}  // namespace rt
