// Groups of reserved words that expressions and messages tell apart.
#pragma once

#include "syntax/words.h"

namespace rt {

enum class WordGroup : std::uint8_t { plain, float_function, vector_function, color_keyword, string_function };

WordGroup group_of(Word w);

/// The name messages use: 'colour' and 'color' share one.
std::string_view message_name(Word w);

}  // namespace rt
