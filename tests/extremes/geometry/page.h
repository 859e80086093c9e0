// The scenes of extreme geometry as lines of text and on one page that needs no other file.
#pragma once

#include "tests/extremes/geometry/verdict.h"

namespace rt::extremes {

std::string geometry_head();
/// Name, unstable pixels, and of each setting and program the wrong pixels with speckles and lost objects among them.
std::string geometry_line(const Verdict& verdict);

/// HTML with the same as a table, and each scene's pictures.
std::string geometry_page(const std::vector<Verdict>& verdicts);

}  // namespace rt::extremes
