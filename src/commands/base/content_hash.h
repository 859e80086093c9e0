// Fingerprints of what a result depends on.
#pragma once

#include <string>
#include <string_view>

namespace rt {

/// 32 hexadecimal digits (XXH3, 128 bits): equal for equal bytes. No protection against whoever looks for two that agree.
std::string hash_of(std::string_view bytes);
/// Of a file's bytes; "-" if it cannot be read.
std::string hash_of_file(const std::string& path);
/// Of every regular file below a folder, with their names and whether they are executable; links count by what they say.
std::string hash_of_folder(const std::string& path);

}  // namespace rt
