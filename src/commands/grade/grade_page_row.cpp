#include "commands/grade/grade_page_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "commands/base/shell_words.h"
#include "core/utf8.h"
#include "grading/result_names.h"
#include "grading/text_alignment.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_of_a_text = 1u << 16, most_of_a_line = 2000;
constexpr std::size_t kept_output = 1u << 14;  ///< as much of what is printed is in a result

Json cells_of(const Result& result) {
    Json cells = {{"name", result.test},
                  {"outcome", name_of(outcome_names, result.outcome)},
                  {"points", {result.weight * result.credit, result.weight}}};
    if (result.figures)
        for (const auto& [name, metric] : metric_names)
            if (std::isfinite((*result.figures)[metric])) cells[std::string(name)] = (*result.figures)[metric];
    if (!result.cause.empty()) cells["cause"] = result.cause;
    cells["time"] = result.wall_seconds;
    if (result.peak_memory_bytes) cells["memory"] = result.peak_memory_bytes;
    return cells;
}

std::string seconds_text(const Result& result) {
    std::string text = fmt::format("{:.3f} s of the clock, {:.3f} s of processors", result.wall_seconds, result.cpu_seconds);
    if (result.spread_seconds > 0.0) text += fmt::format("; its runs are {:.3f} s apart", result.spread_seconds);
    return text + (result.alone ? "; nothing of ours ran beside it" : "");
}

std::string pass_text(const TestCase& test) {
    std::string text;
    for (const Threshold& limit : test.pass)
        text += fmt::format("{}{} at most {:.6g}", text.empty() ? "" : ", ", title_of(limit.metric), limit.at_most);
    return text;
}

std::string region_text(const DifferingRegion& r) {
    return fmt::format("largest of {} pixels in columns {} to {}, rows {} to {} from the top; its inmost pixel is {}, {}", r.pixels, r.x0,
                       r.x1 - 1, r.y0, r.y1 - 1, r.x, r.y);
}

Json facts_of(const Result& result, const TestCase* test) {
    Json facts = Json::array();
    const auto tell = [&](const char* name, std::string text) { facts.push_back({name, std::move(text)}); };
    tell("Counts", fmt::format("{}, {:.6g} of {:.6g} points", result.required ? "required" : "not required", result.weight * result.credit,
                               result.weight));
    if (test && result.kind == TestCase::Kind::picture) tell("Passes with", pass_text(*test));
    if (result.outcome == Outcome::signal)
        tell("Ended by", fmt::format("signal {}", result.status));
    else if (result.outcome != Outcome::not_started && result.outcome != Outcome::not_run)
        tell("Exit status", fmt::format("{}", result.status));
    if (result.left_processes) tell("Processes", "some were still running at its end, and were ended");
    if (result.region) tell("Region", region_text(*result.region));
    tell("Time", seconds_text(result));
    if (result.peak_memory_bytes)
        tell("Memory", fmt::format("{:.1f} MiB at most", static_cast<double>(result.peak_memory_bytes) / (1 << 20)));
    return facts;
}

/// What a shell takes, in the folder "build" beside "resources".
std::string command_of(const Result& result, const TestCase& test) {
    std::string text = shell_word(result.submission);
    for (const std::string& word : test.arguments) text += fmt::format(" {}", shell_word(word));
    return text;
}

Json lines_of(const std::vector<AlignedLine>& lines) {
    Json list = Json::array();
    for (const AlignedLine& line : lines)
        list.push_back({line.expected_number, shortened(line.expected, most_of_a_line), line.actual_number,
                        shortened(line.actual, most_of_a_line), line.differing});
    return list;
}

/// Both texts side by side, of a program that printed something else than what was expected.
void tell_texts(const Result& result, const TestCase* test, Json& data) {
    const double tolerance = test ? test->tolerance : 0.0;
    std::string note = tolerance > 0.0 ? fmt::format("Numbers may be {:g} apart (relative above 1).", tolerance)
                                       : "Compared letter for letter; blank lines and the width of blanks do not matter.";
    std::optional<std::string> expected;
    if (test && !test->expected.empty()) expected = read_file_text(test->expected, 1ull << 32);
    if (!expected || result.text->line > 1 + static_cast<std::size_t>(std::count(result.output.begin(), result.output.end(), '\n'))) {
        // The place is not in what was kept, or there is nothing to lay beside it.
        const TextDifference& d = *result.text;
        const auto number = [](const std::string& line, Json known) { return line.empty() ? Json(0) : std::move(known); };
        data["lines"] = Json::array(
            {Json::array({number(d.expected_line, nullptr), shortened(d.expected_line, most_of_a_line), number(d.actual_line, d.line),
                          shortened(d.actual_line, most_of_a_line), d.field > 0 ? Json::array({d.field}) : Json::array()})});
        note += expected ? " This is the first line that differs; the page has no more of what was printed."
                         : " This is the first line that differs; the expected text is not there.";
    } else {
        if (expected->size() > most_of_a_text || result.output.size() >= kept_output)
            note += fmt::format(" Only the first {} KiB of what was expected and {} KiB of what was printed are here.",
                                most_of_a_text >> 10, kept_output >> 10);
        data["lines"] = lines_of(aligned_lines(whole_characters(*expected, most_of_a_text), result.output, tolerance));
    }
    data["lines_note"] = note;
}

std::vector<ReportPicture> pictures_of(const Result& result, const TestCase* test) {
    if (result.kind == TestCase::Kind::text) return {};
    const ReportPicture actual{"Actual", result.picture, result.reason.empty() ? "it was not kept" : shortened(result.reason, 200)};
    if (result.kind == TestCase::Kind::shown) return {actual};
    return {{"Expected", test ? test->expected : "", "not known here: the grading's tests.json is missing"}, actual};
}

}  // namespace

ReportRow report_row(const Result& result, const TestCase* test) {
    ReportRow row;
    Json& data = row.data;
    data = {{"name", result.test}, {"good", is_good(result.outcome)}, {"cells", cells_of(result)}};
    if (!result.required) data["tag"] = "optional";
    const auto put = [&](const char* name, const std::string& text, std::size_t most) {
        if (!text.empty()) data[name] = shortened(text, most);
    };
    put("reason", result.reason, most_of_a_line);
    put("cause", result.cause, most_of_a_line);
    put("explanation", result.explanation, most_of_a_text);
    if (test) data["command"] = command_of(result, *test);
    put("output", result.output, most_of_a_text);
    if (result.output.size() >= kept_output) data["output_note"] = fmt::format("the first {} KiB of it", kept_output >> 10);
    data["facts"] = facts_of(result, test);
    if (result.text) tell_texts(result, test, data);
    if (const auto& r = result.region)
        data["region"] = {{"box", {r->x0, r->y0, r->x1, r->y1}}, {"pixel", {r->x, r->y}}, {"pixels", r->pixels}};
    row.pictures = pictures_of(result, test);
    return row;
}

}  // namespace rt
