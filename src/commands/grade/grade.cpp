// raytrace grade SUITE: every test of a suite with any program, judged, kept and reported. raytrace merge joins the parts of one.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

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
    line.value("-j,--jobs", "N", "tests at a time (all processors)",
               [&](const std::string& v) { job.parallel = whole_number("jobs", v, 1, 1024); });
    line.value("--shard", "I/N", "every N-th test from the I-th only; see help merge",
               [&](const std::string& v) { job.shard = shard_of(v); });
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

/// Two programs of one name get a number each.
void name_apart(std::vector<Submission>& submissions) {
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const std::string name = submissions[i].name;
        int number = 1;
        for (std::size_t j = i + 1; j < submissions.size(); ++j)
            if (submissions[j].name == name) submissions[j].name += fmt::format("-{}", ++number);
    }
}

std::vector<Submission> programs_of(const GradeJob& job, const Containment& containment, const MessageSink& messages) {
    std::vector<std::string> paths = job.programs;
    if (!job.submissions.empty())
        for (const std::string& path : submissions_in(job.submissions)) paths.push_back(path);
    if (paths.empty()) throw OptionError("grade: expected --exe PROGRAM or --submissions DIR; see raytrace grade --help");
    std::vector<Submission> submissions;
    for (const std::string& path : paths) {
        const SourceTree tree = look_at(path, job.as_is);
        if (tree.problem.empty() && tree.program.empty()) messages(fmt::format("raytrace: building {}", tree.name));
        submissions.push_back(build(tree, {(fs::path(job.folder) / "builds").string(), job.fresh}, containment, 0));
        const std::string& problem = submissions.back().problem;
        if (problem.empty()) continue;
        if (paths.size() == 1 && job.submissions.empty()) throw OptionError(fmt::format("{}: {}", tree.name, problem));
        messages(fmt::format("raytrace: {}: {}", tree.name, problem));
    }
    name_apart(submissions);
    return submissions;
}

std::string existing_path(const std::string& path) {
    std::error_code error;
    const fs::path place = fs::canonical(path, error);
    if (error) throw OptionError(fmt::format("--readable: there is no '{}'", path));
    return place.string();
}

void make_folder(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw OutputError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
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

int run(GradeJob job) {
    const MessageSink messages = message_sink(job.quiet);
    Grading grading;
    grading.suite = read_suite(job.suite, job.inputs, messages);
    const Suite asked = only(grading.suite, job.only);
    make_folder(job.folder);
    job.folder = grading.folder = fs::canonical(job.folder).string();
    if (job.audit) return run_audit(job, asked);
    grading.containment = find_containment();
    for (const std::string& path : job.readable) grading.readable.push_back(existing_path(path));
    grading.common_hash = common_hash_of(grading);
    grading.rule_hashes = rule_hashes_of(grading.suite);
    const std::vector<std::string> uncontained = holes(grading.containment);
    for (const std::string& hole : uncontained) messages(fmt::format("raytrace: warning: {}", hole));
    const std::vector<Submission> submissions = programs_of(job, grading.containment, messages);

    remove_left_places();
    const GradeStore store((fs::path(job.folder) / "known").string());
    const std::vector<GradeTask> tasks = tasks_of(submissions, asked, job.shard);
    GradeRecord record{grading.suite.name, uncontained, job.shard, {}, asked.tests};
    {
        const StopOnSignal signals;
        TaskProgressLine progress(!job.quiet, "tests");
        record.results = run_tasks(grading, tasks, store, job.parallel, job.fresh, signals.stop(),
                                   [&](const TaskProgress& state) { progress.update(state); });
    }
    remove_left_places();  // of workers that an interruption ended
    write_reports(record, job.folder, job.all_pictures);
    if (!job.quiet) write_stdout(table_text(record));
    messages(fmt::format("raytrace: reports are in {}", job.folder));
    const bool many = submissions.size() > 1 || !job.submissions.empty() || job.shard.of > 1;
    return exit_status(record, many);
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
    if (suites.size() != 1) throw OptionError("grade: expected one suite; see raytrace grade --help");
    job.suite = suites[0];
    return run(std::move(job));
}

}  // namespace rt
