// Many jobs, some at a time, each in a process of its own: whatever one of them meets, the others and we go on.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace rt {

/// How a job's process ended.
struct WorkerEnd {
    bool done = false;         ///< its work returned
    int signal = 0;            ///< that ended it; 0 if none did
    bool not_written = false;  ///< what its work threw was an OutputError
    std::string problem;       ///< what its work threw
};

/// What is done for each job. `begin`, `done` and `idle` may be empty.
struct JobCalls {
    std::function<void(std::size_t job)> begin;                       ///< here, when its process has started
    std::function<void(std::size_t job, int slot)> work;              ///< in a process of its own; what it throws ends it as not done
    std::function<void(std::size_t job, const WorkerEnd& end)> done;  ///< here, as each ends, in any order
    std::function<void()> idle;                                       ///< here, a few times a second
};

/// Carries out the jobs 0 to `count` - 1 in their order, at most `parallel` at a time; slots 0 to `parallel` - 1 tell jobs at the same time
/// apart. Once `stop` is set nothing more begins, and what runs is ended and not told of. If we end, all of them do. Only for a process
/// with one thread. Throws std::system_error if no process can be made.
void run_jobs(std::size_t count, int parallel, const JobCalls& calls, const std::atomic<bool>& stop);

}  // namespace rt
