// Words as a shell reads them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The word as it is typed: plain where it can be, else in quotes; bytes that are no UTF-8 and control characters in bash's $'\ooo'.
std::string shell_word(std::string_view word);
/// A command, its words separated by blanks.
std::string shell_words(const std::vector<std::string>& words);

}  // namespace rt
