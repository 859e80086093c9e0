// Our picture of a scene against POV-Ray's: how many pixels differ, and whether each of those lies on an edge.
#pragma once

#include <string>
#include <vector>

#include "trace/render.h"

namespace rt {

struct ParityOptions {
    int tolerance = 2;  ///< steps of the file's 16 bits, per channel
    Sampling sampling;
    std::vector<std::string> library_paths;
};

struct DifferentPixel {
    int x = 0, y = 0;
    int steps = 0;      ///< largest channel difference
    bool edge = false;  ///< a 3x3 grid of sub-samples differs in objects met, shadow answers or pattern cells
};

struct Parity {
    std::uint64_t pixels = 0;
    std::vector<DifferentPixel> different;
    double share() const { return pixels == 0 ? 1.0 : 1.0 - static_cast<double>(different.size()) / static_cast<double>(pixels); }
    std::size_t defects() const;
};

/// Renders `scene` with POV-Ray's shading and distances at the size of `picture` (16-bit, linear) and compares.
/// Throws what parsing, rendering and reading throw.
Parity compare_with_povray(const std::string& scene, const std::string& picture, const ParityOptions& options);

}  // namespace rt
