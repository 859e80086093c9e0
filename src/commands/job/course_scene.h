// Scenes as the course reads them: what differs from POV-Ray's reading, and what its rules cannot show.
#pragma once

#include "scene/scene.h"
#include "syntax/parser.h"

namespace rt {

/// The course's rotations and defaults: a finish that states nothing neither shines nor reflects.
void read_as_course(ParseOptions& options);

/// Throws SceneError for what is no part of the course's scenes and would be seen: lamps other than points, an orthographic camera, layers
/// of textures, `transmit`, interior textures. A word of a finish that the course's rules do not use is a warning.
void check_course_scene(const Scene& scene, const MessageSink& warn);

}  // namespace rt
