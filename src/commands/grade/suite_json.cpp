#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "commands/base/json_value.h"
#include "commands/base/values.h"
#include "commands/grade/suite_file.h"
#include "grading/result_names.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr double most_seconds = 86400.0;
constexpr double most_mebibytes = 1048576.0;

std::uint64_t bytes_of(const JsonValue& value, double unit) {
    return static_cast<std::uint64_t>(value.number_in(1.0 / unit, most_mebibytes) * unit);
}

void read_limits(const JsonValue& value, Limits& limits) {
    constexpr double kibi = 1024.0, mebi = kibi * kibi;
    if (value.has("timeout")) limits.wall_seconds = value["timeout"].number_in(0.01, most_seconds);
    if (value.has("memory")) limits.memory_bytes = bytes_of(value["memory"], mebi);
    if (value.has("printed")) limits.output_bytes = bytes_of(value["printed"], kibi);
    if (value.has("file")) limits.file_bytes = bytes_of(value["file"], mebi);
    if (value.has("processes")) limits.processes = static_cast<int>(value["processes"].number_in(1, 65536));
}

CreditCurve credit_of(const JsonValue& value) {
    value.expect_only({"metric", "curve"});
    CreditCurve curve{value["metric"].name(metric_names, "metric"), {}};
    const JsonValue points = value["curve"];
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points.item(i).size() != 2) points.item(i).fail("a figure and its credit");
        const double figure = points.item(i).item(0).number_in(0.0, 1e12);
        if (i > 0 && figure <= curve.points.back().first) points.item(i).fail("a figure above the one before");
        curve.points.push_back({figure, points.item(i).item(1).number_in(0.0, 1.0)});
    }
    if (curve.points.empty()) points.fail("at least one point");
    return curve;
}

/// What `defaults` and a test have in common.
void read_rule(const JsonValue& value, TestCase& test) {
    read_limits(value, test.limits);
    if (value.has("kind")) test.kind = value["kind"].name(kind_names, "kind of test: text, picture or shown");
    if (value.has("output")) test.output = value["output"].word();
    if (value.has("required")) test.required = value["required"].truth();
    if (value.has("weight")) test.weight = value["weight"].number_in(0.0, 1e6);
    if (value.has("timed")) test.timed = value["timed"].truth();
    if (value.has("repeats")) test.repeats = static_cast<int>(value["repeats"].number_in(1, 1000));
    if (value.has("fuzz")) test.fuzz_percent = value["fuzz"].number_in(0.0, 100.0);
    if (value.has("tolerance")) test.tolerance = value["tolerance"].number_in(0.0, 1.0);
    if (value.has("credit")) test.curve = credit_of(value["credit"]);
    if (value.has("pass")) {
        const JsonValue pass = value["pass"];
        test.pass.clear();
        for (std::size_t i = 0; i < pass.size(); ++i) {
            pass.item(i).expect_only({"metric", "at_most"});
            test.pass.push_back({pass.item(i)["metric"].name(metric_names, "metric"), pass.item(i)["at_most"].number_in(0.0, 1e12)});
        }
        if (test.pass.empty()) pass.fail("at least one threshold");
    }
}

std::vector<std::string> words_of(const JsonValue& command) {
    std::vector<std::string> words;
    if (command.is_word()) {
        for (const std::string& word : split(command.word(), ' '))
            if (!word.empty()) words.push_back(word);
    } else {
        for (std::size_t i = 0; i < command.size(); ++i) words.push_back(command.item(i).word());
    }
    return words;
}

/// A name that can be one of a file in `folder`.
std::string existing(const JsonValue& value, const fs::path& folder) {
    const fs::path path = folder / value.word();
    std::error_code none;
    if (!fs::exists(path, none)) value.fail("an existing file or folder");
    return fs::absolute(path).lexically_normal().string();
}

TestCase test_of(const JsonValue& value, TestCase test, const fs::path& folder) {
    value.expect_only({"name", "kind", "command", "expected", "output", "required", "weight", "timeout", "memory", "printed", "file",
                       "processes", "timed", "repeats", "fuzz", "pass", "credit", "tolerance"});
    test.name = value["name"].word();
    if (test.name.empty()) value["name"].fail("a name");
    read_rule(value, test);
    if (value.has("output") && (test.output.empty() || test.output.find('/') != std::string::npos))
        value["output"].fail("a file's name without a folder");
    if (test.repeats > 1) test.timed = true;  // a median of times that others disturbed says nothing
    test.arguments = words_of(value["command"]);
    const bool scene_of_ones_own = test.arguments.size() > 1 && test.arguments[1].find('/') == std::string::npos;
    if (test.kind == TestCase::Kind::shown && !scene_of_ones_own)
        value["command"].fail("a command whose second word is the name of the author's own scene, without a folder");
    if (test.kind != TestCase::Kind::shown) test.expected = existing(value["expected"], folder);
    return test;
}

}  // namespace

Suite suite_of_json(const Sources& sources, const std::string& inputs) {
    const nlohmann::json content = parse_json(sources);
    const JsonValue value(sources, content);
    value.expect_only({"format", "name", "inputs", "defaults", "tests"});
    if (value["format"].word() != "raytrace suite 1") value["format"].fail("\"raytrace suite 1\"");
    const fs::path file = fs::absolute(sources.file(0).name), folder = file.parent_path();
    Suite suite{value.has("name") ? value["name"].word() : file.stem().string(), folder.lexically_normal().string(), inputs, {}};
    if (inputs.empty()) suite.inputs = value.has("inputs") ? existing(value["inputs"], folder) : suite.folder;
    TestCase defaults;
    if (value.has("defaults")) {
        value["defaults"].expect_only({"kind", "output", "required", "weight", "timeout", "memory", "printed", "file", "processes", "timed",
                                       "repeats", "fuzz", "pass", "credit", "tolerance"});
        read_rule(value["defaults"], defaults);
    }
    const JsonValue tests = value["tests"];
    std::set<std::string> names;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        suite.tests.push_back(test_of(tests.item(i), defaults, folder));
        if (!names.insert(suite.tests.back().name).second) tests.item(i)["name"].fail("a name that no other test has");
    }
    if (suite.tests.empty()) tests.fail("at least one test");
    return suite;
}

}  // namespace rt
