// A wrong pixel's rays: ours, and where the program's own record of its rays parts from them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grading/causes.h"
#include "grading/suite.h"

namespace rt {

struct PixelVerdict {
    std::optional<Cause> cause;      ///< of the first difference between both records; empty where there is none, or no record
    std::vector<std::string> lines;  ///< for a report
};

/// The words that make a program that follows the course's conventions tell of a pixel of its picture: printrays SCENE W H X Y and the
/// options. Empty if `arguments` are no `render` of a scene with its size, or ask for indirect light, whose rays every program draws anew.
/// `y_from_top` is turned to the course's, from the bottom.
std::vector<std::string> printrays_arguments(const std::vector<std::string>& arguments, int x, int y_from_top);

/// `printed` is what the program printed for printrays_arguments(). Empty lines if the scene cannot be read here.
PixelVerdict explain_pixel(const std::vector<std::string>& arguments, const std::string& inputs, int x, int y_from_top,
                           const std::string& printed);

/// Whether the cause of a picture and that of a pixel mean the same.
bool agree(const std::string& picture_cause, Cause cause);

}  // namespace rt
