// Pictures that scenes use, read by the picture library.
#pragma once

#include <optional>
#include <string>

#include "syntax/parser.h"

namespace rt {

/// The picture at a path; empty if there is no such file. Throws OptionError for what cannot be read.
std::optional<PictureFile> read_picture_file(const std::string& path, std::size_t max_pixels);

}  // namespace rt
