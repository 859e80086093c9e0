#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "commands/base/values.h"
#include "commands/grade/grade_reports.h"
#include "commands/report/result_json.h"
#include "grading/result_names.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* results_format = "raytrace results 1";
constexpr const char* times_format = "raytrace times 1";
constexpr const char* tests_format = "raytrace tests 1";
constexpr std::size_t most_record_bytes = 1ull << 32;

Sources read(const fs::path& path) {
    std::optional<std::string> text = read_file_text(path.string(), most_record_bytes);
    if (!text) throw OptionError(fmt::format("cannot read '{}'", printable(path.string())));
    Sources sources;
    sources.add({path.string(), std::move(*text)});
    return sources;
}

void expect_format(const JsonValue& value, const char* format) {
    if (value["format"].word() != format) value["format"].fail(fmt::format("\"{}\"", format));
}

Json test_json(const TestCase& test) {
    Json pass = Json::array();
    for (const Threshold& limit : test.pass) pass.push_back({{"metric", name_of(metric_names, limit.metric)}, {"at_most", limit.at_most}});
    return {{"name", test.name},         {"command", test.arguments},   {"expected", test.expected},
            {"fuzz", test.fuzz_percent}, {"tolerance", test.tolerance}, {"pass", std::move(pass)}};
}

Shard shard_of(const JsonValue& value) {
    if (value.size() != 2) value.fail("a shard's number and how many there are");
    const std::size_t number = value.item(0).count(), of = value.item(1).count();
    if (number < 1 || number > of) value.fail("a shard's number, from 1 to how many there are");
    return {number - 1, of};
}

TestCase test_of(const JsonValue& value) {
    TestCase test;
    test.name = value["name"].word(), test.expected = value["expected"].word();
    for (std::size_t i = 0; i < value["command"].size(); ++i) test.arguments.push_back(value["command"].item(i).word());
    test.fuzz_percent = value["fuzz"].number(), test.tolerance = value["tolerance"].number();
    test.pass.clear();
    for (std::size_t i = 0; i < value["pass"].size(); ++i) {
        const JsonValue limit = value["pass"].item(i);
        test.pass.push_back({limit["metric"].name(metric_names, "figure"), limit["at_most"].number()});
    }
    return test;
}

/// Of a folder that older gradings have written there is none.
std::vector<TestCase> read_tests(const fs::path& path) {
    std::error_code none;
    std::vector<TestCase> tests;
    if (!fs::exists(path, none)) return tests;
    const Sources file = read(path);
    const nlohmann::json content = parse_json(file);
    const JsonValue value(file, content);
    expect_format(value, tests_format);
    for (std::size_t i = 0; i < value["tests"].size(); ++i) tests.push_back(test_of(value["tests"].item(i)));
    return tests;
}

}  // namespace

std::string results_text(const GradeRecord& record) {
    std::vector<Json> entries;
    for (const Result& result : record.results) entries.push_back(result_json(result));
    return json_listing({{"format", results_format},
                         {"suite", record.suite},
                         {"holes", record.holes},
                         {"shard", {record.shard.index + 1, record.shard.of}}},
                        "results", entries);
}

std::string times_text(const GradeRecord& record, const std::string& folder) {
    std::vector<Json> entries;
    for (const Result& result : record.results) {
        Json entry = {{"submission", result.submission}, {"test", result.test}};
        entry.update(times_json(result));
        if (!result.picture.empty()) entry["picture"] = fs::path(result.picture).lexically_proximate(folder).string();
        entries.push_back(std::move(entry));
    }
    return json_listing({{"format", times_format}, {"suite", record.suite}}, "times", entries);
}

std::string tests_text(const GradeRecord& record) {
    std::vector<Json> entries;
    for (const TestCase& test : record.tests) entries.push_back(test_json(test));
    return json_listing({{"format", tests_format}, {"suite", record.suite}}, "tests", entries);
}

GradeRecord read_record(const std::string& folder) {
    const Sources results_file = read(fs::path(folder) / "results.json"), times_file = read(fs::path(folder) / "times.json");
    const nlohmann::json results_content = parse_json(results_file), times_content = parse_json(times_file);
    const JsonValue results(results_file, results_content), times(times_file, times_content);
    expect_format(results, results_format), expect_format(times, times_format);
    GradeRecord record{results["suite"].word(), {}, {}, {}, {}};
    record.shard = shard_of(results["shard"]);
    for (std::size_t i = 0; i < results["holes"].size(); ++i) record.holes.push_back(results["holes"].item(i).word());
    const JsonValue list = results["results"], time_list = times["times"];
    for (std::size_t i = 0; i < list.size(); ++i) {
        record.results.push_back(result_of_json(list.item(i)));
        Result& result = record.results.back();
        if (i >= time_list.size() || time_list.item(i)["submission"].word() != result.submission ||
            time_list.item(i)["test"].word() != result.test)
            list.item(i).fail("a result with its times in times.json, in the same order");
        read_times(time_list.item(i), result);
        if (time_list.item(i).has("picture")) result.picture = (fs::path(folder) / time_list.item(i)["picture"].word()).string();
    }
    record.tests = read_tests(fs::path(folder) / "tests.json");
    return record;
}

}  // namespace rt
