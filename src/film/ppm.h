// Portable pixmaps, which need no library; the binary one streams to standard output.
#pragma once

#include "film/image_file.h"
#include "film/output_file.h"

namespace rt {

/// P6 of 8 or 16 bits, without alpha. Throws OutputError.
void write_ppm(const Film& film, OutputFile& file, const Encoding& encoding);

/// Grey and colour pixmaps, plain or binary (P2, P3, P5, P6), with any largest value up to 65535.
/// Throws OptionError that names `path`.
StoredImage read_pnm(std::FILE* file, const std::string& path, std::size_t max_pixels);

}  // namespace rt
