// The words behind one of the course's commands, as a job of ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/render_job.h"

namespace rt {

/// What one command takes by position.
struct CourseUsage {
    std::string_view command;
    bool size = false;   ///< SCENE WIDTH HEIGHT instead of SCENE
    bool pixel = false;  ///< ... and X Y
    bool tree = false;   ///< tells of all rays, with --json as JSON
};

struct CourseArguments {
    RenderJob job;
    int x = 0, y = 0;  ///< counted from the bottom left; from the top left under POV-Ray's profile
    bool json = false;
};

/// `words` in any order: positions, the course's single-dash options, and our long ones. Throws OptionError: a position too many or too
/// few, no number, a pixel outside the picture, an option that neither has.
CourseArguments parse_course_arguments(const CourseUsage& usage, const std::vector<std::string>& words);

}  // namespace rt
