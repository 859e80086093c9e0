// Two texts by the rule of `diff -bB`, and the first field in which they part.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

struct TextDifference {
    std::size_t line = 0;   ///< of the actual text, from 1; one beyond its last where lines are missing
    std::size_t field = 0;  ///< blank-separated word of the line, from 1; 0: a whole line is missing or too many
    std::string expected_line, actual_line;
    std::string expected, actual;  ///< the two fields; empty where there is none
    std::optional<double> apart;   ///< if both are numbers
};

/// The lines that `diff -bB` compares: each run of white space as one blank, none at the end, and no line that is only white space.
std::vector<std::string> compared_lines(std::string_view text);

/// Two texts by the rule of `diff -bB`: lines that are not blank are compared in order. diff does so, too, unless it pairs blank lines
/// instead: of "X\n\n\n" and "\n\nX\n", the same here, it tells X. With a tolerance numbers may differ by so much (relative above 1,
/// absolute below), and blanks at a line's start do not matter. The first place where they part; empty if there is none.
std::optional<TextDifference> first_difference(std::string_view expected, std::string_view actual, double tolerance);

}  // namespace rt
