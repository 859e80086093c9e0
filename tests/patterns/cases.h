// Patterns as POV-Ray writes them and as values of ours, and the points at which they are compared.
#pragma once

#include <string>
#include <vector>

#include "patterns/pattern.h"

namespace rt {

struct PatternCase {
    std::string text;  ///< what stands in `function { pattern { ... } }`; its own name in values.txt
    Pattern pattern;
};

std::vector<PatternCase> pattern_cases();
/// The contents of cases.df3, which stands beside the scene.
std::string case_density();
/// The picture of the cases of pictures, and the contents of cases.pgm, which is the same.
ValueGrid case_picture();
std::string case_picture_file();
/// Points in -3..3 and a few further out; the same for every case.
std::vector<Vec3> case_points();

}  // namespace rt
