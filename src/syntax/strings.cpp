// String expressions and the functions of strings that are numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/utf8.h"
#include "syntax/expression.h"
#include "syntax/word_groups.h"

namespace rt {

namespace {

/// Widths and precisions beyond this are a mistake, not a wish for a gigabyte of blanks.
constexpr double max_field = 1000.0;

std::string utf8(std::uint32_t code) {
    const auto byte = [](std::uint32_t b) { return static_cast<char>(b); };
    if (code < 0x80) return {byte(code)};
    if (code < 0x800) return {byte(0xC0 | (code >> 6)), byte(0x80 | (code & 0x3F))};
    return {byte(0xE0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3F)), byte(0x80 | (code & 0x3F))};
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

char escape(char c) {
    constexpr std::string_view names = "abfnrtv\\'\"";
    constexpr std::string_view values = "\a\b\f\n\r\t\v\\'\"";
    const std::size_t found = names.find(c);
    return found == std::string_view::npos ? '\0' : values[found];
}

/// Of the first bytes that differ, as the C library's comparison has it.
double difference(const std::string& a, const std::string& b) {
    const auto at = [](const std::string& s, std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0; };
    std::size_t i = 0;
    while (i < a.size() && at(a, i) == at(b, i)) ++i;
    return at(a, i) - at(b, i);
}

/// Bytes of the first character; a byte that begins none is one.
std::size_t character_bytes(std::string_view s) { return std::max<std::size_t>(utf8_character(s), 1); }

std::size_t bytes_of_characters(std::string_view s, std::size_t count) {
    std::size_t bytes = 0;
    for (; count > 0 && bytes < s.size(); --count) bytes += character_bytes(s.substr(bytes));
    return bytes;
}

std::size_t character_count(std::string_view s) {
    std::size_t count = 0;
    for (; !s.empty(); ++count) s.remove_prefix(character_bytes(s));
    return count;
}

/// Its number in Unicode.
std::uint32_t first_character(std::string_view s) {
    const std::size_t size = character_bytes(s);
    return size > 1 ? utf8_code_point(s, size) : static_cast<unsigned char>(s[0]);
}

}  // namespace

std::string unescaped(Reader& reader, const Token& token) {
    std::string result;
    const std::string_view raw = token.text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] != '\\') {
            result += raw[i];
        } else if (raw[++i] == 'u') {
            std::uint32_t code = 0;
            for (int digits = 0; digits < 4 && i + 1 < raw.size() && hex_digit(raw[i + 1]) >= 0; ++digits)
                code = code * 16 + hex_digit(raw[++i]);
            result += utf8(code);
        } else if (const char c = escape(raw[i])) {
            result += c;
        } else {
            const auto at = static_cast<std::uint32_t>(token.span.begin + i);
            const bool broken = raw[i] == '\n' || raw[i] == '\r';
            reader.fail({token.span.file, at, at + 2}, broken ? "Unterminated string literal." : "Illegal escape sequence in string.");
        }
    }
    return result;
}

bool at_string(Reader& reader) {
    const Token& token = reader.peek();
    if (token.kind == Token::Kind::string) return true;
    if (token.kind == Token::Kind::word) return group_of(token.word) == WordGroup::string_function;
    if (token.kind != Token::Kind::identifier) return false;
    const Value* const value = reader.next_value();
    return value && std::holds_alternative<std::string>(*value);
}

std::string Expression::string() {
    const Token token = reader_.peek();
    if (!at_string(reader_)) reader_.fail_expected("string expression");
    if (const std::string* declared = reader_.accept_declared<std::string>()) return *declared;
    reader_.take();
    if (token.kind == Token::Kind::string) return unescaped(reader_, token);
    const NestingGuard guard(state_, token.span);
    if (token.is(Word::datetime)) reader_.unmodelled(token.span, text(token.word));
    reader_.expect('(');
    std::string result = string_function(token.word, token.span);
    reader_.expect(')');
    return result;
}

std::string Expression::string_function(Word w, const Span& place) {
    switch (w) {
        case Word::chr: {
            const double code = std::trunc(sum_float());
            if (!(code >= 0.0 && code <= 0xFFFF))
                reader_.fail(state_.since(place), fmt::format("Value {} cannot be used in chr(...).", code));
            return code == 0.0 ? std::string() : utf8(static_cast<std::uint32_t>(code));
        }
        case Word::concat:
            return concatenation(place);
        case Word::str: {
            const double x = sum_float();
            return formatted_float(x, place);
        }
        case Word::vstr:
            return formatted_vector(place);
        case Word::substr:
            return substring(place);
        case Word::strlwr:
        case Word::strupr: {
            std::string s = string();
            const char first = w == Word::strlwr ? 'A' : 'a';
            for (char& c : s)
                if (c >= first && c <= first + 25) c = static_cast<char>(c ^ 0x20);
            return s;
        }
        default:
            next_float();
            return {};
    }
}

std::string Expression::concatenation(const Span& place) {
    std::string result = string();
    for (;;) {
        if (!reader_.accept(',') && !at_string(reader_)) return result;
        result += string();
        const std::size_t most = reader_.options().max_string_bytes;
        if (result.size() > most) reader_.fail_limit(state_.since(place), fmt::format("A string is longer than {} bytes.", most), "string");
    }
}

/// Width and precision, read here, as of printf; a negative width pads with zeros, a negative precision stands for 6.
Expression::Field Expression::field(const Span& place) {
    const double width = next_float();
    const double precision = next_float();
    if (!(std::fabs(width) <= max_field && precision <= max_field)) reader_.fail(state_.since(place), "Illegal parameters in str.");
    return {static_cast<int>(width), precision < 0.0 ? 6 : static_cast<int>(precision)};
}

std::string Expression::formatted_float(double x, const Span& place) {
    const Field f = field(place);
    return f.width < 0 ? fmt::format("{:0{}.{}f}", x, -f.width, f.precision) : fmt::format("{:{}.{}f}", x, f.width, f.precision);
}

/// vstr(count, vector, separator, width, precision): from two to five components.
std::string Expression::formatted_vector(const Span& place) {
    const double count = std::fmin(std::fmax(sum_float(), 2.0), 5.0);
    reader_.accept_comma();
    const Number n = sum();
    reader_.accept_comma();
    const std::string separator = string();
    const Field f = field(place);
    std::string result;
    for (int i = 0; i < static_cast<int>(count); ++i) {
        if (i > 0) result += separator;
        result +=
            f.width < 0 ? fmt::format("{:0{}.{}f}", n.v[i], -f.width, f.precision) : fmt::format("{:{}.{}f}", n.v[i], f.width, f.precision);
    }
    return result;
}

/// substr(string, position from 1, length).
std::string Expression::substring(const Span& place) {
    const std::string s = string();
    const double from = std::trunc(next_float());
    const double count = std::trunc(next_float());
    if (!(from >= 1.0 && count >= 0.0 && from - 1.0 + count <= static_cast<double>(character_count(s))))
        reader_.fail(state_.since(place), "Illegal parameters in substr.");
    const std::size_t begin = bytes_of_characters(s, static_cast<std::size_t>(from) - 1);
    return s.substr(begin, bytes_of_characters(std::string_view(s).substr(begin), static_cast<std::size_t>(count)));
}

std::optional<double> Expression::function_of_strings(Word w) {
    switch (w) {
        case Word::asc: {
            const std::string s = string();
            return s.empty() ? 0.0 : first_character(s);
        }
        case Word::strlen:
            return static_cast<double>(character_count(string()));
        case Word::val:
            return std::strtod(string().c_str(), nullptr);
        case Word::strcmp: {
            const std::string a = string();
            reader_.accept_comma();
            return difference(a, string());
        }
        case Word::file_exists:
            return state_.has_file(string()) ? 1.0 : 0.0;
        default:
            return std::nullopt;
    }
}

}  // namespace rt
