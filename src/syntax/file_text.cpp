#include "syntax/file_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "core/source.h"
#include "syntax/limits.h"

namespace rt {

std::optional<std::string> read_file_text(const std::string& path, std::size_t max_bytes) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    const auto bytes = std::filesystem::file_size(path, error);
    std::ifstream in(path, std::ios::binary);
    if (error || !in) return std::nullopt;
    if (bytes > max_bytes) throw LimitError(fmt::format("File '{}' is larger than {} bytes.{}", path, max_bytes, allow_more("file")));
    std::string text(static_cast<std::size_t>(bytes), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return text;
}

}  // namespace rt
