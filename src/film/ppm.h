// Binary PPM (P6), which needs no library and streams to standard output.
#pragma once

#include "film/encode.h"
#include "film/output_file.h"

namespace rt {

/// 8 or 16 bits, without alpha. Throws OutputError.
void write_ppm(const Film& film, OutputFile& file, const Encoding& encoding);

}  // namespace rt
