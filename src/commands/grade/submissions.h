// Programs to be graded: executables as they are, folders of sources built first.
#pragma once

#include <string>
#include <vector>

#include "commands/grade/grade_test.h"
#include "core/source.h"

namespace rt {

/// What is at `path`: an executable, or a folder that holds one called "raytrace" (itself, or in "build"), or else sources.
struct SourceTree {
    std::string name;
    std::string program;  ///< absolute path; empty: has to be built
    std::string folder;   ///< of the sources: the one with CMakeLists.txt or a makefile
    std::string problem;  ///< why neither is there
};

/// A folder without files but with a single folder stands for that one, and prog1 or CPE473 in it for itself, as the course's graders
/// have it. Sources win over an executable that lies among them, unless `as_is`.
SourceTree look_at(const std::string& path, bool as_is);

/// Everything in `folder`: each executable and each folder, in the order of their names. Throws OptionError if there is nothing.
std::vector<std::string> submissions_in(const std::string& folder);

/// Where and how sources are built.
struct BuildOptions {
    std::string folder;  ///< of the copies
    bool fresh = false;  ///< what is built already is built again
};

/// The program of `tree`, built if it has to be: in a copy and contained as any run is, with CMake (Release), else make, else make in
/// "src". What became of the same sources before is taken. What went wrong is the submission's `problem`. A program from a folder sees that
/// folder, an executable by itself nothing but itself. Links do not count: nothing outside a submission becomes a part of it.
Submission build(const SourceTree& tree, const BuildOptions& options, const Containment& containment, int slot);

}  // namespace rt
