#include "commands/grade/builds.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include "commands/base/clock.h"
#include "commands/base/content_hash.h"
#include "commands/base/run_place.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "core/source.h"
#include "grading/file_lock.h"
#include "grading/workers.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// Of a build that compiles `jobs` files at a time.
Limits build_limits(int jobs) {
    Limits limits;
    limits.wall_seconds = 600.0;
    limits.memory_bytes = static_cast<std::uint64_t>(std::max(jobs, 4)) << 30;
    limits.output_bytes = 16ull << 20;
    limits.file_bytes = 1ull << 30;
    limits.processes = 256;
    return limits;
}

/// Files that one of `parallel` builds compiles at a time.
int jobs_for(int parallel) {
    constexpr long most = 16;
    return static_cast<int>(std::clamp(sysconf(_SC_NPROCESSORS_ONLN) / parallel, 1l, most));
}

/// The end of what a build printed.
std::string last_lines(const std::string& text, std::size_t count) {
    std::vector<std::string> lines = split(text, '\n');
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    const std::size_t from = lines.size() > count ? lines.size() - count : 0;
    std::string last;
    for (std::size_t i = from; i < lines.size(); ++i) last += (last.empty() ? "" : " / ") + printable(lines[i], 200);
    return last;
}

/// A name of which neither make nor a shell takes anything amiss.
std::string plain(const std::string& name) {
    std::string plain = name.substr(0, 64);
    for (char& c : plain)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_' && c != '.') c = '_';
    return plain;
}

/// Sources, and the folder that they are built in: named by what is in them.
struct Build {
    std::string sources, copy;
    std::string outcome() const { return copy + ".outcome"; }  ///< the file that holds what went wrong, once the build has ended
    std::string lock() const { return copy + ".lock"; }
};

/// Every step's words, but for how many jobs there are at a time.
std::string rule_of(const std::string& folder) {
    std::string rule;
    for (const BuildStep& step : build_steps(folder, 1)) rule += fmt::format("{}\n", fmt::join(step.command, "\n"));
    return rule;
}

Build build_of(const SourceTree& tree, const std::string& folder) {
    const std::string content = hash_of(hash_of_folder(tree.folder) + rule_of(tree.folder)).substr(0, 16);
    return {tree.folder, (fs::path(folder) / fmt::format("{}-{}", plain(tree.name), content)).string()};
}

/// What went wrong in a build that has ended, empty if nothing; none if it has not.
std::optional<std::string> ended(const Build& build) {
    constexpr std::size_t most_bytes = 1u << 16;
    std::error_code none;
    std::optional<std::string> problem = read_file_text(build.outcome(), most_bytes);
    if (problem && problem->empty() && !fs::is_directory(build.copy, none)) return std::nullopt;
    return problem;
}

/// Of errors while a submission is copied, those that it has no part in.
bool is_ours(const std::error_code& error) {
    for (const std::errc code : {std::errc::no_space_on_device, std::errc::read_only_file_system, std::errc::io_error,
                                 std::errc::too_many_files_open, std::errc::too_many_files_open_in_system, std::errc::not_enough_memory})
        if (error == code) return true;
    return error.value() == EDQUOT;
}

/// In a process of its own: carries out one build.
class Builder {
public:
    Builder(const Build& build, const BuildOptions& options, const Grading& grading, int slot)
        : build_(build), options_(options), grading_(grading), slot_(slot) {}

    void run() {
        std::optional<LockFile> lock;
        try {
            lock.emplace(build_.lock()).lock(0, LockFile::Kind::exclusive);
        } catch (const std::system_error&) {  // a disk without locks
            if (options_.shared) throw;
        }
        if (!grading_.fresh && ended(build_)) return;  // by somebody else, meanwhile
        std::error_code none;
        fs::remove(build_.outcome(), none);
        std::optional<std::string> problem = attempt(Turn::Kind::together);
        if (!problem) problem = attempt(Turn::Kind::alone);
        write_report(build_.outcome(), *problem);
    }

private:
    /// What went wrong, empty if nothing; none if it was late and others may be why.
    std::optional<std::string> attempt(Turn::Kind kind) {
        const Turn turn(grading_.turns, kind);
        const std::string scratch = (fs::path(build_.copy) / ".raytrace-scratch").string();
        const int jobs = jobs_for(kind == Turn::Kind::alone ? 1 : options_.parallel);
        const Limits limits = build_limits(jobs);
        if (const std::string problem = copy(); !problem.empty()) return problem;
        for (const BuildStep& step : build_steps(build_.copy, jobs)) {
            std::error_code none;
            fs::remove_all(scratch, none);  // whatever the submission, or the step before, has put there
            make_folder(scratch);
            const Ending ending =
                run_contained({step.command, build_.copy, step.folder, {}, {}, scratch}, limits, grading_.containment, slot_);
            fs::remove_all(scratch, none);
            if (ending.kind == Ending::Kind::exited && ending.status == 0) continue;
            if (ending.least_room_bytes < least_room)
                throw OutputError(fmt::format("the disk of '{}' was full, or nearly so", printable(options_.folder)));
            if (ending.kind == Ending::Kind::not_started)
                throw OptionError(fmt::format("cannot build: {}: {}", step.command[0], ending.reason));
            if (ending.kind != Ending::Kind::time_out) return fmt::format("build failed: {}", last_lines(ending.output + ending.reason, 3));
            const bool waited = may_have_waited(ending.cpu_seconds, limits.wall_seconds, ending.busy_threads) && !turn.was_alone();
            if (kind == Turn::Kind::together && waited) return std::nullopt;
            return "build failed: not done in time";
        }
        return "";
    }

    std::string copy() const {
        expect_room(options_.folder);
        std::error_code error;
        fs::remove_all(build_.copy, error);
        fs::copy(build_.sources, build_.copy, fs::copy_options::recursive | fs::copy_options::copy_symlinks, error);
        if (!error) fs::remove_all(fs::path(build_.copy) / "build", error);
        if (!error) return "";
        const std::string problem = fmt::format("cannot copy '{}': {}", printable(build_.sources), error.message());
        if (is_ours(error)) throw OutputError(problem);
        return problem;
    }

    const Build& build_;
    const BuildOptions& options_;
    const Grading& grading_;
    int slot_;
};

/// The builds that are wanted, each once, and what became of them.
class Builds {
public:
    Builds(const BuildOptions& options, const Grading& grading, const std::atomic<bool>& stop)
        : options_(options), grading_(grading), stop_(stop) {}

    void want(const Build& build) {
        if (!faults_.emplace(build.copy, "").second) return;
        ++progress_.tasks;
        if (!grading_.fresh && ended(build))
            ++progress_.done, ++progress_.taken;
        else
            missing_.push_back(build);
    }

    void run(const std::function<void(const TaskProgress&)>& progress) {
        std::rotate(missing_.begin(), missing_.begin() + static_cast<std::ptrdiff_t>(first_of_shard()), missing_.end());
        std::vector<Clock::time_point> started(missing_.size());
        const Clock::time_point start = Clock::now();
        TimeLeft left;
        for (std::size_t i = 0; i < missing_.size(); ++i) left.expect("");
        const auto tell = [&] {
            progress_.seconds = seconds_since(start), progress_.seconds_left = left.seconds(options_.parallel);
            progress(progress_);
        };
        const auto done = [&](std::size_t i, const WorkerEnd& end) {
            ++progress_.done, left.add("", seconds_since(started[i]));
            if (end.done) return;
            if (end.not_written && not_written_.empty()) not_written_ = end.problem;
            faults_[missing_[i].copy] = end.signal ? fmt::format("building it was ended by signal {}", end.signal) : end.problem;
        };
        run_jobs(missing_.size(), options_.parallel,
                 {.begin = [&](std::size_t i) { started[i] = Clock::now(); },
                  .work = [&](std::size_t i, int slot) { Builder(missing_[i], options_, grading_, slot).run(); },
                  .done = done,
                  .idle = tell},
                 stop_);
    }

    /// Gives the submission what the build has made of its sources.
    void settle(Submission& submission, const Build& build) const {
        const std::optional<std::string> problem = ended(build);
        if (const std::string& fault = faults_.at(build.copy); !fault.empty() || !problem) {
            submission.problem = fault.empty() ? "the grading was interrupted before" : fault;
            submission.without_program = fault.empty() ? Outcome::not_run : Outcome::not_judged;
            return;
        }
        submission.problem = *problem;
        if (!problem->empty()) return;
        for (const std::string place : {"build/", "", "src/"})
            if (const std::string program = own_program(build.copy, place + program_name); !program.empty())
                return give_program(submission, program, build.copy);
        submission.problem = fmt::format("the build made no '{}'", program_name);
    }

    const std::string& not_written() const { return not_written_; }

private:
    std::size_t first_of_shard() const { return missing_.size() * options_.shard.index / options_.shard.of; }

    const BuildOptions& options_;
    const Grading& grading_;
    const std::atomic<bool>& stop_;
    std::vector<Build> missing_;
    std::map<std::string, std::string> faults_;  ///< by the folders of all that are wanted: what kept us from building them
    std::string not_written_;
    TaskProgress progress_;
};

}  // namespace

std::string find_programs(std::vector<Submission>& submissions, const std::vector<SourceTree>& trees, const std::vector<bool>& wanted,
                          const BuildOptions& options, const Grading& grading, const std::atomic<bool>& stop,
                          const std::function<void(const TaskProgress&)>& progress) {
    Builds builds(options, grading, stop);
    std::vector<std::optional<Build>> build_of_tree(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        if (!wanted[i] || !trees[i].problem.empty() || !trees[i].program.empty()) continue;
        make_folder(options.folder);
        build_of_tree[i] = build_of(trees[i], options.folder);
        builds.want(*build_of_tree[i]);
    }
    builds.run(progress);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        if (build_of_tree[i])
            builds.settle(submissions[i], *build_of_tree[i]);
        else if (wanted[i] && !trees[i].program.empty())
            give_program(submissions[i], trees[i].program, trees[i].folder);
    }
    return builds.not_written();
}

}  // namespace rt
