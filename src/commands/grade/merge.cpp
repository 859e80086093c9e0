// raytrace merge: the shards of one grading as one.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/base/command_line.h"
#include "commands/base/interrupt.h"
#include "commands/base/program.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "commands/commands.h"
#include "commands/grade/grade_reports.h"
#include "commands/help.h"
#include "core/source.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// In the order of their numbers. Throws OptionError if they are not all the shards of one grading.
std::vector<GradeRecord> in_order(std::vector<GradeRecord> shards) {
    std::sort(shards.begin(), shards.end(), [](const GradeRecord& a, const GradeRecord& b) { return a.shard.index < b.shard.index; });
    const std::size_t of = shards.front().shard.of;
    for (std::size_t i = 0; i < std::max(of, shards.size()); ++i) {
        const GradeRecord& shard = shards[std::min(i, shards.size() - 1)];
        if (shard.shard.of != of || shard.suite != shards.front().suite)
            throw OptionError(fmt::format("merge: parts of two gradings: {}/{} of '{}' and {}/{} of '{}'", shards.front().shard.index + 1,
                                          of, printable(shards.front().suite), shard.shard.index + 1, shard.shard.of,
                                          printable(shard.suite)));
        if (i < shards.size() && shard.shard.index < i)
            throw OptionError(fmt::format("merge: shard {}/{} is given twice", shard.shard.index + 1, of));
        if (i >= shards.size() || shard.shard.index > i) throw OptionError(fmt::format("merge: shard {}/{} is missing", i + 1, of));
    }
    return shards;
}

std::string number_of(const GradeRecord& record) { return fmt::format("{}/{}", record.shard.index + 1, record.shard.of); }

/// Where the expected files lie may differ: shards may be of several machines.
bool same_test(const TestCase& a, const TestCase& b) {
    return a.name == b.name && a.arguments == b.arguments && a.fuzz_percent == b.fuzz_percent && a.tolerance == b.tolerance &&
           a.pass == b.pass;
}

void expect_same_tests(const GradeRecord& a, const GradeRecord& b) {
    const auto told = [&](const std::string& what) {
        return OptionError(fmt::format("merge: shards {} and {} have other tests: {}", number_of(a), number_of(b), what));
    };
    if (a.tests.size() != b.tests.size()) throw told(fmt::format("{} and {}", a.tests.size(), b.tests.size()));
    for (std::size_t i = 0; i < a.tests.size(); ++i)
        if (!same_test(a.tests[i], b.tests[i]))
            throw told(fmt::format("number {} is '{}' and '{}', or judged otherwise", i + 1, printable(a.tests[i].name),
                                   printable(b.tests[i].name)));
}

/// Dealing L results to N shards gives shard i, from 0, ceil((L - i) / N) of them.
void expect_sizes(const std::vector<GradeRecord>& shards) {
    std::size_t all = 0;
    for (const GradeRecord& shard : shards) all += shard.results.size();
    for (const GradeRecord& shard : shards) {
        const std::size_t due = (all + shards.size() - 1 - shard.shard.index) / shards.size();
        if (shard.results.size() != due)
            throw OptionError(fmt::format("merge: of the {} results of these {} shards, shard {} should hold {}, and holds {}", all,
                                          shards.size(), number_of(shard), due, shard.results.size()));
    }
}

/// Each program has each test once, in the suite's order; only a picture that is shown may be missing, where it has no scene.
void expect_complete(const GradeRecord& whole) {
    for (const std::vector<Result>& results : by_submission(whole.results)) {
        const std::string program = printable(results.front().submission);
        auto next = results.begin();
        for (const TestCase& test : whole.tests) {
            if (next != results.end() && next->test == test.name)
                ++next;
            else if (!test.expected.empty())
                throw OptionError(fmt::format("merge: '{}' has no result of test '{}' in its place: shards of other programs?", program,
                                              printable(test.name)));
        }
        if (next != results.end())
            throw OptionError(
                fmt::format("merge: '{}' has a result of test '{}' where none or another is expected", program, printable(next->test)));
    }
}

/// Shards hold every N-th test of one list: dealing one card from each in turn gives the list again. Throws OptionError if it does not.
GradeRecord joined(const std::vector<GradeRecord>& shards) {
    for (const GradeRecord& shard : shards) expect_same_tests(shards.front(), shard);
    expect_sizes(shards);
    GradeRecord whole{shards.front().suite, {}, {}, {}, shards.front().tests};
    for (const GradeRecord& shard : shards)
        for (const std::string& hole : shard.holes)
            if (std::find(whole.holes.begin(), whole.holes.end(), hole) == whole.holes.end()) whole.holes.push_back(hole);
    for (std::size_t i = 0; i < shards.front().results.size(); ++i)
        for (const GradeRecord& shard : shards)
            if (i < shard.results.size()) whole.results.push_back(shard.results[i]);
    if (shards.size() > 1 && !whole.tests.empty()) expect_complete(whole);
    return whole;
}

}  // namespace

int run_merge(const Words& words) {
    std::string folder = "grade-results";
    bool quiet = false, all_pictures = false;
    CommandLine line(merge_usage, merge_footer);
    line.value("-o,--output", "DIR", "where the reports go (grade-results)", [&](const std::string& v) { folder = v; });
    line.flag("--all-pictures", "pages with every picture, however large", [&] { all_pictures = true; });
    line.flag("-q,--quiet", "no table", [&] { quiet = true; });
    const Words folders = line.parse(with_two_dashes(words, line));
    if (line.help_asked()) {
        write_stdout(line.help());
        return 0;
    }
    if (folders.empty())
        throw OptionError("merge: expected the output folders of shards, in the order of their numbers; see raytrace merge --help");
    std::vector<GradeRecord> shards;
    for (const std::string& path : folders) shards.push_back(read_record(fs::absolute(path).string()));
    const GradeRecord whole = joined(in_order(std::move(shards)));
    make_folder(folder);
    write_reports(whole, fs::canonical(folder).string(), all_pictures);
    if (!quiet) write_stdout(table_text(whole));
    const bool complete =
        std::none_of(whole.results.begin(), whole.results.end(), [](const Result& r) { return r.outcome == Outcome::not_run; });
    return complete ? 0 : exit_interrupted;
}

}  // namespace rt
