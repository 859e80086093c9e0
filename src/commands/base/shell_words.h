// Words as a shell reads them.
#pragma once

#include <string>
#include <string_view>

namespace rt {

/// The word as it is typed: plain where it can be, else in quotes; bytes that are no UTF-8 and control characters in bash's $'\ooo'.
std::string shell_word(std::string_view word);

}  // namespace rt
