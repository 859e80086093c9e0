// A scene under the commands that tell of one pixel, with whatever faults are selected.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "commands/job/course_arguments.h"
#include "grading/told_pixel.h"
#include "trace/render.h"

namespace rt::test {

/// How the two records of a comparison are told.
enum class Form {
    json,       ///< both in JSON
    printrays,  ///< ours in JSON, the other's in the course's text, rays one below the other
    tree,       ///< the same with the other's drawn as a tree
    text,       ///< both in the course's text
};
inline constexpr std::array<Form, 4> forms{Form::json, Form::printrays, Form::tree, Form::text};
inline constexpr std::array<const char*, 4> form_names{"json", "json, printrays", "json, tree", "printrays"};

class Subject {
public:
    /// Reads a scene; `options` are words of the course's commands. Throws what a command would.
    Subject(const std::string& file, const std::vector<std::string>& options, int width, int height);

    /// The bytes of the picture, row by row from the top.
    std::vector<std::uint16_t> picture() const;

    /// A pixel's record, read back from its JSON (0), its printrays (1) and its pixeltrace (2). `y` is counted from the top.
    std::array<ToldPixel, 3> told(int x, int y) const;

    int width() const { return options_.width; }
    int height() const { return options_.height; }

private:
    CourseArguments arguments_;
    Scene scene_;
    World world_;
    RenderOptions options_;
};

/// Places in the records of told(): of the right one and of the other one.
std::array<std::size_t, 2> records_of(Form form);

}  // namespace rt::test
