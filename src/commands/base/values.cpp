#include "commands/base/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/source.h"
#include "core/utf8.h"

namespace rt {

namespace {

/// NaN for what is no number.
double plain_number(std::string_view digits) {
    double value = 0.0;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double real_number(std::string_view what, std::string_view text, double least, double most) {
    const std::size_t slash = text.find('/');
    double value = plain_number(text.substr(0, slash));
    if (slash != std::string_view::npos) value /= plain_number(text.substr(slash + 1));
    if (!std::isfinite(value)) throw OptionError(fmt::format("{}: '{}' is no number", what, text));
    if (value < least || value > most) {
        if (std::isfinite(most)) throw OptionError(fmt::format("{}: {} is outside {} to {}", what, text, least, most));
        throw OptionError(fmt::format("{}: {} is less than {}", what, text, least));
    }
    return value;
}

Rgb one_or_three(std::string_view what, std::string_view text, double least, double most) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != 1 && parts.size() != 3) throw OptionError(fmt::format("{}: expected one number or three, not '{}'", what, text));
    Rgb result;
    for (int i = 0; i < 3; ++i) result[i] = real_number(what, parts[parts.size() == 1 ? 0 : static_cast<std::size_t>(i)], least, most);
    return result;
}

int whole_number(std::string_view what, std::string_view text, int least, int most) {
    const double value = real_number(what, text, -HUGE_VAL, HUGE_VAL);
    if (value != std::trunc(value)) throw OptionError(fmt::format("{}: expected a whole number, not '{}'", what, text));
    if (value < least || value > most) throw OptionError(fmt::format("{}: {} is outside {} to {}", what, text, least, most));
    return static_cast<int>(value);
}

bool on_or_off(std::string_view what, std::string_view text) {
    const std::string word = lower_case(text);
    for (const char* on : {"", "on", "true", "yes", "1", "y", "t"})
        if (word == on) return true;
    for (const char* off : {"off", "false", "no", "0", "n", "f"})
        if (word == off) return false;
    throw OptionError(fmt::format("{}: '{}' is neither on nor off", what, text));
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.emplace_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

std::string printable(std::string_view text, std::size_t most) {
    const std::string shown = one_line(whole_characters(text, most));
    return text.size() > most ? shown + "..." : shown;
}

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string lower_case(std::string_view text) {
    std::string lowered(text);
    for (char& c : lowered) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lowered;
}

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view unquoted(std::string_view text) {
    text = trimmed(text);
    const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace rt
