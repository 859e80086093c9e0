#include "commands/base/write_bytes.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/source.h"
#include "core/utf8.h"
#include "film/output_file.h"

namespace rt {

void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw OutputError(fmt::format("cannot write '{}': {}", one_line(path), std::strerror(errno)));
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw OutputError(fmt::format("cannot make the folder '{}': {}", one_line(path), error.message()));
}

void write_report(const std::string& path, const std::string& text) {
    OutputFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

}  // namespace rt
