// One render from file to file.
#pragma once

#include "commands/job/render_job.h"

namespace rt {

/// parse -> compile -> render -> encode -> write. Returns the exit status: 0, or 2 after an interruption that left a partial picture.
/// Throws SceneError, OptionError, OutputError and LimitError.
int run_session(RenderJob job);

/// The same for every frame of the job's animation, up to the first that does not end with 0.
int run_animation(const RenderJob& job);

}  // namespace rt
