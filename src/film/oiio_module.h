// Finds and loads the OpenImageIO module when the first picture needs it.
#pragma once

#include "film/oiio/interface.h"

namespace rt {

/// The module's functions; loaded on the first call, from the program's folder or the one above it.
/// Throws OptionError that says what to install when it is missing.
const RaytraceImages& image_module();

}  // namespace rt
