#include "commands/grade_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "commands/content_hash.h"
#include "commands/result_json.h"
#include "commands/run_place.h"
#include "commands/text.h"
#include "commands/write_bytes.h"
#include "commands/wrong_answer.h"
#include "core/source.h"
#include "grading/judge.h"
#include "grading/result_names.h"
#include "grading/run_folder.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// A program's own folder, as the course's graders lay it out: it runs in "build", the scenes are in "resources" beside it and in it.
class Place {
public:
    Place(const Grading& grading, const Submission& submission, const TestCase& test) {
        const fs::path folder = place_.folder();
        fs::create_directory(folder / "build");
        fs::create_directory_symlink(grading.suite.inputs, folder / "resources");
        fs::create_directory_symlink(grading.suite.inputs, folder / "build" / "resources");
        if (test.kind == TestCase::Kind::shown)
            fs::copy_file(fs::path(submission.scenes) / test.arguments.at(1), folder / "build" / test.arguments.at(1));
    }

    std::string folder() const { return place_.folder(); }
    std::string working_folder() const { return (fs::path(place_.folder()) / "build").string(); }

private:
    RunPlace place_;
};

/// Where the right answers are: their folders, but where the scenes are in the same one the answers themselves.
std::vector<std::string> hidden_places(const Suite& suite) {
    std::set<std::string> places;
    for (const TestCase& test : suite.tests) {
        if (test.expected.empty()) continue;
        const fs::path folder = fs::path(test.expected).parent_path();
        const bool has_inputs = *fs::path(suite.inputs).lexically_relative(folder).begin() != "..";
        places.insert(has_inputs ? test.expected : folder.string());
    }
    return {places.begin(), places.end()};
}

ContainedRun contained_run(const Grading& grading, const Submission& submission, const TestCase& test, const Place& place) {
    ContainedRun run;
    run.command = {submission.program};
    run.command.insert(run.command.end(), test.arguments.begin(), test.arguments.end());
    run.folder = place.folder(), run.working_folder = place.working_folder();
    run.readable = {submission.program, grading.suite.inputs};
    if (!submission.visible.empty()) run.readable.push_back(submission.visible);
    run.hidden = hidden_places(grading.suite);
    run.hidden.push_back(grading.folder);
    return run;
}

/// The picture a program left, and its bytes as they were.
Written take_picture(const Place& place, const TestCase& test, std::string& bytes) {
    Written written;
    const TakenFile taken = take_file(place.working_folder(), test.output, test.limits.file_bytes);
    if (taken.missing) return written;
    written.state = Written::State::unreadable;
    written.reason = taken.problem;
    if (!taken.bytes) return written;
    try {
        const std::string path = (fs::path(place.folder()) / fmt::format("taken{}", fs::path(test.output).extension().string())).string();
        write_bytes(path, *taken.bytes);
        written.image = read_image(path);
        written.state = Written::State::picture;
        bytes = *taken.bytes;
    } catch (const OptionError& error) {
        written.reason = fmt::format("{} is no picture", test.output);
    }
    return written;
}

Result judged(const Suite& suite, const TestCase& test, const Ending& ending, const Place& place, const RunAgain& run_again,
              std::string& picture) {
    if (test.kind == TestCase::Kind::text) {
        const std::optional<std::string> expected = read_file_text(test.expected, test.limits.file_bytes);
        if (!expected) throw OptionError(fmt::format("cannot read '{}'", test.expected));
        Result result = judge_text(test, ending, *expected);
        if (result.outcome == Outcome::wrong_answer) explain_text(*expected, ending.output, result);
        return result;
    }
    const Written written = take_picture(place, test, picture);
    if (test.kind == TestCase::Kind::shown) return judge_shown(test, ending, written);
    const StoredImage expected = read_image(test.expected);
    Result result = judge_picture(test, ending, written, expected);
    if (result.outcome == Outcome::wrong_answer) explain_picture(suite, test, expected, written.image, run_again, result);
    return result;
}

/// The median run of a timed test stands for all of them, unless one fails.
Result run_once(const Grading& grading, const Submission& submission, const TestCase& test, int slot, std::string& picture) {
    const Place place(grading, submission, test);
    const ContainedRun run = contained_run(grading, submission, test, place);
    const Ending ending = run_contained(run, test.limits, grading.containment, slot);
    const RunAgain run_again = [&](const std::vector<std::string>& arguments) {
        ContainedRun again = run;
        again.command.resize(1);
        again.command.insert(again.command.end(), arguments.begin(), arguments.end());
        Limits limits = test.limits;
        limits.wall_seconds = std::min(limits.wall_seconds, 10.0);
        const Ending second = run_contained(again, limits, grading.containment, slot);
        return second.kind == Ending::Kind::exited && second.status == 0 ? second.output : std::string();
    };
    return judged(grading.suite, test, ending, place, run_again, picture);
}

}  // namespace

std::string key_of(const Grading& grading, const Submission& submission, const TestCase& test) {
    std::string rule = fmt::format("{}\n{}\n{}\n", program_version(), submission.hash, grading.inputs_hash);
    rule += fmt::format("{}\n{}\n{}\n{}\n", name_of(kind_names, test.kind), fmt::join(test.arguments, "\n"),
                        test.expected.empty() ? "" : hash_of_file(test.expected), test.output);
    rule += fmt::format("{} {} {} {} {}\n", test.limits.wall_seconds, test.limits.memory_bytes, test.limits.output_bytes,
                        test.limits.file_bytes, test.limits.processes);
    rule += fmt::format("{} {} {} {}\n", test.fuzz_percent, test.tolerance, test.timed, test.repeats);
    for (const Threshold& threshold : test.pass) rule += fmt::format("{} {}\n", name_of(metric_names, threshold.metric), threshold.at_most);
    rule += fmt::format("{}", name_of(metric_names, test.curve.metric));
    for (const auto& [figure, share] : test.curve.points) rule += fmt::format(" {} {}", figure, share);
    return hash_of(rule);
}

bool has_scene(const Submission& submission, const TestCase& test) {
    std::error_code none;
    return !submission.scenes.empty() && fs::is_regular_file(fs::path(submission.scenes) / test.arguments.at(1), none);
}

void run_test(const Grading& grading, const Submission& submission, const TestCase& test, const GradeStore& store, int slot, bool alone) {
    std::vector<std::pair<Result, std::string>> runs;
    for (int i = 0; i < std::max(test.repeats, 1); ++i) {
        std::string picture;
        Result result = run_once(grading, submission, test, slot, picture);
        runs.emplace_back(std::move(result), std::move(picture));
        if (runs.back().first.outcome != Outcome::passed) break;
    }
    std::stable_sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
        const auto key = [](const Result& r) { return std::pair(r.outcome != Outcome::passed, r.wall_seconds); };
        return key(a.first) < key(b.first);
    });
    const bool failed = runs.back().first.outcome != Outcome::passed;
    auto& [result, picture] = failed ? runs.back() : runs[(runs.size() - 1) / 2];
    if (!failed) result.spread_seconds = runs.back().first.wall_seconds - runs.front().first.wall_seconds;
    result.submission = submission.name, result.alone = alone;
    store.put(key_of(grading, submission, test), result, picture);
}

Result result_without_program(const Submission& submission, const TestCase& test) {
    Result result;
    result.submission = submission.name, result.test = test.name, result.kind = test.kind;
    result.required = test.required, result.weight = test.weight;
    result.outcome = Outcome::not_started, result.reason = submission.problem;
    return result;
}

}  // namespace rt
