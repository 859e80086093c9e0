// The choices that a scene file states in `//! raytrace: key=value` comments.
#pragma once

#include <optional>
#include <vector>

#include "commands/render_job.h"
#include "scene/scene.h"

namespace rt {

struct SceneChoices {
    std::optional<ShadingModel> shading;
    std::optional<Distances> distances;
    std::optional<Precision> precision;
    std::optional<AlphaMapping> alpha;
    std::vector<Unmodelled> unavailable;  ///< known, but not selected in this version; each place once
};

/// What `scene` and the files it includes choose; the last statement of a key counts. Throws SceneError, with the place, for an unknown
/// value.
SceneChoices choices_of(const Scene& scene);

/// Fills what the command line left open in `job` from the scene's own choices. Throws as choices_of() does, and for a choice that is not
/// available; under `lenient` that one is a warning to `messages`.
void apply_scene_choices(const Scene& scene, RenderJob& job, const MessageSink& messages);

}  // namespace rt
