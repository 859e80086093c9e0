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

/// What has to be known about our own options.
struct OwnOptions {
    std::function<bool(const std::string&)> takes_value;  ///< does this one ("--width", "-W") take its value from the next word?
    std::vector<std::string> long_names;                  ///< every "--name"
    /// Carries out one option (its name and value in one word or two) for nobody; throws OptionError if there is a mistake in it.
    std::function<void(const std::vector<std::string>&)> try_out;
    std::vector<std::string> short_names = {};  ///< those that a render has not, e.g. "-j", which otherwise is POV-Ray's
};

/// Whether the INI file comes first that POV-Ray reads without being asked: the one that the variable POVINI names, else povray.ini in the
/// current folder. A note says so.
enum class Defaults { none, of_povray };

/// Turns +X and -X switches, Name=value settings and .ini files (with an optional [section]) into GNU options "--name=value". Other
/// words stay; so do those that belong to an option of ours before them, and everything behind `--`.
/// Throws OptionError for an unknown switch or key, with a suggestion, and for every mistake in an INI file, with its place.
/// A scene that an INI file names gives way to one that is named behind it.
Translation translate_povray_syntax(const std::vector<std::string>& words, const OwnOptions& own, Defaults defaults = Defaults::none);

}  // namespace rt
