// A cell of a table of comma-separated values.
#pragma once

#include <string>

namespace rt {

/// `text` as RFC 4180 has it, in UTF-8. Control characters but tabs and ends of lines are '?'; what a spreadsheet would take for a
/// formula gets an apostrophe.
std::string csv_field(std::string text);

}  // namespace rt
