// One render from file to file.
#pragma once

#include "commands/render_job.h"

namespace rt {

/// Where scenes' includes are searched after the folders a user names: $RAYTRACE_LIBRARY_PATH (separated by colons), then POV-Ray's
/// installed folders.
std::vector<std::string> default_library_paths();

/// Scene messages for stderr, or for nobody.
MessageSink message_sink(bool quiet);

/// parse -> compile -> render -> encode -> write. Returns the exit status: 0, or 2 after an interruption that left a partial picture.
/// Throws SceneError, OptionError, OutputError and LimitError.
int run_session(RenderJob job);

}  // namespace rt
