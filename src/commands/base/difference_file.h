// The difference of two pictures as a picture file.
#pragma once

#include <string>

#include "film/image_file.h"

namespace rt {

struct NamedImage {
    std::string name;  ///< told in the file
    const StoredImage& image;
};

/// Writes difference_picture(). Throws OptionError if the sizes differ, OutputError if it cannot be written.
void write_difference_picture(const NamedImage& a, const NamedImage& b, double scale, const std::string& path, ImageFormat format);

}  // namespace rt
