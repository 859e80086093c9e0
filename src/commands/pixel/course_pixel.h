// One pixel of a course's command, traced with all of its rays.
#pragma once

#include "commands/job/course_arguments.h"
#include "commands/pixel/ray_tree_json.h"

namespace rt {

/// The pixel that the arguments name, by the same code as the picture. Fills what the job left open. Throws as read_scene() does.
TracedPixel trace_course_pixel(CourseArguments& arguments);

}  // namespace rt
