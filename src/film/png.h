// PNG through libpng.
#pragma once

#include "film/image_file.h"
#include "film/output_file.h"

namespace rt {

/// 8 or 16 bits, RGB or RGBA, with gAMA and sRGB chunks for the encoding and the metadata as text.
/// Throws OutputError.
void write_png(const Film& film, OutputFile& file, const Encoding& encoding, const ImageMetadata& metadata);

/// The bytes that write_png() writes. Throws OutputError.
std::string png_of(const Film& film, const Encoding& encoding, const ImageMetadata& metadata);

/// The picture as a PNG file of 8 bits a channel (largest value 255 or less) or 16. Numbers are as they are stored where the largest is 255
/// or 65535, else scaled to 255 or 65535 and rounded; floating-point ones are clamped to 0..1 and take 16 bits. Throws OutputError.
std::string png_of(const StoredImage& image);

/// Any PNG. Palettes come out as RGB or RGBA, 1-, 2- and 4-bit grey as 8-bit grey, a transparent colour as an alpha channel.
/// Throws OptionError that names `path`.
StoredImage read_png(std::FILE* file, const std::string& path, std::size_t max_pixels);

}  // namespace rt
