// Pictures of the surroundings, read for the tracer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "trace/environment.h"

namespace rt {

/// From one file (latitude and longitude) or six (cube: +x -x +y -y +z -z); none: null. Integer files hold sRGB, float files linear light.
/// Throws OptionError for files that cannot be read or do not fit together.
std::shared_ptr<const Environment> read_surroundings(const std::vector<std::string>& files);

}  // namespace rt
