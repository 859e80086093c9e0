#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "commands/grade_reports.h"
#include "commands/result_json.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* results_format = "raytrace results 1";
constexpr const char* times_format = "raytrace times 1";
constexpr std::size_t most_bytes = 1ull << 32;

Sources read(const fs::path& path) {
    std::optional<std::string> text = read_file_text(path.string(), most_bytes);
    if (!text) throw OptionError(fmt::format("cannot read '{}'", path.string()));
    Sources sources;
    sources.add({path.string(), std::move(*text)});
    return sources;
}

void expect_format(const JsonValue& value, const char* format) {
    if (value["format"].word() != format) value["format"].fail(fmt::format("\"{}\"", format));
}

/// A head, and a list with one entry a line.
std::string listing(const Json& head, const char* list, const std::vector<Json>& entries) {
    std::string text = "{";
    for (const auto& [name, value] : head.items())
        text += fmt::format("\n \"{}\": {},", name, value.dump(-1, ' ', false, Json::error_handler_t::replace));
    text += fmt::format("\n \"{}\": [", list);
    for (std::size_t i = 0; i < entries.size(); ++i)
        text += fmt::format("{}\n  {}", i ? "," : "", entries[i].dump(-1, ' ', false, Json::error_handler_t::replace));
    return text + "\n ]\n}\n";
}

}  // namespace

std::string results_text(const GradeRecord& record) {
    std::vector<Json> entries;
    for (const Result& result : record.results) entries.push_back(result_json(result));
    return listing({{"format", results_format},
                    {"suite", record.suite},
                    {"holes", record.holes},
                    {"shard", {record.shard.index + 1, record.shard.of}}},
                   "results", entries);
}

std::string times_text(const GradeRecord& record) {
    std::vector<Json> entries;
    for (const Result& result : record.results) {
        Json entry = {{"submission", result.submission}, {"test", result.test}};
        entry.update(times_json(result));
        entries.push_back(std::move(entry));
    }
    return listing({{"format", times_format}, {"suite", record.suite}}, "times", entries);
}

GradeRecord read_record(const std::string& folder) {
    const Sources results_file = read(fs::path(folder) / "results.json"), times_file = read(fs::path(folder) / "times.json");
    const nlohmann::json results_content = parse_json(results_file), times_content = parse_json(times_file);
    const JsonValue results(results_file, results_content), times(times_file, times_content);
    expect_format(results, results_format), expect_format(times, times_format);
    GradeRecord record{results["suite"].word(), {}, {}, {}};
    record.shard = {results["shard"].item(0).count() - 1, results["shard"].item(1).count()};
    for (std::size_t i = 0; i < results["holes"].size(); ++i) record.holes.push_back(results["holes"].item(i).word());
    const JsonValue list = results["results"], time_list = times["times"];
    for (std::size_t i = 0; i < list.size(); ++i) {
        record.results.push_back(result_of_json(list.item(i)));
        Result& result = record.results.back();
        if (i >= time_list.size() || time_list.item(i)["submission"].word() != result.submission ||
            time_list.item(i)["test"].word() != result.test)
            list.item(i).fail("a result with its times in times.json, in the same order");
        read_times(time_list.item(i), result);
    }
    return record;
}

}  // namespace rt
