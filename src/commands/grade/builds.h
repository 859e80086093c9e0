// Submissions that come as sources get their programs: many builds at a time, each kept by what it was made of.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "commands/base/task_progress.h"
#include "commands/grade/submissions.h"

namespace rt {

struct BuildOptions {
    std::string folder;   ///< of what is built
    bool shared = false;  ///< with other gradings: then its disk must have locks
    int parallel = 1;     ///< builds at a time, which share the processors
    Shard shard;          ///< each begins elsewhere in the list, so that those that share the folder share the work
};

/// Gives those of `submissions` that are `wanted` their programs; `trees` are theirs, one by one. Sources are built in a copy, contained as
/// any run is; what became of the same sources before is taken, and of several gradings that want the same one builds it while the others
/// wait. A build that is late while others run is repeated with nothing beside it. What went wrong is the submission's `problem`; if it is
/// no fault of its own (a full disk, no CMake here) it counts as not judged, after `stop` what is not built as not run. Links do not count:
/// nothing outside a submission becomes a part of it. Returns what could not be written, empty if nothing.
std::string find_programs(std::vector<Submission>& submissions, const std::vector<SourceTree>& trees, const std::vector<bool>& wanted,
                          const BuildOptions& options, const Grading& grading, const std::atomic<bool>& stop,
                          const std::function<void(const TaskProgress&)>& progress);

}  // namespace rt
