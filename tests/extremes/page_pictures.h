// Pictures inside a page of HTML.
#pragma once

#include <string>
#include <string_view>

#include "tests/extremes/bytes.h"

namespace rt::extremes {

/// The bytes as a PNG file.
std::string png(const Bytes& bytes);

/// Grey where a picture is the truth, blue for one step, from yellow to red for more.
Bytes difference(const Bytes& picture, const Bytes& truth);

/// A figure that holds a PNG file.
std::string image(const std::string& data, std::string_view caption);

}  // namespace rt::extremes
