// Where two records of a pixel part, in words.
#pragma once

#include <string>

#include "grading/explain.h"

namespace rt {

/// Five lines: the field and its ray, both values, the likely cause and what it means. `a` is the first record.
std::string divergence_text(const Divergence& found, const ToldPixel& a);

}  // namespace rt
