#include "commands/grade/grade_test.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "commands/base/content_hash.h"
#include "commands/base/program.h"
#include "commands/base/run_place.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "commands/causes/wrong_answer.h"
#include "commands/report/result_json.h"
#include "core/source.h"
#include "core/utf8.h"
#include "grading/judge.h"
#include "grading/result_names.h"
#include "grading/run_folder.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// The scene of a test that is only shown, if its author has one: a file of their own, not a link to somebody else's.
TakenFile own_scene(const Submission& submission, const TestCase& test) {
    constexpr std::uint64_t most_bytes = 1u << 26;
    const bool named = !submission.scenes.empty() && test.arguments.size() > 1;
    return named ? take_file(submission.scenes, test.arguments[1], most_bytes) : TakenFile{std::nullopt, true, ""};
}

/// A program's own folder, as the course's graders lay it out: it runs in "build", the scenes are in "resources" beside it and in it.
class RunFolder {
public:
    RunFolder(const Grading& grading, const Submission& submission, const TestCase& test) {
        const fs::path folder = place_.folder();
        make_folder(folder / "build");
        for (const fs::path& link : {folder / "resources", folder / "build" / "resources"}) {
            std::error_code error;
            fs::create_directory_symlink(grading.suite.inputs, link, error);
            if (error) throw OutputError(fmt::format("cannot make the link '{}': {}", link.string(), error.message()));
        }
        if (test.kind != TestCase::Kind::shown) return;
        const TakenFile scene = own_scene(submission, test);
        if (!scene.bytes) throw OptionError(scene.problem);
        write_bytes((folder / "build" / test.arguments[1]).string(), *scene.bytes);
    }

    std::string folder() const { return place_.folder(); }
    std::string working_folder() const { return (fs::path(place_.folder()) / "build").string(); }

private:
    RunPlace place_;
};

bool is_within(const fs::path& path, const fs::path& folder) { return *path.lexically_relative(folder).begin() != ".."; }

/// Where the right answers are: their folders, but where something that is shown lies in the same one the answers themselves. And the
/// results, unless the program was built among them: of those it is shown its own alone anyway.
std::vector<std::string> hidden_places(const Grading& grading, const std::vector<std::string>& shown) {
    const auto holds_shown = [&](const fs::path& folder) {
        return std::any_of(shown.begin(), shown.end(), [&](const std::string& path) { return is_within(path, folder); });
    };
    std::set<std::string> places;
    for (const TestCase& test : grading.suite.tests) {
        if (test.expected.empty()) continue;
        const fs::path folder = fs::path(test.expected).parent_path();
        places.insert(holds_shown(folder) ? test.expected : folder.string());
    }
    if (!holds_shown(grading.folder)) places.insert(grading.folder);
    return {places.begin(), places.end()};
}

ContainedRun contained_run(const Grading& grading, const Submission& submission, const TestCase& test, const RunFolder& place) {
    ContainedRun run;
    run.command = {submission.program};
    run.command.insert(run.command.end(), test.arguments.begin(), test.arguments.end());
    run.folder = place.folder(), run.working_folder = place.working_folder();
    run.readable = {submission.program, grading.suite.inputs};
    if (!submission.visible.empty()) run.readable.push_back(submission.visible);
    run.readable.insert(run.readable.end(), grading.readable.begin(), grading.readable.end());
    run.hidden = hidden_places(grading, run.readable);
    return run;
}

/// Width and height that a PNG says it has; 0 if it is none.
std::pair<int, int> png_size(std::string_view bytes) {
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    constexpr std::size_t at = 16;  // behind the signature and the head of the first chunk
    if (!bytes.starts_with(signature) || bytes.size() < at + 8) return {0, 0};
    const auto number = [&](std::size_t from) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[from + i]);
        return static_cast<int>(std::min(value, 0x7fffffffu));
    };
    return {number(at), number(at + 4)};
}

/// Pixels that are worth decoding for a person to see.
constexpr double most_pixels = 64e6;

/// The picture a program left, and its bytes as they were. It is decoded from a copy that the program never had near it: its own folder
/// may hold anything, links to other files for instance. A PNG of another size than `expected`'s is not decoded, whatever memory it asks
/// for.
Written take_picture(const RunFolder& place, const TestCase& test, const StoredImage* expected, std::string& bytes) {
    Written written;
    const TakenFile taken = take_file(place.working_folder(), test.output, test.limits.file_bytes);
    if (taken.missing) return written;
    written.state = Written::State::unreadable;
    written.reason = taken.problem;
    if (!taken.bytes) return written;
    const auto [width, height] = png_size(*taken.bytes);
    if (static_cast<double>(width) * height > most_pixels) {
        written.reason = fmt::format("{} is of {} x {} pixels", test.output, width, height);
        return written;
    }
    if (expected && width > 0 && (width != expected->width || height != expected->height)) {
        written.state = Written::State::picture;
        written.image.width = width, written.image.height = height;
        bytes = *taken.bytes;
        return written;
    }
    try {
        const RunPlace copy;
        const std::string path = (fs::path(copy.folder()) / fmt::format("taken{}", fs::path(test.output).extension().string())).string();
        write_bytes(path, *taken.bytes);
        written.image = read_image(path);
        written.state = Written::State::picture;
        bytes = *taken.bytes;
    } catch (const OptionError& error) {
        written.reason = fmt::format("{} is no picture", test.output);
    }
    return written;
}

/// Of all tests together: a picture may be another test's.
std::string hash_of_answers(const std::map<std::string, std::string>& rule_hashes) {
    std::string all;
    for (const auto& [name, hash] : rule_hashes) all += fmt::format("{}\n{}\n", hash, name);
    return hash_of(all);
}

/// Of its pixels: files of one picture may differ, by the time that stands in them for instance.
std::string hash_of_picture(const StoredImage& image) {
    const std::string_view values(reinterpret_cast<const char*>(image.values.data()), image.values.size() * sizeof image.values[0]);
    return hash_of(fmt::format("{} {} {} {}", image.width, image.height, image.channels, image.max_value) + hash_of(values));
}

/// One run of a program by a test, and what is said of it.
class TestRun {
public:
    TestRun(const Grading& grading, const Submission& submission, const TestCase& test, const GradeStore& store, int slot)
        : grading_(grading),
          test_(test),
          store_(store),
          slot_(slot),
          place_(grading, submission, test),
          run_(contained_run(grading, submission, test, place_)) {}

    /// The bytes of the picture that it wrote, if any, go to `picture`.
    Result result(std::string& picture) const {
        const Ending ending = run_contained(run_, test_.limits, grading_.containment, slot_);
        Result result = judged(ending, picture);
        if (!is_good(result.outcome)) expect_room_for(ending);
        constexpr std::size_t longest_explanation = 1u << 16;  // it may quote what the program printed
        result.explanation = shortened(result.explanation, longest_explanation);
        return result;
    }

private:
    /// What failed on a full disk says nothing.
    void expect_room_for(const Ending& ending) const {
        if (ending.least_room_bytes < least_room)
            throw OutputError(fmt::format("the disk of '{}' was full, or nearly so, during a run that failed", place_.folder()));
    }

    Result judged(const Ending& ending, std::string& picture) const {
        if (test_.kind == TestCase::Kind::text) {
            const std::optional<std::string> expected = read_file_text(test_.expected, test_.limits.file_bytes);
            if (!expected) throw OptionError(fmt::format("cannot read '{}'", printable(test_.expected)));
            Result result = judge_text(test_, ending, *expected);
            if (result.outcome == Outcome::wrong_answer) explain_text(*expected, ending.output, result);
            return result;
        }
        if (test_.kind == TestCase::Kind::shown) return judge_shown(test_, ending, take_picture(place_, test_, nullptr, picture));
        const StoredImage expected = read_image(test_.expected);
        const Written written = take_picture(place_, test_, &expected, picture);
        Result result = judge_picture(test_, ending, written, expected);
        if (result.outcome == Outcome::wrong_answer) explain(expected, written.image, result);
        return result;
    }

    /// What was said of the same picture before is taken, whatever program wrote it.
    void explain(const StoredImage& expected, const StoredImage& actual, Result& result) const {
        // Before anything is traced: what runs programs has one thread.
        const std::string printed = rays_told(test_, result, [&](const auto& words) { return printed_for(words); });
        const std::string& rule = grading_.rule_hashes.at(test_.name);
        const std::string content = fmt::format("{}\n{}\n{}\n{}\n{}", grading_.common_hash, rule, hash_of_answers(grading_.rule_hashes),
                                                hash_of_picture(actual), hash_of(printed));
        const std::string key = "cause-" + hash_of(content);
        if (!grading_.fresh && store_.find_cause(key, result)) return;
        explain_picture(grading_.suite, test_, expected, actual, printed, result);
        store_.put_cause(key, result);
    }

    std::string printed_for(const std::vector<std::string>& words) const {
        ContainedRun again = run_;
        again.command.resize(1);
        again.command.insert(again.command.end(), words.begin(), words.end());
        Limits limits = test_.limits;
        limits.wall_seconds = std::min(limits.wall_seconds, 10.0);
        const Ending ending = run_contained(again, limits, grading_.containment, slot_);
        if (ending.kind == Ending::Kind::exited && ending.status == 0) return ending.output;
        expect_room_for(ending);
        return {};
    }

    const Grading& grading_;
    const TestCase& test_;
    const GradeStore& store_;
    int slot_;
    RunFolder place_;
    ContainedRun run_;
};

/// Of everything that a test says, its right answer among it.
std::string rule_hash_of(const TestCase& test) {
    std::string rule = fmt::format("{}\n{}\n{}\n{}\n", name_of(kind_names, test.kind), fmt::join(test.arguments, "\n"),
                                   test.expected.empty() ? "" : hash_of_file(test.expected), test.output);
    rule += fmt::format("{} {} {} {} {}\n", test.limits.wall_seconds, test.limits.memory_bytes, test.limits.output_bytes,
                        test.limits.file_bytes, test.limits.processes);
    rule += fmt::format("{} {} {} {}\n", test.fuzz_percent, test.tolerance, test.timed, test.repeats);
    for (const Threshold& threshold : test.pass) rule += fmt::format("{} {}\n", name_of(metric_names, threshold.metric), threshold.at_most);
    rule += fmt::format("{}", name_of(metric_names, test.curve.metric));
    for (const auto& [figure, share] : test.curve.points) rule += fmt::format(" {} {}", figure, share);
    return hash_of(rule);
}

}  // namespace

std::string common_hash_of(const Grading& grading) {
    static const std::string judge = hash_of_file("/proc/self/exe");
    std::string all = fmt::format("{}\n{}\n{}\n", program_version(), judge, hash_of_folder(grading.suite.inputs));
    for (const std::string& path : grading.readable) all += fmt::format("{}\n{}\n{}\n", path, hash_of_file(path), hash_of_folder(path));
    const Containment& c = grading.containment;
    return hash_of(all + fmt::format("{} {} {} {}", !c.bubblewrap.empty(), !c.memory_group.empty(), !c.pids_group.empty(), c.own_user));
}

std::map<std::string, std::string> rule_hashes_of(const Suite& suite) {
    std::map<std::string, std::string> hashes;
    for (const TestCase& test : suite.tests) hashes[test.name] = rule_hash_of(test);
    return hashes;
}

std::string key_of(const Grading& grading, const Submission& submission, const TestCase& test) {
    std::string all = fmt::format("{}\n{}\n{}\n", submission.hash, grading.common_hash, grading.rule_hashes.at(test.name));
    if (test.kind == TestCase::Kind::shown) all += hash_of(own_scene(submission, test).bytes.value_or(""));
    return hash_of(all);
}

bool has_scene(const Submission& submission, const TestCase& test) { return own_scene(submission, test).bytes.has_value(); }

bool may_have_waited(double cpu_seconds, double wall_seconds, int busy_threads) {
    const double processors = static_cast<double>(std::max(1l, sysconf(_SC_NPROCESSORS_ONLN)));
    const double wanted = std::clamp(static_cast<double>(busy_threads), 1.0, processors);
    const double share = cpu_seconds / wall_seconds;
    return share > 0.02 && share < 0.9 * wanted;
}

void run_test(const Grading& grading, const Submission& submission, const TestCase& test, const GradeStore& store, int slot,
              Turn::Kind kind) {
    const Turn turn(grading.turns, kind);
    // The median run of a timed test stands for all of them, unless one fails.
    std::vector<std::pair<Result, std::string>> runs;
    for (int i = 0; i < std::max(test.repeats, 1); ++i) {
        std::string picture;
        Result result = TestRun(grading, submission, test, store, slot).result(picture);
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
    result.submission = submission.name, result.alone = turn.was_alone();
    store.put(key_of(grading, submission, test), result, picture);
}

Result result_without_program(const Submission& submission, const TestCase& test) {
    Result result;
    result.submission = submission.name, result.test = test.name, result.kind = test.kind;
    result.required = test.required, result.weight = test.weight;
    result.outcome = submission.without_program, result.reason = submission.problem;
    return result;
}

}  // namespace rt
