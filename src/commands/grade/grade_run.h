// All tests of all programs: what is known already is taken, the rest is run, and every one has a result at the end.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "commands/base/task_progress.h"
#include "commands/grade/grade_test.h"

namespace rt {

/// A part of a grading that is spread over machines: every `of`-th test of the whole list, from the `index`-th.
struct Shard {
    std::size_t index = 0, of = 1;
};

struct GradeTask {
    const Submission* submission = nullptr;
    const TestCase* test = nullptr;
};
/// Every test of every submission, in their order: one submission's tests one behind the other. Of a shard its own only.
std::vector<GradeTask> tasks_of(const std::vector<Submission>& submissions, const Suite& suite, const Shard& shard);

/// A result for each task, in their order; after `stop` some are not run. Tests run `parallel` at a time; timed ones behind them, with
/// nothing beside them, and so again what did not end in time while others were running. `fresh`: known results are not taken.
std::vector<Result> run_tasks(const Grading& grading, const std::vector<GradeTask>& tasks, const GradeStore& store, int parallel,
                              bool fresh, const std::atomic<bool>& stop, const std::function<void(const TaskProgress&)>& progress);

}  // namespace rt
