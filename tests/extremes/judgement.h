// The program's picture of an extreme scene beside the truth, and beside what textbook formulas make of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/extremes/bytes.h"
#include "tests/extremes/renderer.h"

namespace rt::extremes {

inline constexpr int picture_width = 129, picture_height = 97;  // odd: a pixel in the middle

/// The pictures of one scene.
struct Judgement {
    std::string name;
    Bytes ours;                        ///< the program's file
    Bytes truth;                       ///< 113 bits, the forms that lose nothing
    Bytes textbook;                    ///< 113 bits, the textbook's forms, alpha = 0 as its limit
    Bytes naive_single, naive_double;  ///< the textbook's forms in the usual precisions, rays in double
    std::string png;                   ///< the program's file itself
};

/// No pixel of ours is wrong, and each is a number: one that is not is black in the file, which may be what the truth is.
bool right(const Judgement& judgement);

/// Scenes of pov/extremes, in order of their names: paths.
std::vector<std::string> scenes();

/// Renders all pictures of a scene. Throws what describe() throws, and std::runtime_error if the program fails.
Judgement judge(const std::string& scene);

}  // namespace rt::extremes
