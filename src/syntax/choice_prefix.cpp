#include "syntax/choice_prefix.h"

#include <algorithm>

namespace rt {

namespace {

constexpr std::string_view line_blanks = " \t\r";

std::size_t skip(std::string_view text, std::size_t at, std::string_view skipped) {
    return std::min(text.find_first_not_of(skipped, at), text.size());
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// "raytrace" in any letters, with one more ("raytracer") or one less.
bool is_our_word(std::string_view word) {
    constexpr std::string_view stem = "raytrac";
    if (word.size() < stem.size() || word.size() > stem.size() + 2) return false;
    return std::equal(stem.begin(), stem.end(), word.begin(), [](char a, char b) { return a == lower(b); });
}

}  // namespace

std::size_t near_choice_prefix(std::string_view comment) {
    const std::size_t begin = skip(comment, 0, "/! \t");
    const bool marked = comment.substr(0, begin).find('!') != std::string_view::npos;
    std::size_t at = begin;
    while (at != comment.size() && is_letter(comment[at])) ++at;
    if (!is_our_word(comment.substr(begin, at - begin))) return 0;
    const std::size_t behind = skip(comment, at, line_blanks);
    const bool colon = behind != comment.size() && comment[behind] == ':';
    const std::size_t length = colon ? behind + 1 : at;
    const std::size_t first = skip(comment, length, line_blanks);
    const std::string_view piece = comment.substr(first, std::min(comment.find_first_of(line_blanks, first), comment.size()) - first);
    const bool states_something = piece.find('=') != std::string_view::npos;
    return (marked && colon) || ((marked || colon) && states_something) ? length : 0;
}

}  // namespace rt
