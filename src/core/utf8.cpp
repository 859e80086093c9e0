#include "core/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace rt {

namespace {

using Byte = unsigned char;

bool continues(char c) { return (static_cast<Byte>(c) & 0xC0) == 0x80; }

/// Bytes of a character that begins with `first`; 0 if none does.
std::size_t announced(char first) {
    const auto byte = static_cast<Byte>(first);
    if (byte < 0x80) return 1;
    if (byte < 0xC2 || byte > 0xF4) return 0;
    return byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// General categories Cc, Zl and Zp, and the property Bidi_Control.
bool disturbs_a_line(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::uint32_t utf8_code_point(std::string_view text, std::size_t size) {
    constexpr std::uint32_t of_first[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    std::uint32_t code = static_cast<Byte>(text[0]) & of_first[size];
    for (std::size_t i = 1; i < size; ++i) code = code << 6 | (static_cast<Byte>(text[i]) & 0x3F);
    return code;
}

std::size_t utf8_character(std::string_view text) {
    const std::size_t size = text.empty() ? 0 : announced(text[0]);
    if (size == 0 || size > text.size()) return 0;
    if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size), continues)) return 0;
    const auto first = static_cast<Byte>(text[0]), second = static_cast<Byte>(size > 1 ? text[1] : '\0');
    const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool no_character = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);  // surrogates, beyond U+10FFFF
    return overlong || no_character ? 0 : size;
}

std::string_view whole_characters(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    for (std::size_t back = 0; back < std::min<std::size_t>(most, 4); ++back) {
        const std::size_t begin = most - back;
        if (continues(text[begin])) continue;
        return text.substr(0, announced(text[begin]) > back ? begin : most);
    }
    return text.substr(0, most);
}

std::string shortened(std::string_view text, std::size_t most) {
    const std::string_view shown = whole_characters(text, most);
    return shown.size() == text.size() ? std::string(text) : fmt::format("{}… ({} bytes more)", shown, text.size() - shown.size());
}

bool is_utf8(std::string_view text) {
    while (const std::size_t size = utf8_character(text)) text.remove_prefix(size);
    return text.empty();
}

std::string valid_utf8(std::string_view text) {
    std::string valid;
    while (!text.empty()) {
        const std::size_t size = utf8_character(text);
        valid += size ? text.substr(0, size) : "\xEF\xBF\xBD";
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return valid;
}

std::string one_line(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const std::size_t size = utf8_character(text);
        line += size == 0 || disturbs_a_line(utf8_code_point(text, size)) ? "?" : text.substr(0, size);
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return line;
}

}  // namespace rt
