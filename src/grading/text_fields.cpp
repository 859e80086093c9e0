#include "grading/text_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rt {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string squeezed(std::string_view line) {
    std::string text;
    for (const char c : line) {
        if (!is_space(c))
            text += c;
        else if (text.empty() || text.back() != ' ')
            text += ' ';
    }
    if (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

/// The number in a field that may have punctuation around it, as in "{1.0000" or "(255,", and what is around it.
struct WrittenNumber {
    double value;
    std::string_view before, after;
};
std::optional<WrittenNumber> number_of(std::string_view field) {
    const std::size_t begin = field.find_first_of("+-.0123456789");
    if (begin == std::string_view::npos) return std::nullopt;
    const char* first = field.data() + begin + (field[begin] == '+' ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(first, field.data() + field.size(), value);
    if (error != std::errc() || end == first) return std::nullopt;
    return WrittenNumber{value, field.substr(0, begin), field.substr(static_cast<std::size_t>(end - field.data()))};
}

}  // namespace

TextLines lines_of(std::string_view text) {
    TextLines lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        ++lines.last;
        if (std::string line = squeezed(text.substr(begin, end - begin)); !line.empty()) {
            lines.texts.push_back(std::move(line));
            lines.numbers.push_back(lines.last);
        }
        begin = end + 1;
    }
    return lines;
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t begin = line.starts_with(' ') ? 1 : 0; begin < line.size();) {
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        fields.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return fields;
}

std::optional<double> distance(std::string_view a, std::string_view b) {
    const std::optional<WrittenNumber> x = number_of(a), y = number_of(b);
    if (!x || !y || x->before != y->before || x->after != y->after) return std::nullopt;
    return std::fabs(x->value - y->value);
}

bool same_field(std::string_view a, std::string_view b, double tolerance) {
    if (a == b) return true;
    if (!(tolerance > 0.0)) return false;
    const std::optional<double> apart = distance(a, b);
    return apart && *apart <= tolerance * std::max(1.0, std::fabs(number_of(a)->value));
}

}  // namespace rt
