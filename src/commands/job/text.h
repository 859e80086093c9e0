// What a picture says about itself.
#pragma once

#include <string>
#include <string_view>

#include "commands/job/render_job.h"
#include "film/image_file.h"
#include "scene/scene.h"

namespace rt {

/// The name of the shading, with what the course's rules were asked for.
std::string shading_text(const RenderJob& job);

/// What a picture says about its making. Nothing in it depends on the machine, the time or the number of threads.
ImageMetadata picture_metadata(const RenderJob& job, const Scene& scene);

}  // namespace rt
