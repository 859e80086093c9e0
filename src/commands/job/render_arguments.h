// Command line -> RenderJob, in any of the three ways to write one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/job/render_job.h"

namespace rt {

/// The job that `words` ask for, or nothing where they ask for help (`help` then has the text). Order does not matter; of two values for
/// one option the last wins. Throws OptionError.
std::optional<RenderJob> parse_render_arguments(const std::vector<std::string>& words, std::string& help);

/// The same where one picture is asked for: frames of an animation are refused.
std::optional<RenderJob> parse_picture_arguments(const std::vector<std::string>& words, std::string& help);

/// Is `word` an option of a render whose value is the next word?
bool render_option_takes_value(const std::string& word);
/// Every "--name" that a render understands.
std::vector<std::string> render_long_names();
/// A switch of POV-Ray's in our long options. Throws OptionError if there is no such switch.
std::string in_long_options(const std::string& povray_switch);

struct RequiresArguments {
    std::vector<std::string> scenes;  ///< and folders
    ParseOptions parse;
    double seconds = 60.0;  ///< that reading one scene may take
    bool json = false;
};

/// The same for `raytrace requires`: everything that a render understands, and any number of scenes and folders.
std::optional<RequiresArguments> parse_requires_arguments(const std::vector<std::string>& words, std::string& help);

}  // namespace rt
