// The program as a process: its version, and the one way to its standard streams.
#pragma once

#include <string_view>

namespace rt {

/// The version of the program, e.g. "0.1.0".
std::string_view program_version();
/// Writes all of `text` to standard output; throws OutputError if it is closed or full.
void write_stdout(std::string_view text);
/// Messages: a standard error that is closed or full loses them, and nothing else.
void write_stderr(std::string_view text) noexcept;
/// Gives closed standard streams to /dev/null, so that no file that is opened later takes their place.
void open_standard_streams() noexcept;

}  // namespace rt
