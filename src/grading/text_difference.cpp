#include "grading/text_difference.h"

#include <algorithm>

#include "grading/text_fields.h"

namespace rt {

namespace {

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
    const TextLines a = lines_of(expected), b = lines_of(actual);
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
