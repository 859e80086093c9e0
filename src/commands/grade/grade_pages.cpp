#include "commands/grade/grade_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>

#include "commands/base/write_bytes.h"
#include "commands/grade/grade_page_row.h"
#include "commands/report/report_page.h"
#include "grading/result_names.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t most_of_a_page = 64ull << 20, least_of_a_page = 4ull << 20, most_of_all = 2048ull << 20;

std::string ratio(int part, int whole) { return fmt::format("{} of {}", part, whole); }

std::vector<std::string> notes_of(const GradeRecord& record, const Summary& sum) {
    std::vector<std::string> notes;
    if (!sum.complete) notes.push_back("The grading was interrupted: not every test was run.");
    for (const std::string& hole : record.holes) notes.push_back("Not contained: " + hole);
    return notes;
}

std::vector<ReportColumn> columns() {
    std::vector<ReportColumn> columns{{"name", "Test", CellKind::text, ""},
                                      {"outcome", "Outcome", CellKind::outcome, ""},
                                      {"points", "Points", CellKind::points, "credit times weight"}};
    constexpr std::array<std::string_view, metrics> titles{"5 %", "1 %", "RMSE", "p99", "FLIP", "3×3"};
    constexpr std::array<std::string_view, metrics> hints{
        "pixels that differ by the suite's fuzz (5 % unless it says otherwise) or more",
        "pixels that differ by 1 % or more",
        "root of the mean squared difference, 1 is full scale",
        "99 % of the pixels differ by no more than that, 1 is full scale",
        "mean LDR-FLIP",
        "mean difference to the most similar of the 3 by 3 pixels around, 1 is full scale"};
    for (const auto& [name, metric] : metric_names) {
        const auto i = static_cast<std::size_t>(metric);
        const bool counts = metric == Metric::differing || metric == Metric::differing_1;
        columns.push_back({std::string(name), std::string(titles[i]), counts ? CellKind::count : CellKind::figure, std::string(hints[i])});
    }
    columns.push_back({"cause", "Cause", CellKind::text, "what the difference looks like"});
    columns.push_back({"time", "Time", CellKind::seconds, "seconds of the clock"});
    columns.push_back({"memory", "Memory", CellKind::bytes, "most that the program had at a time"});
    return columns;
}

ReportPage page_of(const GradeRecord& record, const std::vector<Result>& results, const std::map<std::string, const TestCase*>& tests) {
    const Summary sum = summary_of(results);
    ReportPage page;
    page.title = sum.submission, page.about = record.suite;
    page.facts = {{"Passed", ratio(sum.passed, sum.tests)},
                  {"Required", ratio(sum.required_passed, sum.required)},
                  {"Points", fmt::format("{:.6g} of {:.6g}", sum.points, sum.out_of)},
                  {"Time", fmt::format("{:.1f} s", sum.wall_seconds)}};
    page.notes = notes_of(record, sum);
    page.columns = columns();
    for (const Result& result : results) {
        const auto test = tests.find(result.test);
        page.rows.push_back(report_row(result, test == tests.end() ? nullptr : test->second));
    }
    return page;
}

ReportPage index_of(const GradeRecord& record, const std::vector<std::vector<Result>>& groups) {
    ReportPage page;
    page.title = record.suite, page.about = fmt::format("{} programs", groups.size());
    page.rows_name = "programs";
    page.columns = {{"name", "Program", CellKind::text, ""},
                    {"outcome", "Required", CellKind::outcome, "whether every required test is passed"},
                    {"required", "Required passed", CellKind::points, ""},
                    {"passed", "Passed", CellKind::points, "of all tests"},
                    {"points", "Points", CellKind::points, "credit times weight"},
                    {"time", "Time", CellKind::seconds, "of all tests, seconds of the clock"}};
    Summary all;
    for (const std::vector<Result>& results : groups) {
        const Summary sum = summary_of(results);
        const bool good = sum.complete && sum.required_passed == sum.required;
        all.complete = all.complete && sum.complete, all.passed += good;
        ReportRow row;
        row.data = {{"name", sum.submission},
                    {"good", good},
                    {"href", "reports/" + in_address(report_file_name(sum.submission)) + ".html"},
                    {"cells",
                     {{"name", sum.submission},
                      {"outcome", !sum.complete ? "not complete"
                                  : good        ? "passed"
                                                : "failed"},
                      {"required", {sum.required_passed, sum.required}},
                      {"passed", {sum.passed, sum.tests}},
                      {"points", {sum.points, sum.out_of}},
                      {"time", sum.wall_seconds}}}};
        page.rows.push_back(std::move(row));
    }
    page.facts = {{"All required tests passed", fmt::format("{} of {} programs", all.passed, groups.size())}};
    page.notes = notes_of(record, all);
    return page;
}

/// Nothing is written where the file is the same already.
void write_changed(const fs::path& path, const std::string& text) {
    std::error_code error;
    if (fs::file_size(path, error) == text.size() && !error && read_file_text(path.string(), text.size()) == text) return;
    write_report(path.string(), text);
}

PictureChoice choice_for(std::size_t programs, bool all_pictures) {
    if (all_pictures) return {std::numeric_limits<std::uint64_t>::max(), true, ""};
    const std::uint64_t most = std::clamp(most_of_all / programs, least_of_a_page, most_of_a_page);
    return {most, programs == 1, "left out of this page so that it stays small; with --all-pictures it is here"};
}

}  // namespace

void write_grade_pages(const GradeRecord& record, const std::string& folder, bool all_pictures) {
    const fs::path place(folder);
    const std::vector<std::vector<Result>> groups = by_submission(record.results);
    if (groups.empty()) return;
    std::map<std::string, const TestCase*> tests;
    for (const TestCase& test : record.tests) tests.emplace(test.name, &test);
    const PictureChoice choice = choice_for(groups.size(), all_pictures);
    if (groups.size() == 1) {
        write_changed(place / "report.html", report_page(page_of(record, groups.front(), tests), choice));
        return;
    }
    make_folder((place / "reports").string());
    for (const std::vector<Result>& results : groups) {
        ReportPage page = page_of(record, results, tests);
        page.back_href = "../index.html", page.back = "All programs";
        write_changed(place / "reports" / (report_file_name(results.front().submission) + ".html"), report_page(page, choice));
    }
    write_changed(place / "index.html", report_index(index_of(record, groups)));
}

}  // namespace rt
