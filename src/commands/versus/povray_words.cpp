#include "commands/versus/povray_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/source.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// POV-Ray 3.7 writes beyond its memory for a scene whose path has 206 bytes; 201 are well.
constexpr std::size_t longest = 150;

bool is_plain(char c) {
    const bool letter_or_digit = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    return letter_or_digit || std::string_view("/._-").find(c) != std::string_view::npos;
}

}  // namespace

bool povray_can_say(const std::string& path) {
    const bool printable = std::all_of(path.begin(), path.end(), [](char c) { return c >= ' ' && c <= '~'; });
    return printable && path.size() <= longest && (path.find('"') == path.npos || path.find('\'') == path.npos);
}

std::string PovrayNames::word(const std::string& path, const std::string& plain) {
    const bool sayable = povray_can_say(path);
    if (sayable && std::all_of(path.begin(), path.end(), is_plain)) return path;
    if (sayable) return path.find('"') == path.npos ? fmt::format("\"{}\"", path) : fmt::format("'{}'", path);
    const std::string link = (fs::path(folder_) / plain).string();
    links_.emplace_back(link, path);
    return word(link, plain);
}

void PovrayNames::make_links() const {
    for (const auto& [link, path] : links_) {
        std::error_code error;
        fs::create_symlink(path, link, error);
        if (error) throw OutputError(fmt::format("cannot make the link '{}': {}", link, error.message()));
    }
}

std::string PovrayNames::without_links(std::string text) const {
    for (const auto& [link, path] : links_)
        for (std::size_t at = 0; (at = text.find(link, at)) != text.npos; at += path.size()) text.replace(at, link.size(), path);
    return text;
}

}  // namespace rt
