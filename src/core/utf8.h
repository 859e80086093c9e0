// Texts that may hold any bytes: names of files, what programs print.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rt {

/// Bytes of the character that `text` begins with, 1 to 4 (The Unicode Standard, table 3-7); 0 if it begins with none.
std::size_t utf8_character(std::string_view text);

/// The number of the character of `size` bytes, as utf8_character has it, that `text` begins with.
std::uint32_t utf8_code_point(std::string_view text, std::size_t size);

/// The first bytes of `text`, at most `most` of them, and none of a character whose others are beyond.
std::string_view whole_characters(std::string_view text, std::size_t most);

/// `text`, or its first `most` bytes at most and how many there are more: "abc… (2 bytes more)".
std::string shortened(std::string_view text, std::size_t most);

bool is_utf8(std::string_view text);

/// `text` with U+FFFD in the place of every byte that belongs to no character.
std::string valid_utf8(std::string_view text);

/// `text` as a message or a terminal may hold it, within a line: '?' in the place of bytes that belong to no character, of control
/// characters, of line and paragraph separators and of what turns the direction of writing.
std::string one_line(std::string_view text);

}  // namespace rt
