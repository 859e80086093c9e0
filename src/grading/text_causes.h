// What kind of mistake a wrong text looks like.
#pragma once

#include <string>
#include <string_view>

namespace rt {

struct TextCause {
    std::string cause;     ///< "rounding", "sign", "missing lines", "lines too many", "another order", "another format", "other numbers",
                           ///< "other words"
    std::string evidence;  ///< a sentence with numbers
};

/// For texts that differ by `first_difference`. Numbers are told from what is between them; a number differs by rounding if it is at most
/// two units of its last printed place away.
TextCause text_cause(std::string_view expected, std::string_view actual);

}  // namespace rt
