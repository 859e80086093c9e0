#include "commands/base/shell_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/utf8.h"

namespace rt {

namespace {

bool is_plain(unsigned char c) {
    const bool letter_or_digit = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    return letter_or_digit || std::string_view("_-+=:,./%@").find(static_cast<char>(c)) != std::string_view::npos;
}

bool is_control(unsigned char c) { return c < 0x20 || c == 0x7f; }

}  // namespace

std::string shell_word(std::string_view word) {
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return std::string(word);
    std::string text;
    if (is_utf8(word) && std::none_of(word.begin(), word.end(), is_control)) {
        for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
        return "'" + text + "'";
    }
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (is_control(byte) || byte >= 0x80) {
            text += fmt::format("\\{:03o}", byte);  // at most three digits, whatever follows
        } else {
            if (c == '\'' || c == '\\') text += '\\';
            text += c;
        }
    }
    return "$'" + text + "'";
}

std::string shell_words(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += shell_word(word) + ' ';
    if (!words.empty()) text.pop_back();
    return text;
}

}  // namespace rt
