#include "commands/grade/grade_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "commands/base/clock.h"
#include "grading/workers.h"

namespace rt {

namespace {

class Run {
public:
    Run(const Grading& grading, const std::vector<GradeTask>& tasks, const GradeStore& store, const std::atomic<bool>& stop,
        const std::function<void(const TaskProgress&)>& progress)
        : grading_(grading), tasks_(tasks), store_(store), stop_(stop), report_(progress), results_(tasks.size()), started_(tasks.size()) {
        progress_.tasks = tasks.size();
    }

    /// What needs no run. Returns the others, of those that are the same only the first.
    std::vector<std::size_t> take_known() {
        std::vector<std::size_t> others;
        std::map<std::string, std::size_t> firsts;
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            const auto& [submission, test] = tasks_[i];
            if (submission->program.empty())
                results_[i] = result_without_program(*submission, *test);
            else if (!grading_.fresh)
                results_[i] = from_store(i);
            // Whether it was slow or had no room is not known: it was interrupted before it could be run alone.
            if (was_late_beside_others(i)) results_[i].reset();
            if (results_[i])
                ++progress_.done, ++progress_.taken;
            else if (const auto [first, is_new] = firsts.emplace(key_of(grading_, *submission, *test), i); is_new)
                others.push_back(i), left_.expect(test->name);
            else
                followers_[first->second].push_back(i);
        }
        return others;
    }

    void run(const std::vector<std::size_t>& chosen, int parallel, Turn::Kind kind) {
        if (chosen.empty() || stop_) return;
        const auto work = [&](std::size_t job, int slot) {
            const GradeTask& task = tasks_[chosen[job]];
            run_test(grading_, *task.submission, *task.test, store_, slot, kind);
        };
        const auto begin = [&](std::size_t job) { started_[chosen[job]] = Clock::now(); };
        const auto done = [&](std::size_t job, const WorkerEnd& end) { finish(chosen[job], end); };
        const auto idle = [&] { tell(parallel); };
        run_jobs(chosen.size(), parallel, {begin, work, done, idle}, stop_);
        tell(parallel);
    }

    /// Those that did not end in time, and might alone.
    std::vector<std::size_t> late_ones(const std::vector<std::size_t>& chosen) const {
        std::vector<std::size_t> late;
        for (const std::size_t i : chosen)
            if (was_late_beside_others(i)) late.push_back(i);
        return late;
    }
    /// What is known of them stays, should nothing new come of it.
    void expect_again(const std::vector<std::size_t>& chosen) {
        for (const std::size_t i : chosen) left_.expect(tasks_[i].test->name), progress_.done -= 1 + followers_[i].size();
    }

    TaskResults results() {
        TaskResults all;
        for (std::size_t i = 0; i < tasks_.size(); ++i) all.results.push_back(results_[i] ? std::move(*results_[i]) : not_run(i));
        all.not_written = not_written_;
        return all;
    }

private:
    /// A run that was not done in time and might be, alone.
    bool was_late_beside_others(std::size_t i) const {
        return results_[i] && results_[i]->outcome == Outcome::time_out && !results_[i]->alone &&
               may_have_waited(results_[i]->cpu_seconds, tasks_[i].test->limits.wall_seconds, results_[i]->busy_threads);
    }

    /// Programs and tests that are the same share an entry; each has its own name.
    std::optional<Result> from_store(std::size_t i) const {
        const auto& [submission, test] = tasks_[i];
        const std::string key = key_of(grading_, *submission, *test);
        std::optional<Result> result = store_.find(key);
        if (result)
            result->submission = submission->name, result->test = test->name, result->required = test->required,
            result->weight = test->weight, result->picture = store_.picture_path(key);
        return result;
    }
    Result not_run(std::size_t i) const {
        Result result = result_without_program(*tasks_[i].submission, *tasks_[i].test);
        result.outcome = Outcome::not_run, result.reason = "the grading was interrupted before";
        return result;
    }

    void finish(std::size_t i, const WorkerEnd& end) {
        left_.add(tasks_[i].test->name, seconds_since(started_[i]));
        settle(i, end);
        for (const std::size_t follower : followers_[i]) settle(follower, end);
    }

    void settle(std::size_t i, const WorkerEnd& end) {
        ++progress_.done;
        if (end.not_written && not_written_.empty()) not_written_ = end.problem;
        if (end.done) results_[i] = from_store(i);
        if (results_[i]) return;
        results_[i] = result_without_program(*tasks_[i].submission, *tasks_[i].test);
        results_[i]->outcome = Outcome::not_judged;
        results_[i]->reason = end.signal            ? fmt::format("judging it was ended by signal {}", end.signal)
                              : end.problem.empty() ? "its result could not be kept"
                                                    : end.problem;
    }

    void tell(int parallel) {
        progress_.seconds = seconds_since(start_);
        progress_.seconds_left = left_.seconds(parallel);
        report_(progress_);
    }

    const Grading& grading_;
    const std::vector<GradeTask>& tasks_;
    const GradeStore& store_;
    const std::atomic<bool>& stop_;
    const std::function<void(const TaskProgress&)>& report_;
    std::vector<std::optional<Result>> results_;
    std::vector<Clock::time_point> started_;
    std::map<std::size_t, std::vector<std::size_t>> followers_;  ///< of a task: those with the same program and test
    std::string not_written_;
    TimeLeft left_;
    TaskProgress progress_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

std::vector<GradeTask> tasks_of(const std::vector<Submission>& submissions, const Suite& suite, const Shard& shard) {
    std::vector<GradeTask> tasks;
    std::size_t number = 0;
    for (const Submission& submission : submissions)
        for (const TestCase& test : suite.tests) {
            const bool made = test.kind != TestCase::Kind::shown || has_scene(submission, test);
            if (made && number++ % shard.of == shard.index) tasks.push_back({&submission, &test});
        }
    return tasks;
}

TaskResults run_tasks(const Grading& grading, const std::vector<GradeTask>& tasks, const GradeStore& store, int parallel,
                      const std::atomic<bool>& stop, const std::function<void(const TaskProgress&)>& progress) {
    Run run(grading, tasks, store, stop, progress);
    std::vector<std::size_t> together, alone;
    for (const std::size_t i : run.take_known()) (tasks[i].test->timed ? alone : together).push_back(i);
    run.run(together, parallel, Turn::Kind::together);
    run.run(alone, 1, Turn::Kind::alone);
    if (!stop) {
        const std::vector<std::size_t> late = run.late_ones(together);
        run.expect_again(late);
        run.run(late, 1, Turn::Kind::alone);
    }
    return run.results();
}

}  // namespace rt
