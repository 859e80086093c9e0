// What the two programs print about a render, as values.
#pragma once

#include <string>
#include <string_view>

#include "commands/versus/versus_result.h"

namespace rt {

/// Times and counts from POV-Ray's statistics: build is its bounding, trace its photons, radiosity and tracing. What is not there stays.
void read_povray_statistics(std::string_view output, VersusRun& run);

/// What POV-Ray prints, without empty lines, and with those whole that it cuts at the width of a terminal, in the middle of words that are
/// too long for one.
std::string povray_lines(std::string_view output);

/// The last error of POV-Ray's in its povray_lines(), on one line: "File 'a.pov' line 3: Parse Error: ...".
/// Where there is none, the last line that says anything.
std::string povray_message(std::string_view output);

/// "POV-Ray 3.7.0.10.unofficial" from what --version prints; empty if that is no POV-Ray.
std::string povray_version(std::string_view output);

/// The same of ours, without the excerpt.
std::string our_message(std::string_view output);

/// Where a message says that a mistake in a scene is, as both programs do: "a.pov line 3", without the folder; empty if it does not.
std::string refused_place(std::string_view message);

/// Times and counts from our --stats.
void read_our_statistics(std::string_view output, VersusRun& run);

}  // namespace rt
