// Results for a terminal, and all reports as files.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/base/content_hash.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "commands/grade/grade_pages.h"
#include "commands/grade/grade_reports.h"
#include "core/utf8.h"
#include "grading/result_names.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 200;

/// Names are a folder's and a file's: either may hold anything.
std::string shown(const std::string& name) { return printable(name, longest_name); }

std::string figures_text(const Result& result) {
    if (!result.figures) return {};
    const PictureFigures& f = *result.figures;
    return fmt::format("{:>7.0f} {:>7.0f}  {:.4f}  {:.4f}  {:.4f}  {:.4f}", f[Metric::differing], f[Metric::differing_1], f[Metric::rmse],
                       f[Metric::p99], f[Metric::flip], f[Metric::neighbourhood]);
}

std::string line_of(const Result& result, std::size_t width) {
    const bool good = is_good(result.outcome);
    std::string text = fmt::format("{} {:<{}} {:>8.3f} s  {:<47}", good ? "ok  " : "FAIL", shown(result.test), width, result.wall_seconds,
                                   figures_text(result));
    if (!good) text += fmt::format("  {}", name_of(outcome_names, result.outcome));
    if (!result.cause.empty()) text += fmt::format(": {}", shown(result.cause));
    while (text.ends_with(' ')) text.pop_back();
    if (!result.reason.empty()) text += fmt::format("\n         {}", printable(result.reason, 200));
    return text + "\n";
}

std::string program_table(const std::vector<Result>& results) {
    std::size_t width = 8;
    for (const Result& result : results) width = std::max(width, shown(result.test).size());
    std::string text = fmt::format("     {:<{}} {:>10}  {:>7} {:>7}  {:<6}  {:<6}  {:<6}  {}\n", "test", width, "time", "5 %", "1 %",
                                   "rmse", "p99", "flip", "3x3");
    for (const Result& result : results) text += line_of(result, width);
    const Summary sum = summary_of(results);
    return text + fmt::format("{} of {} passed, {} of {} required; {:.6g} of {:.6g} points; {:.1f} s\n", sum.passed, sum.tests,
                              sum.required_passed, sum.required, sum.points, sum.out_of, sum.wall_seconds);
}

std::string many_table(const std::vector<std::vector<Result>>& groups) {
    std::size_t width = 10;
    for (const auto& results : groups) width = std::max(width, shown(results.front().submission).size());
    std::string text = fmt::format("{:<{}}  {:>9}  {:>9}  {:>15}  {:>9}\n", "submission", width, "passed", "required", "points", "time");
    for (const auto& results : groups) {
        const Summary sum = summary_of(results);
        text += fmt::format("{:<{}}  {:>9}  {:>9}  {:>15}  {:>7.1f} s{}\n", shown(sum.submission), width,
                            fmt::format("{}/{}", sum.passed, sum.tests), fmt::format("{}/{}", sum.required_passed, sum.required),
                            fmt::format("{:.6g}/{:.6g}", sum.points, sum.out_of), sum.wall_seconds, sum.complete ? "" : "  not complete");
    }
    return text;
}

}  // namespace

std::string table_text(const GradeRecord& record) {
    const std::vector<std::vector<Result>> groups = by_submission(record.results);
    if (groups.empty()) return "no tests\n";
    return groups.size() == 1 ? program_table(groups.front()) : many_table(groups);
}

std::string report_file_name(const std::string& submission) {
    constexpr std::size_t longest = 180;  // a file's name may have 255 bytes, with its ending and what is put behind while it is written
    constexpr std::size_t before_hash = longest - 33;
    if (submission.size() <= longest && submission.find('/') == submission.npos) return submission;
    std::string name(whole_characters(submission, before_hash));
    std::replace(name.begin(), name.end(), '/', '_');
    return name + "-" + hash_of(submission);
}

void write_reports(const GradeRecord& record, const std::string& folder, bool all_pictures) {
    const fs::path place(folder);
    write_report((place / "results.json").string(), results_text(record));
    write_report((place / "times.json").string(), times_text(record, folder));
    write_report((place / "tests.json").string(), tests_text(record));
    write_report((place / "results.csv").string(), csv_text(record));
    write_report((place / "junit.xml").string(), junit_text(record));
    const std::vector<std::vector<Result>> groups = by_submission(record.results);
    if (groups.size() == 1) write_report((place / "gradescope.json").string(), gradescope_text(groups.front()));
    if (groups.size() > 1) make_folder((place / "gradescope").string());
    for (std::size_t i = 0; i < groups.size() && groups.size() > 1; ++i)
        write_report((place / "gradescope" / (report_file_name(groups[i].front().submission) + ".json")).string(),
                     gradescope_text(groups[i]));
    write_grade_pages(record, folder, all_pictures);
}

}  // namespace rt
