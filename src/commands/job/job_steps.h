// The steps of a render before its rays, for every command that takes them: read the scene, settle what was left open, build the world.
#pragma once

#include "commands/job/render_job.h"

namespace rt {

/// Where scenes' includes are searched after the folders a user names: $RAYTRACE_LIBRARY_PATH (separated by colons), then POV-Ray's
/// installed folders.
std::vector<std::string> default_library_paths();

/// Scene messages for stderr, or for nobody.
MessageSink message_sink(bool quiet);

/// The scene of a job, with its own choices and the defaults filled into what the job left open. Library paths are added to the job's.
/// Throws SceneError, OptionError and LimitError.
Scene read_scene(RenderJob& job, const MessageSink& messages);

/// The course's depth from `max_trace_level`, where the job has both.
void give_course_its_depth(RenderJob& job);

/// Both after read_scene(). `few_rays`, if set, are all that the world will be asked for.
World build_world(const RenderJob& job, const Scene& scene, const MessageSink& messages, std::optional<FewRays> few_rays = {});
RenderOptions render_options(const RenderJob& job, const Scene& scene);

}  // namespace rt
