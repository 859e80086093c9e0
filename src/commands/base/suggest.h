// "Did you mean ...?": the known word nearest to one that was mistyped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The candidate with the fewest insertions, deletions, replacements and exchanges of neighbours (Damerau's distance, case ignored) to
/// `word` if that is within a third of the word's length (at least one change is always allowed); else the shortest that begins with the
/// word; else "".
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "" or "; did you mean 'X'?".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace rt
