// Files that a scene opens with `#fopen`.
#pragma once

#include <optional>
#include <string>

#include "syntax/lexer.h"

namespace rt {

/// Reading goes on where the lexer stands. What is written stays in memory, where `#fopen ... read` and `#include` find it.
struct OpenFile {
    std::string name;            ///< as the scene states it
    std::optional<Lexer> lexer;  ///< of a file that is read
    std::string path;            ///< of one that is written
};

}  // namespace rt
