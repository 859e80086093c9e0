// Files into memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace rt {

/// The whole of a regular file; empty if there is none. Throws LimitError if it is larger than `max_bytes`.
std::optional<std::string> read_file_text(const std::string& path, std::size_t max_bytes);

}  // namespace rt
