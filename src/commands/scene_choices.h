// The choices that a scene file states in `//! raytrace: key=value` comments.
#pragma once

#include "commands/render_job.h"
#include "scene/scene.h"

namespace rt {

/// Fills what the command line left open in `job` from the scene's own choices. Throws SceneError, with the place, for an unknown key or
/// value; a key that is known but not available in this version is one too, or under `lenient` a warning to `messages`.
void apply_scene_choices(const Scene& scene, RenderJob& job, const MessageSink& messages);

}  // namespace rt
