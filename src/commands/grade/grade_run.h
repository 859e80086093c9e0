// All tests of all programs: what is known already is taken, the rest is run, and every one has a result at the end.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "commands/base/task_progress.h"
#include "commands/grade/grade_test.h"

namespace rt {

struct GradeTask {
    const Submission* submission = nullptr;
    const TestCase* test = nullptr;
};
/// Every test of every submission, in their order: one submission's tests one behind the other. Of a shard its own only.
std::vector<GradeTask> tasks_of(const std::vector<Submission>& submissions, const Suite& suite, const Shard& shard);

struct TaskResults {
    std::vector<Result> results;  ///< one for each task, in their order
    std::string not_written;      ///< why some could not be had or kept, a full disk for instance; empty if nothing was in the way
};

/// After `stop` some tasks are not run. Tests run `parallel` at a time; timed ones behind them, with nothing of any grader's beside them,
/// and so again what did not end in time while others were running.
TaskResults run_tasks(const Grading& grading, const std::vector<GradeTask>& tasks, const GradeStore& store, int parallel,
                      const std::atomic<bool>& stop, const std::function<void(const TaskProgress&)>& progress);

}  // namespace rt
