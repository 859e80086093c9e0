// The choices that a scene file states in `//! raytrace: key=value` comments.
#pragma once

#include <optional>

#include "commands/job/render_job.h"
#include "scene/scene.h"

namespace rt {

struct SceneChoices {
    std::optional<ShadingModel> shading;
    std::optional<Distances> distances;
    std::optional<Precision> precision;
    EdgeOptions edges;
};

/// What `scene` and the files it includes choose for the whole picture; the last statement of a key counts. The choices from the shading
/// catalogue, of the files and of every finish, in use or not, are checked as well. Throws SceneError, with the place, for a value that
/// does not exist or a choice that a finish cannot make.
SceneChoices choices_of(const Scene& scene);

/// Fills what the command line left open in `job` from the scene's own choices. Throws as choices_of() does.
void apply_scene_choices(const Scene& scene, RenderJob& job);

}  // namespace rt
