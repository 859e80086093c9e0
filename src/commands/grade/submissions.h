// Programs to be graded: executables as they are, folders of sources built first.
#pragma once

#include <string>
#include <vector>

#include "commands/grade/grade_test.h"
#include "core/source.h"

namespace rt {

/// What is at `path`: an executable, or a folder that holds one called "raytrace" (itself, or in "build"), or else sources.
struct SourceTree {
    std::string name;     ///< the file's or folder's, in UTF-8
    std::string program;  ///< absolute path; empty: has to be built
    std::string folder;   ///< of the sources: the one with CMakeLists.txt or a makefile
    std::string problem;  ///< why neither is there
};

/// A folder without files but with a single folder stands for that one, and prog1 or CPE473 in it for itself, as the course's graders
/// have it. Sources win over an executable that lies among them, unless `as_is`.
SourceTree look_at(const std::string& path, bool as_is);

/// Everything in `folder`: each executable and each folder, in the order of their names. Throws OptionError if there is nothing.
std::vector<std::string> submissions_in(const std::string& folder);

/// What is known of a submission before it is built: its name, the folder of its author's scenes, or why there is no program.
Submission not_built(const SourceTree& tree);

/// The program at `program`: one from a folder sees that folder, `visible`; an executable by itself (`visible` empty) nothing but itself.
void give_program(Submission& submission, const std::string& program, const std::string& visible);

/// Where `name` lies in `folder`: a file that can be read and executed, no link, nor behind one. Empty if there is none.
std::string own_program(const std::string& folder, const std::string& name);

/// What a submission's program is called.
inline constexpr const char* program_name = "raytrace";

/// One command of a build, in its folder.
struct BuildStep {
    std::vector<std::string> command;
    std::string folder;
};
/// How the sources in `folder` are built: with CMake (Release), else make, else make in "src"; `jobs` at a time. Empty where there is
/// nothing to build with.
std::vector<BuildStep> build_steps(const std::string& folder, int jobs);

}  // namespace rt
