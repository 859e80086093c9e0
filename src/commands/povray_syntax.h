// POV-Ray's way to write a command line, turned into ours.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rt {

struct Translation {
    std::vector<std::string> words;    ///< GNU options and other words, in the order given
    std::vector<std::string> notes;    ///< what was changed on the way
    std::vector<std::string> ignored;  ///< switches and keys without a meaning here, as written
};

/// Turns +X and -X switches, Name=value settings and .ini files (with an optional [section]) into GNU options "--name=value". Other
/// words stay; so do those that `takes_value` says belong to the option before them, and everything behind `--`.
/// Throws OptionError for an unknown switch or key, with a suggestion.
Translation translate_povray_syntax(const std::vector<std::string>& words, const std::function<bool(const std::string&)>& takes_value);

}  // namespace rt
