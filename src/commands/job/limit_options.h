// --limit NAME=N: the limits of what a scene file may ask for.
#pragma once

#include <string>
#include <string_view>

#include "syntax/parser.h"

namespace rt {

/// Sets what "NAME=N" says: a whole number, with k, M or G behind it times a thousand, of bytes times 1024, once, twice or three times.
/// Throws OptionError for a name that is none, what is no such number and what is too small or too large.
void set_limit(ParseOptions& parse, std::string_view text);

/// The topic of `raytrace help limits`: every name with its value on this machine.
const std::string& limits_topic();

}  // namespace rt
