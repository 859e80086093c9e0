// Characters to tokens, one at a time, from any place of a file.
#pragma once

#include <functional>
#include <span>

#include "core/source.h"
#include "syntax/token.h"

namespace rt {

/// Scans a piece of a file. Copies are positions: to replay a loop or a macro, keep one or call `seek`.
/// A comment is skipped; a directive begins with the symbol '#', whose word is the next token.
class Lexer {
public:
    /// Scans bytes [begin, end) of `file`; `end` beyond the text means the whole of it. A byte order mark at the file's start is skipped.
    /// `near_choice` hears of the places where a comment is almost a directive, each time one is passed; it outlives the lexer.
    using NearChoice = std::function<void(const Span&)>;
    Lexer(const Sources& sources, std::uint32_t file, std::uint32_t begin = 0, std::uint32_t end = Span::none,
          const NearChoice* near_choice = nullptr);

    /// The next token; Kind::end at the end, as often as it is asked. Throws SceneError for bytes, comments, strings and
    /// numbers that are no token.
    void next(Token& token);

    /// Fast path of number-heavy files: reads one number or one `<a, b, c>` of at most `v.size()` plain literals if exactly that comes next
    /// and nothing after it could continue the expression ('<' does so in a condition only). The number of components; 0: nothing was read.
    std::size_t scan_plain_value(std::span<double> v, bool condition);

    /// Whether nothing that comes next could continue an expression that ended here.
    bool at_expression_end(bool condition) const;
    /// Takes a comma if only blanks are before it.
    bool scan_comma();

    std::uint32_t position() const { return static_cast<std::uint32_t>(at_ - text_); }
    void seek(std::uint32_t position) { at_ = text_ + position; }
    std::uint32_t file() const { return file_; }

private:
    bool skip_blanks(Token& token);
    bool scan_line_comment(Token& token);
    void skip_block_comment();
    void scan_number(Token& token);
    void scan_string(Token& token);
    void scan_name(Token& token);
    void scan_symbol(Token& token);
    [[noreturn]] void fail(const char* begin, const char* end, std::string_view text) const;
    Span span(const char* begin, const char* end) const {
        return {file_, static_cast<std::uint32_t>(begin - text_), static_cast<std::uint32_t>(end - text_)};
    }

    const Sources* sources_;
    const NearChoice* near_choice_;
    std::uint32_t file_;
    const char* text_;
    const char* at_;
    const char* end_;
};

}  // namespace rt
