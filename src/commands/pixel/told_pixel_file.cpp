#include "commands/pixel/told_pixel_file.h"

#include <fmt/format.h>

#include "syntax/file_text.h"

namespace rt {

ToldPixel read_told_pixel(const std::string& path) {
    constexpr std::size_t most_bytes = 1u << 30;
    std::optional<std::string> text = read_file_text(path, most_bytes);
    if (!text) throw OptionError(fmt::format("cannot read '{}'", path));
    Sources sources;
    sources.add({path, std::move(*text)});
    const std::string& content = sources.file(0).text;
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    return first != content.npos && content[first] == '{' ? told_pixel_of_json(sources) : told_pixel_of_text(sources);
}

}  // namespace rt
