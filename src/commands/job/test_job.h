// A test's command as a render of our own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/job/render_job.h"

namespace rt {

/// The picture that a course's `render` or `raycast` asks for, by one thread. Empty if the words are neither, or ask for another profile or
/// shading. `inputs`: the folder that the scene's path calls ../resources. Throws OptionError for words that are mistakes.
std::optional<RenderJob> job_of_test(const std::vector<std::string>& arguments, const std::string& inputs);

/// The file of a scene that programs find as ../resources/NAME or resources/NAME, where `inputs` are those.
std::string scene_path(const std::string& inputs, const std::string& word);

}  // namespace rt
