#include "grading/text_difference.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rt {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Lines to compare, each with its number in the text.
struct Lines {
    std::vector<std::string> texts;
    std::vector<std::size_t> numbers;
    std::size_t last = 0;  ///< number of the text's last line
};

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

Lines lines_of(std::string_view text) {
    Lines lines;
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

/// The number in a field that may have punctuation around it, as in "{1.0000" or "(255,", and what is around it.
struct Number {
    double value;
    std::string_view before, after;
};
std::optional<Number> number_of(std::string_view field) {
    const std::size_t begin = field.find_first_of("+-.0123456789");
    if (begin == std::string_view::npos) return std::nullopt;
    const char* first = field.data() + begin + (field[begin] == '+' ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(first, field.data() + field.size(), value);
    if (error != std::errc() || end == first) return std::nullopt;
    return Number{value, field.substr(0, begin), field.substr(static_cast<std::size_t>(end - field.data()))};
}

std::optional<double> distance(std::string_view a, std::string_view b) {
    const std::optional<Number> x = number_of(a), y = number_of(b);
    if (!x || !y || x->before != y->before || x->after != y->after) return std::nullopt;
    return std::fabs(x->value - y->value);
}

bool same_field(std::string_view a, std::string_view b, double tolerance) {
    if (a == b) return true;
    if (!(tolerance > 0.0)) return false;
    const std::optional<double> apart = distance(a, b);
    return apart && *apart <= tolerance * std::max(1.0, std::fabs(number_of(a)->value));
}

/// The first field that differs, from 1; 0 if none does.
std::size_t differing_field(std::string_view expected, std::string_view actual, double tolerance) {
    const std::vector<std::string_view> a = fields_of(expected), b = fields_of(actual);
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
        if (i >= a.size() || i >= b.size() || !same_field(a[i], b[i], tolerance)) return i + 1;
    return 0;
}

std::string field(std::string_view line, std::size_t number) {
    const std::vector<std::string_view> fields = fields_of(line);
    return number >= 1 && number <= fields.size() ? std::string(fields[number - 1]) : std::string();
}

}  // namespace

std::vector<std::string> compared_lines(std::string_view text) { return lines_of(text).texts; }

std::optional<TextDifference> first_difference(std::string_view expected, std::string_view actual, double tolerance) {
    const Lines a = lines_of(expected), b = lines_of(actual);
    for (std::size_t i = 0; i < std::max(a.texts.size(), b.texts.size()); ++i) {
        TextDifference found;
        found.line = i < b.numbers.size() ? b.numbers[i] : b.last + 1;
        if (i < a.texts.size()) found.expected_line = a.texts[i];
        if (i < b.texts.size()) found.actual_line = b.texts[i];
        if (i >= a.texts.size() || i >= b.texts.size()) return found;
        if (found.expected_line == found.actual_line) continue;
        found.field = differing_field(found.expected_line, found.actual_line, tolerance);
        if (found.field == 0 && tolerance > 0.0) continue;
        if (found.field == 0) found.field = 1;  // one of the lines is indented
        found.expected = field(found.expected_line, found.field);
        found.actual = field(found.actual_line, found.field);
        found.apart = distance(found.expected, found.actual);
        return found;
    }
    return std::nullopt;
}

}  // namespace rt
