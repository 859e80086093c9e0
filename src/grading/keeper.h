// The process between the grader and a run: it starts the program, watches it, ends everything, and measures.
#pragma once

#include <sys/types.h>

#include <optional>

#include "grading/control_group.h"
#include "grading/sandbox.h"

namespace rt {

struct Keeping {
    const ContainedRun& run;
    const Limits& limits;
    const Containment& containment;
    ControlGroup& group;
    std::optional<uid_t> user;  ///< whose the program becomes; none: stays ours
    int grader = -1;            ///< a pipe to the grader, which is dead when nobody reads it any more
};

/// Runs the program to its end, in a process that was forked for it. Never throws; when it returns the process has no descendants.
Ending keep(const Keeping& keeping);

/// Sends SIGKILL to all processes of a user at once. Only root may.
void end_processes_of(uid_t user);

}  // namespace rt
