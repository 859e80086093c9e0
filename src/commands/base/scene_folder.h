// The scenes of a folder.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Every *.pov below `folder`, in the order of names; what lies in hidden folders or in `left_out` (may be empty) is none.
std::vector<std::string> scenes_below(const std::string& folder, const std::string& left_out);

}  // namespace rt
