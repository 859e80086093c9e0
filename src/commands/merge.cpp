// raytrace merge: the shards of one grading as one.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/grade_reports.h"
#include "commands/help.h"
#include "commands/text.h"
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
                                          of, shards.front().suite, shard.shard.index + 1, shard.shard.of, shard.suite));
        if (i < shards.size() && shard.shard.index < i)
            throw OptionError(fmt::format("merge: shard {}/{} is given twice", shard.shard.index + 1, of));
        if (i >= shards.size() || shard.shard.index > i) throw OptionError(fmt::format("merge: shard {}/{} is missing", i + 1, of));
    }
    return shards;
}

/// Shards hold every N-th test of one list: dealing one card from each in turn gives the list again.
GradeRecord joined(const std::vector<GradeRecord>& shards) {
    GradeRecord whole{shards.front().suite, {}, {}, {}, shards.front().tests};
    for (const GradeRecord& shard : shards)
        for (const std::string& hole : shard.holes)
            if (std::find(whole.holes.begin(), whole.holes.end(), hole) == whole.holes.end()) whole.holes.push_back(hole);
    for (std::size_t i = 0; i < shards.front().results.size(); ++i)
        for (const GradeRecord& shard : shards)
            if (i < shard.results.size()) whole.results.push_back(shard.results[i]);
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
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw OutputError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
    write_reports(whole, fs::canonical(folder).string(), all_pictures);
    if (!quiet) write_stdout(table_text(whole));
    return 0;
}

}  // namespace rt
