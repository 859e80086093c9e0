// raytrace grade SUITE: every test of a suite with any program, judged, kept and reported. raytrace merge joins the parts of one.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "commands/base/command_line.h"
#include "commands/base/content_hash.h"
#include "commands/base/interrupt.h"
#include "commands/base/name_pattern.h"
#include "commands/base/program.h"
#include "commands/base/run_place.h"
#include "commands/base/task_progress.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "commands/commands.h"
#include "commands/grade/audit.h"
#include "commands/grade/builds.h"
#include "commands/grade/grade_reports.h"
#include "commands/grade/grade_run.h"
#include "commands/grade/submissions.h"
#include "commands/grade/suite_file.h"
#include "commands/help.h"
#include "commands/job/job_steps.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

struct GradeJob {
    std::string suite, inputs;
    std::vector<std::string> programs;  ///< executables and folders of sources
    std::string submissions;            ///< a folder of such
    std::vector<std::string> readable;
    std::string only;
    std::string folder = "grade-results";
    std::string builds;  ///< folder of what is built; empty: in the results'
    int parallel = static_cast<int>(std::max(1l, sysconf(_SC_NPROCESSORS_ONLN)));
    Shard shard;
    bool fresh = false, as_is = false, quiet = false, audit = false, all_pictures = false;
};

constexpr int exit_failed = 1;

Shard shard_of(const std::string& text) {
    const std::vector<std::string> parts = split(text, '/');
    if (parts.size() != 2) throw OptionError(fmt::format("--shard expects I/N, as in 2/8, found '{}'", text));
    const int of = whole_number("shard", parts[1], 1, 1000000);
    return {static_cast<std::size_t>(whole_number("shard", parts[0], 1, of) - 1), static_cast<std::size_t>(of)};
}

void define(CommandLine& line, GradeJob& job) {
    line.values("--exe", "PROGRAM", "a program, or a folder that is built (CMake, make)",
                [&](const std::string& v) { job.programs.push_back(v); });
    line.value("--submissions", "DIR", "every program and every folder of sources in DIR",
               [&](const std::string& v) { job.submissions = v; });
    line.value("--inputs", "DIR", "the scenes; programs see ../resources (the suite's)", [&](const std::string& v) { job.inputs = v; });
    line.values("--readable", "PATH", "more that every program may read", [&](const std::string& v) { job.readable.push_back(v); });
    line.value("--only", "REGEX", "tests whose name matches", [&](const std::string& v) { job.only = v; });
    line.value("-o,--output", "DIR", "reports and known results (grade-results)", [&](const std::string& v) { job.folder = v; });
    line.value("-j,--jobs", "N", "tests, and builds, at a time (all processors)",
               [&](const std::string& v) { job.parallel = whole_number("jobs", v, 1, 1024); });
    line.value("--shard", "I/N", "every N-th test from the I-th only; see help merge",
               [&](const std::string& v) { job.shard = shard_of(v); });
    line.value("--builds", "DIR", "what was built; shards may share it (-o's own)", [&](const std::string& v) { job.builds = v; });
    line.flag("--fresh", "run again what is known", [&] { job.fresh = true; });
    line.flag("--as-is", "take a program that lies among sources; build nothing", [&] { job.as_is = true; });
    line.flag("--audit", "no program: which mistakes the suite cannot notice", [&] { job.audit = true; });
    line.flag("--all-pictures", "pages with every picture, however large", [&] { job.all_pictures = true; });
    line.flag("-q,--quiet", "no notes, no progress, no table", [&] { job.quiet = true; });
}

/// The suite with the tests that are asked for.
Suite only(Suite suite, const std::string& pattern) {
    if (pattern.empty()) return suite;
    const auto wanted = name_pattern("only", pattern);
    std::erase_if(suite.tests, [&](const TestCase& test) { return !wanted(test.name); });
    if (suite.tests.empty()) throw OptionError(fmt::format("--only: no test's name matches '{}'", pattern));
    return suite;
}

/// Of programs with the same name all but the first get a number that makes it another.
void name_apart(std::vector<Submission>& submissions) {
    std::set<std::string> taken;
    std::vector<Submission*> seconds;
    for (Submission& submission : submissions)
        if (!taken.insert(submission.name).second) seconds.push_back(&submission);
    for (Submission* second : seconds) {
        const std::string name = second->name;
        for (int number = 2; !taken.insert(second->name).second; ++number) second->name = fmt::format("{}-{}", name, number);
    }
}

/// What is to be graded, as far as it can be known before anything is built.
struct Graded {
    std::vector<SourceTree> trees;
    std::vector<Submission> submissions;  ///< theirs
};

Graded graded_by(const GradeJob& job) {
    std::vector<std::string> paths = job.programs;
    if (!job.submissions.empty())
        for (const std::string& path : submissions_in(job.submissions)) paths.push_back(path);
    if (paths.empty()) throw OptionError("grade: expected --exe PROGRAM or --submissions DIR; see raytrace grade --help");
    Graded graded;
    for (const std::string& path : paths) {
        graded.trees.push_back(look_at(path, job.as_is));
        graded.submissions.push_back(not_built(graded.trees.back()));
    }
    name_apart(graded.submissions);
    return graded;
}

bool is_one(const GradeJob& job) { return job.programs.size() == 1 && job.submissions.empty(); }

/// Builds what tests are to be run of. Returns what could not be written.
std::string build(const GradeJob& job, Graded& graded, const std::vector<GradeTask>& tasks, const Grading& grading,
                  const std::atomic<bool>& stop, const MessageSink& messages) {
    std::vector<Submission>& submissions = graded.submissions;
    std::vector<bool> wanted(submissions.size());
    for (const GradeTask& task : tasks) wanted[static_cast<std::size_t>(task.submission - submissions.data())] = true;
    const std::string own = (fs::path(job.folder) / "builds").string();
    std::string not_written;
    {
        TaskProgressLine progress(!job.quiet, "builds");
        not_written = find_programs(submissions, graded.trees, wanted,
                                    {job.builds.empty() ? own : job.builds, !job.builds.empty(), job.parallel, job.shard}, grading, stop,
                                    [&](const TaskProgress& state) { progress.update(state); });
    }
    for (const Submission& submission : submissions) {
        if (submission.problem.empty() || submission.without_program == Outcome::not_run) continue;
        const std::string told = fmt::format("{}: {}", printable(submission.name), submission.problem);
        if (is_one(job) && not_written.empty()) throw OptionError(told);
        messages(fmt::format("raytrace: {}", told));
    }
    return not_written;
}

std::string existing_path(const std::string& path) {
    std::error_code error;
    const fs::path place = fs::canonical(path, error);
    if (error) throw OptionError(fmt::format("--readable: there is no '{}'", printable(path)));
    return place.string();
}

int exit_status(const GradeRecord& record, bool many) {
    bool failed = false, complete = true;
    for (const std::vector<Result>& results : by_submission(record.results)) {
        const Summary sum = summary_of(results);
        failed = failed || sum.required_passed < sum.required;
        complete = complete && sum.complete;
    }
    if (!complete) return exit_interrupted;
    return failed && !many ? exit_failed : 0;
}

int run_audit(const GradeJob& job, const Suite& suite) {
    const std::vector<AuditLine> lines = audit(suite);
    write_report((fs::path(job.folder) / "audit.json").string(), audit_json(suite, lines));
    if (!job.quiet) write_stdout(audit_text(lines));
    return 0;
}

/// Where graders take turns; empty, and told, if there is no such place.
std::string turns(const MessageSink& messages) {
    try {
        return place_of_turns();
    } catch (const std::system_error& error) {
        messages(fmt::format("raytrace: warning: other gradings on this machine run beside timed and late tests: {}", error.what()));
        return {};
    }
}

Grading grading_of(const GradeJob& job, Suite suite, const MessageSink& messages) {
    Grading grading;
    grading.suite = std::move(suite), grading.folder = job.folder, grading.fresh = job.fresh;
    grading.containment = find_containment();
    for (const std::string& path : job.readable) grading.readable.push_back(existing_path(path));
    grading.common_hash = common_hash_of(grading);
    grading.rule_hashes = rule_hashes_of(grading.suite);
    grading.turns = turns(messages);
    return grading;
}

/// Reports, and the table even where they cannot be written.
void report(const GradeJob& job, const GradeRecord& record) {
    const std::string table = job.quiet ? "" : table_text(record);
    try {
        write_reports(record, job.folder, job.all_pictures);
    } catch (const OutputError&) {
        write_stdout(table);
        throw;
    }
    write_stdout(table);
}

int run(GradeJob job) {
    const MessageSink messages = message_sink(job.quiet);
    Suite suite = read_suite(job.suite, job.inputs, messages);
    const Suite asked = only(suite, job.only);
    make_folder(job.folder);
    job.folder = fs::canonical(job.folder).string();
    if (job.audit) return run_audit(job, asked);
    if (!job.builds.empty()) {
        make_folder(job.builds);
        job.builds = fs::canonical(job.builds).string();
    }
    const Grading grading = grading_of(job, std::move(suite), messages);
    GradeRecord record{grading.suite.name, holes(grading.containment), job.shard, {}, asked.tests};
    for (const std::string& hole : record.holes) messages(fmt::format("raytrace: warning: {}", hole));
    remove_left_places();
    Graded graded = graded_by(job);
    const GradeStore store((fs::path(job.folder) / "known").string());
    const std::vector<GradeTask> tasks = tasks_of(graded.submissions, asked, job.shard);
    std::string not_written;
    {
        const StopOnSignal signals;
        not_written = build(job, graded, tasks, grading, signals.stop(), messages);
        TaskProgressLine progress(!job.quiet, "tests");
        TaskResults done =
            run_tasks(grading, tasks, store, job.parallel, signals.stop(), [&](const TaskProgress& state) { progress.update(state); });
        record.results = std::move(done.results);
        if (not_written.empty()) not_written = std::move(done.not_written);
    }
    remove_left_places();  // of workers that an interruption ended
    report(job, record);
    messages(fmt::format("raytrace: reports are in {}", printable(job.folder)));
    if (!not_written.empty()) throw OutputError("not everything could be judged: " + not_written);
    return exit_status(record, !is_one(job) || job.shard.of > 1);
}

}  // namespace

int run_grade(const Words& words) {
    GradeJob job;
    CommandLine line(grade_usage, grade_footer);
    define(line, job);
    const Words suites = line.parse(with_two_dashes(words, line));
    if (line.help_asked()) {
        write_stdout(line.help());
        return 0;
    }
    if (job.fresh && !job.builds.empty())
        throw OptionError("--fresh builds again what others that share --builds may be running; give one of them");
    if (suites.size() != 1) throw OptionError("grade: expected one suite; see raytrace grade --help");
    job.suite = suites[0];
    return run(std::move(job));
}

}  // namespace rt
