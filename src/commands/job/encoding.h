// How a job's picture becomes a file's numbers, and what of its wishes the file's format cannot hold.
#pragma once

#include <string>
#include <vector>

#include "commands/job/render_job.h"
#include "film/image_file.h"
#include "scene/scene.h"

namespace rt {

Encoding encoding_of(const RenderJob& job, const Gamma& gamma);

/// One sentence for each option in `job` that `format` cannot hold, with what is written instead.
std::vector<std::string> format_losses(const RenderJob& job, ImageFormat format);

}  // namespace rt
