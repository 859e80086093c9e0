// Bytes to files.
#pragma once

#include <string>

namespace rt {

/// Writes a file at once and in place, without waiting for the disk. Throws OutputError with path and reason. What a user asked for goes
/// through OutputFile instead, which appears whole or not at all.
void write_bytes(const std::string& path, const std::string& bytes);

/// Makes a folder and those around it, where they are missing. Throws OutputError.
void make_folder(const std::string& path);

/// Writes a text that a user asked for: it appears whole or not at all. Throws OutputError.
void write_report(const std::string& path, const std::string& text);

}  // namespace rt
