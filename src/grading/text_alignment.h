// Two texts side by side: which line of one stands for which of the other.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A line of both texts, or of one alone.
struct AlignedLine {
    std::size_t expected_number = 0, actual_number = 0;  ///< in their texts, from 1; 0: there is no such line
    std::string expected, actual;                        ///< as compared_lines() has them
    std::vector<std::size_t> differing;                  ///< of a pair: its fields that are not the same, from 1
};

/// The lines that `diff -bB` compares, paired so that as much as possible is the same: a line without a partner costs 1, a pair twice the
/// share of its fields that differ (Needleman and Wunsch 1970). `tolerance` as for first_difference(). What is the same at both ends is
/// paired first; where the rest is too long for that (more than 300 lines by 300), its lines are paired by their order.
std::vector<AlignedLine> aligned_lines(std::string_view expected, std::string_view actual, double tolerance);

}  // namespace rt
