// Words of the command line to numbers and switches, each refusal in full words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace rt {

/// A whole number in [least, most]. Throws OptionError naming `what`.
int whole_number(std::string_view what, std::string_view text, int least, int most);
/// A finite number in [least, most], or a quotient of two ("1/255").
double real_number(std::string_view what, std::string_view text, double least, double most);
/// One such number for all channels, or three separated by commas.
Rgb one_or_three(std::string_view what, std::string_view text, double least, double most);
/// on, true, yes, 1, y, t or off, false, no, 0, n, f; case ignored. An empty text means on.
bool on_or_off(std::string_view what, std::string_view text);
std::vector<std::string> split(std::string_view text, char separator);
/// What a message shows of a text that may hold anything, the name of a file for instance: one line (see `one_line`), cut with "..."
/// behind `most` bytes, which is as long as a path can be.
std::string printable(std::string_view text, std::size_t most = 4096);
/// Without the three bytes by which some editors mark a file as UTF-8.
std::string_view without_byte_order_mark(std::string_view text);
std::string lower_case(std::string_view text);
/// Without blanks around it.
std::string_view trimmed(std::string_view text);
/// Without blanks around it and without one pair of quotes around that.
std::string_view unquoted(std::string_view text);

}  // namespace rt
