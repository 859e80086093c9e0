// Texts as they are compared: lines by the rule of `diff -bB`, their fields, and when two fields are the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Lines to compare, each with its number in the text: runs of white space are one blank, none is at a line's end, and lines that are only
/// white space are left out.
struct TextLines {
    std::vector<std::string> texts;
    std::vector<std::size_t> numbers;  ///< from 1
    std::size_t last = 0;              ///< number of the text's last line
};
TextLines lines_of(std::string_view text);

/// The blank-separated words of such a line; they refer to it.
std::vector<std::string_view> fields_of(std::string_view line);

/// How far two fields are apart if both are numbers with the same punctuation around them, as in "{1.0000" or "(255,".
std::optional<double> distance(std::string_view a, std::string_view b);

/// Whether they are the same, letter for letter or as numbers within `tolerance` (relative above 1, absolute below).
bool same_field(std::string_view expected, std::string_view actual, double tolerance);

}  // namespace rt
