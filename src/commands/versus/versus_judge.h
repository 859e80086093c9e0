// Two pictures, and what three runs came to.
#pragma once

#include "commands/versus/versus_result.h"
#include "film/image_file.h"

namespace rt {

/// Both pictures have the same size and 8 bits.
Likeness likeness_of(const StoredImage& povray, const StoredImage& ours, const VersusLimits& limits);

/// What the runs, the features and the likeness of a result come to.
VersusCause cause_of(const VersusResult& result, const VersusLimits& limits);

}  // namespace rt
