// How a directive comment begins, and comments that only look like one.
#pragma once

#include <cstddef>
#include <string_view>

namespace rt {

/// Only this exact prefix makes a line comment a token.
inline constexpr std::string_view choice_prefix = "//! raytrace:";

/// `comment` (from its slashes to the end of its line) has not the prefix. The length of what stands in the prefix's place if the comment
/// was probably meant to be a directive: other blanks, other letters or a missing mark before something that looks like choices; else 0.
std::size_t near_choice_prefix(std::string_view comment);

}  // namespace rt
