// A picture that is seen while it is made, or that must be ready in time.
#pragma once

#include <functional>
#include <string>

#include "commands/job/render_job.h"

namespace rt {

/// Renders the options' picture as job.preview, job.time and its sampling ask for. `write` writes a picture to where the final one goes;
/// empty if that is not possible more than once.
RenderResult render_stepwise(const World& world, const RenderOptions& options, const RenderJob& job,
                             const std::function<void(const Film&)>& write);

/// What a job with a time has reached after `seconds`: one line without its end.
std::string reached_text(const Convergence& reached, double seconds);

}  // namespace rt
