// The scenes of a comparison.
#pragma once

#include <string>
#include <vector>

namespace rt {

struct VersusScene {
    /// Of an argument's folder and where it lies in it: "pov/shading/vases"; with folders around if that is not unique. UTF-8: in a name
    /// of other bytes those are written as %FF.
    std::string name;
    std::string path;  ///< absolute
};

/// Each once, however often it is among the arguments. Each argument's scene, or every *.pov below it, in the order of names; `only` (a
/// regular expression, may be empty) is for names. What lies in `output` or in hidden folders is none. Throws OptionError for what is not
/// there and if nothing is left.
std::vector<VersusScene> scenes_of(const std::vector<std::string>& arguments, const std::string& only, const std::string& output);

}  // namespace rt
