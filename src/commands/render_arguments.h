// Command line -> RenderJob, in any of the three ways to write one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/render_job.h"

namespace rt {

/// The job that `words` ask for, or nothing where they ask for help (`help` then has the text). Order does not matter; of two values for
/// one option the last wins. Throws OptionError.
std::optional<RenderJob> parse_render_arguments(const std::vector<std::string>& words, std::string& help);

}  // namespace rt
