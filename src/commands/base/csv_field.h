// A cell of a table of comma-separated values.
#pragma once

#include <string>

namespace rt {

/// `text` as RFC 4180 has it. What a spreadsheet would take for a formula gets an apostrophe.
std::string csv_field(std::string text);

}  // namespace rt
