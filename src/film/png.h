// PNG through libpng.
#pragma once

#include "film/image_file.h"
#include "film/output_file.h"

namespace rt {

/// 8 or 16 bits, RGB or RGBA, with gAMA and sRGB chunks for the encoding and the metadata as text.
/// Throws OutputError.
void write_png(const Film& film, OutputFile& file, const Encoding& encoding, const ImageMetadata& metadata);

/// Any PNG. Palettes come out as RGB or RGBA, 1-, 2- and 4-bit grey as 8-bit grey, a transparent colour as an alpha channel.
/// Throws OptionError that names `path`.
StoredImage read_png(std::FILE* file, const std::string& path);

}  // namespace rt
