#include "syntax/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string>

#include "syntax/choice_prefix.h"

namespace rt {

namespace {

enum CharClass : std::uint8_t { illegal, blank, other, digit, letter };  // names are made of the last two

constexpr std::array<CharClass, 256> make_classes() {
    std::array<CharClass, 256> classes{};
    for (int c = 33; c < 127; ++c) classes[c] = other;
    for (int c = '0'; c <= '9'; ++c) classes[c] = digit;
    for (int c = 'a'; c <= 'z'; ++c) classes[c] = letter;
    for (int c = 'A'; c <= 'Z'; ++c) classes[c] = letter;
    classes['_'] = letter;
    for (const char c : {' ', '\t', '\n', '\r', '\v', '\f'}) classes[c] = blank;
    return classes;
}

constexpr auto classes = make_classes();

CharClass class_of(char c) { return classes[static_cast<unsigned char>(c)]; }

const char* skip_space(const char* at, const char* end) {
    while (at != end && class_of(*at) == blank) ++at;
    return at;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Above 9 for anything but a digit.
unsigned digit_value(char c) { return static_cast<unsigned char>(c) - unsigned{'0'}; }

bool is_digit(char c) { return class_of(c) == digit; }

/// Hands each of the digits at `at` to `take` and returns their end.
template <typename Take>
const char* take_digits(const char* at, const char* end, const Take& take) {
    for (unsigned d; at != end && (d = digit_value(*at)) <= 9; ++at) take(d);
    return at;
}

const char* skip_digits(const char* at, const char* end) {
    return take_digits(at, end, [](unsigned) {});
}

constexpr std::array powers_of_ten{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// Reads digits with at most one point if there are few enough: their whole number and the power of ten are exact doubles then, and so the
/// quotient is the nearest one to what is written (Clinger 1990, "How to Read Floating Point Numbers Accurately"). Returns their end; null
/// if there are too many or none, or an exponent follows.
const char* scan_short_decimal(const char* at, const char* end, double& value) {
    std::uint64_t number = 0;
    const auto append = [&](unsigned digit) { number = 10 * number + digit; };
    const char* const begin = at;
    at = take_digits(begin, end, append);
    std::size_t digits = at - begin;
    std::size_t decimals = 0;
    if (at != end && *at == '.') {
        const char* const point = at;
        at = take_digits(point + 1, end, append);
        decimals = at - point - 1;
        digits += decimals;
    }
    if (digits == 0 || digits >= powers_of_ten.size() || (at != end && (*at == 'e' || *at == 'E'))) return nullptr;
    value = static_cast<double>(static_cast<std::int64_t>(number)) / powers_of_ten[decimals];
    return at;
}

/// End of the literal that begins at `at`: digits with at most one point, then an exponent whose digits may be missing, as POV-Ray reads
/// it.
const char* literal_end(const char* at, const char* end) {
    at = skip_digits(at, end);
    if (at != end && *at == '.') at = skip_digits(at + 1, end);
    if (at != end && (*at == 'e' || *at == 'E')) {
        ++at;
        if (at != end && (*at == '+' || *at == '-')) ++at;
        at = skip_digits(at, end);
    }
    return at;
}

double literal_value(const char* begin, const char* end) {
    double value = 0.0;
    const auto result = std::from_chars(begin, end, value);
    if (result.ec == std::errc::result_out_of_range) return std::strtod(std::string(begin, end).c_str(), nullptr);
    return value;
}

// The fast path of `scan_plain_value`. Each returns the end of what it read, or null if that is not plain.

/// A sign and a literal; digits only, so that everything unusual takes the common way.
const char* scan_plain_literal(const char* at, const char* end, double& number) {
    const bool negative = at != end && *at == '-';
    if (negative) ++at;
    const char* after = scan_short_decimal(at, end, number);
    if (after == nullptr) {
        if (at == end || (!is_digit(*at) && *at != '.')) return nullptr;
        const auto result = std::from_chars(at, end, number);
        if (result.ec != std::errc{}) return nullptr;
        after = result.ptr;
    }
    if (negative) number = -number;
    return after != end && (class_of(*after) == letter || *after == '.') ? nullptr : after;
}

/// What follows '<': two components or more, at most as many as `v` holds, and '>'.
const char* scan_plain_vector(const char* at, const char* end, std::span<double> v, std::size_t& size) {
    for (size = 0; size < v.size();) {
        at = scan_plain_literal(skip_space(at, end), end, v[size++]);
        if (at == nullptr) return nullptr;
        at = skip_space(at, end);
        if (at == end) return nullptr;
        if (*at == '>') return size < 2 ? nullptr : at + 1;
        if (*at++ != ',') return nullptr;
    }
    return nullptr;
}

/// True if what follows `at` is neither an operator nor anything that has to be looked at more closely.
bool ends_expression(const char* at, const char* end, bool condition) {
    at = skip_space(at, end);
    if (at == end) return false;
    return class_of(*at) >= digit || *at == ',' || *at == '}' || *at == '{' || *at == ';' || (*at == '<' && !condition);
}

}  // namespace

Lexer::Lexer(const Sources& sources, std::uint32_t file, std::uint32_t begin, std::uint32_t end, const NearChoice* near_choice)
    : sources_(&sources), near_choice_(near_choice), file_(file), text_(sources.file(file).text.data()) {
    const std::string& text = sources.file(file).text;
    at_ = text_ + std::min<std::size_t>(begin, text.size());
    end_ = text_ + std::min<std::size_t>(end, text.size());
    if (begin == 0 && text.starts_with(byte_order_mark)) at_ = std::min(at_ + byte_order_mark.size(), end_);
}

void Lexer::next(Token& token) {
    token.word = Word::none;
    token.symbol = 0;
    if (skip_blanks(token)) return;
    if (at_ == end_) {
        token.kind = Token::Kind::end;
        token.span = span(at_, at_);
        return;
    }
    const char* const begin = at_;
    switch (class_of(*at_)) {
        case digit:
            scan_number(token);
            break;
        case letter:
            scan_name(token);
            break;
        case other:
            if (*at_ == '"')
                scan_string(token);
            else if (*at_ == '.' && at_ + 1 != end_ && is_digit(at_[1]))
                scan_number(token);
            else
                scan_symbol(token);
            break;
        default:
            fail(at_, at_ + 1, fmt::format("Illegal character in input file, value is {:02x}.", static_cast<unsigned char>(*at_)));
    }
    token.span = span(begin, at_);
}

/// Moves to the next byte of a token; true if a directive comment was met on the way and is now `token`.
bool Lexer::skip_blanks(Token& token) {
    for (;;) {
        at_ = skip_space(at_, end_);
        if (end_ - at_ < 2 || *at_ != '/') return false;
        if (at_[1] == '/') {
            if (scan_line_comment(token)) return true;
        } else if (at_[1] == '*') {
            skip_block_comment();
        } else {
            return false;
        }
    }
}

/// True if the comment is a directive, which is now `token`.
bool Lexer::scan_line_comment(Token& token) {
    const char* const begin = at_;
    at_ = std::find(at_, end_, '\n');
    if (at_[-1] == '\r') --at_;
    const std::string_view comment(begin, at_ - begin);
    if (!comment.starts_with(choice_prefix)) {
        const std::size_t length = near_choice_ ? near_choice_prefix(comment) : 0;
        if (length != 0) (*near_choice_)(span(begin, begin + length));
        return false;
    }
    token.kind = Token::Kind::choice;
    token.text = comment.substr(choice_prefix.size());
    token.span = span(begin, at_);
    return true;
}

void Lexer::skip_block_comment() {
    const char* const begin = at_;
    at_ += 2;
    for (std::size_t depth = 1; depth != 0;) {
        if (end_ - at_ < 2) fail(begin, begin + 2, "No */ closing comment found.");
        if (at_[0] == '*' && at_[1] == '/') {
            --depth;
            at_ += 2;
        } else if (at_[0] == '/' && at_[1] == '*') {
            ++depth;
            at_ += 2;
        } else {
            ++at_;
        }
    }
}

void Lexer::scan_number(Token& token) {
    const char* const begin = at_;
    at_ = scan_short_decimal(begin, end_, token.number);
    if (at_ == nullptr) {
        at_ = literal_end(begin, end_);
        token.number = literal_value(begin, at_);
    }
    if (at_ != end_ && *at_ == '.') fail(begin, at_ + 1, "Unexpected additional '.' in floating-point number");
    token.kind = Token::Kind::number;
}

void Lexer::scan_string(Token& token) {
    const char* const begin = at_++;
    while (at_ != end_ && *at_ != '"') at_ += *at_ == '\\' && at_ + 1 != end_ ? 2 : 1;
    if (at_ == end_) fail(begin, begin + 1, "No end quote for string.");
    token.kind = Token::Kind::string;
    token.text = std::string_view(begin + 1, at_ - begin - 1);
    ++at_;
}

void Lexer::scan_name(Token& token) {
    const char* const begin = at_;
    while (at_ != end_ && class_of(*at_) >= digit) ++at_;
    token.text = std::string_view(begin, at_ - begin);
    token.word = find_word(token.text);
    token.kind = token.word == Word::none ? Token::Kind::identifier : Token::Kind::word;
}

void Lexer::scan_symbol(Token& token) {
    token.kind = Token::Kind::symbol;
    token.symbol = *at_++;
    if (at_ == end_ || *at_ != '=') return;
    if (token.symbol == '!' || token.symbol == '<' || token.symbol == '>') {
        token.symbol = token.symbol == '!' ? 'N' : token.symbol == '<' ? 'L' : 'G';
        ++at_;
    }
}

std::size_t Lexer::scan_plain_value(std::span<double> v, bool condition) {
    const char* at = skip_space(at_, end_);
    std::size_t size = 1;
    if (at != end_ && *at == '<')
        at = scan_plain_vector(at + 1, end_, v, size);
    else
        at = scan_plain_literal(at, end_, v[0]);
    if (at == nullptr || !ends_expression(at, end_, condition)) return 0;
    at_ = at;
    return size;
}

bool Lexer::at_expression_end(bool condition) const { return ends_expression(at_, end_, condition); }

bool Lexer::scan_comma() {
    const char* const at = skip_space(at_, end_);
    if (at == end_ || *at != ',') return false;
    at_ = at + 1;
    return true;
}

void Lexer::fail(const char* begin, const char* end, std::string_view text) const {
    throw SceneError(sources_->describe(span(begin, end), "Parse Error", text));
}

}  // namespace rt
