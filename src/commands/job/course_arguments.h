// The words behind one of the course's commands, as a job of ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "commands/job/render_job.h"

namespace rt {

/// What one command takes by position.
struct CourseUsage {
    std::string_view command;
    bool size = false;   ///< SCENE WIDTH HEIGHT instead of SCENE
    bool pixel = false;  ///< ... and X Y
    bool tree = false;   ///< tells of all rays, with --json as JSON
    bool page = false;   ///< ... and with --html as a page
    bool writes_picture() const { return size && !pixel; }
};

/// What `pixeltrace --html` was asked for.
struct PixelPageRequest {
    std::string file;         ///< "-" is standard output
    std::optional<int> grid;  ///< pixels from one traced pixel to the next; 0: only those asked for; unset: as many as the page bears
    std::vector<std::pair<int, int>> pixels;  ///< x and y of those asked for, counted as the command line does
    std::vector<std::string> words;           ///< the command line without what says that it is a page
    std::size_t x_word = 0, y_word = 0;       ///< where the pixel stands in it
};

struct CourseArguments {
    RenderJob job;
    int x = 0, y = 0;  ///< counted from the bottom left; from the top left under POV-Ray's profile
    bool json = false;
    std::optional<PixelPageRequest> page = std::nullopt;
};

/// Rows of pictures are counted from the top, the course's on the command line from the bottom.
inline int row_from_top(const RenderJob& job, int y) { return job.profile == Profile::csc473 ? job.height - 1 - y : y; }

/// What stands behind -gi_samples=: directions at the camera ray's hit, at theirs, ... Throws OptionError.
std::vector<int> indirect_samples_of(std::string_view text);

/// `words` in any order: positions, the course's single-dash options, and our long ones. Throws OptionError: a position too many or too
/// few, no number, a pixel outside the picture, an option that neither has.
CourseArguments parse_course_arguments(const CourseUsage& usage, const std::vector<std::string>& words);

}  // namespace rt
