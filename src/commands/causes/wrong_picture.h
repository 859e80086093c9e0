// From a wrong picture to its cause.
#pragma once

#include "grading/finding.h"
#include "grading/suite.h"

namespace rt {

struct StoredImage;

/// Judges the difference by every hypothesis: of pictures alone, of other tests' pictures in `suite`, and of the scene if it can be read
/// as the course's. Both pictures have the same size.
Verdicts cause_of(const Suite& suite, const TestCase& test, const StoredImage& expected, const StoredImage& actual);

}  // namespace rt
