// What a picture says about itself, and the one way to standard output.
#pragma once

#include <string>
#include <string_view>

#include "commands/render_job.h"
#include "film/image_file.h"
#include "scene/scene.h"

namespace rt {

/// The version of the program, e.g. "0.1.0".
std::string_view program_version();

/// The name of the shading, with what the course's rules were asked for.
std::string shading_text(const RenderJob& job);

/// What a picture says about its making. Nothing in it depends on the machine, the time or the number of threads.
ImageMetadata picture_metadata(const RenderJob& job, const Scene& scene);

/// Writes all of `text` to standard output; throws OutputError if it is closed or full.
void write_stdout(std::string_view text);
/// Messages: a standard error that is closed or full loses them, and nothing else.
void write_stderr(std::string_view text) noexcept;
/// Gives closed standard streams to /dev/null, so that no file that is opened later takes their place.
void open_standard_streams() noexcept;

}  // namespace rt
