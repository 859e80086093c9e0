// Pictures that programs make of a scene file.
#pragma once

#include <optional>
#include <string>

#include "tests/extremes/bytes.h"

namespace rt::extremes {

/// The program's picture with these options, and the PNG file itself where `png` is not null. Throws std::runtime_error if it fails.
Bytes render(const std::string& scene, const std::string& options, int width, int height, std::string* png = nullptr);

bool has_povray();
/// POV-Ray's picture without anti-aliasing, encoded alike; nothing if it fails.
std::optional<Bytes> render_with_povray(const std::string& scene, int width, int height);

}  // namespace rt::extremes
