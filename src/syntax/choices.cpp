#include "syntax/choices.h"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

constexpr std::string_view blanks = " \t\r\n";

SceneOption parse_choice(Reader& reader, std::string_view word, const Span& place) {
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == word.size())
        reader.fail(place, fmt::format("Expected 'key=value' after '//! raytrace:', '{}' found instead", word));
    const std::string_view key = word.substr(0, equals);
    if (std::find(choice_keys.begin(), choice_keys.end(), key) == choice_keys.end())
        reader.fail(place, fmt::format("Unknown key '{}' after '//! raytrace:', known are {}", key, fmt::join(choice_keys, ", ")));
    return {std::string(key), std::string(word.substr(equals + 1)), place};
}

}  // namespace

bool accept_choices(Reader& reader, std::vector<SceneOption>& options) {
    if (reader.peek().kind != Token::Kind::choice) return false;
    const Token comment = reader.take();
    const char* const file = reader.scene().sources.file(comment.span.file).text.data();
    const auto offset = static_cast<std::uint32_t>(comment.text.data() - file);
    const std::string_view text = comment.text;
    std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) reader.fail(comment.span, "Expected 'key=value' after '//! raytrace:', nothing found instead");
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
        const Span place{comment.span.file, offset + static_cast<std::uint32_t>(begin), offset + static_cast<std::uint32_t>(end)};
        options.push_back(parse_choice(reader, text.substr(begin, end - begin), place));
        begin = text.find_first_not_of(blanks, end);
    }
    return true;
}

}  // namespace rt
