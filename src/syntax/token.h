// One token of the scene language, with its place.
#pragma once

#include <string_view>

#include "core/source.h"
#include "syntax/words.h"

namespace rt {

struct Token {
    enum class Kind : std::uint8_t {
        end,         ///< end of the whole input
        number,      ///< `number`
        string,      ///< `text` is the raw characters between the quotes, escapes not yet resolved
        identifier,  ///< not a reserved word; `text`
        word,        ///< reserved word; `word`
        symbol,      ///< one of { } ( ) < > [ ] , ; + - * / = ! & | ? : . or != <= >= ; `symbol`
        choice,      ///< a directive comment `//! raytrace: ...`; `text` is what follows the colon
    };
    Kind kind = Kind::end;
    Word word = Word::none;  ///< none unless `kind` says that it is one
    char symbol = 0;         ///< likewise 0; else the character, where 'N' is !=, 'L' is <=, 'G' is >=
    double number = 0.0;
    std::string_view text;  ///< into the source, which outlives every token
    Span span;

    bool is(Word w) const { return word == w; }
    bool is(char s) const { return symbol == s; }
};

}  // namespace rt
