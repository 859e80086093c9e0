// What a grading writes: the same results give the same bytes in every file.
#pragma once

#include <string>
#include <vector>

#include "commands/grade/grade_run.h"
#include "grading/summary.h"

namespace rt {

/// A grading's results as a file of ours: what reports are made from, and what `merge` joins.
struct GradeRecord {
    std::string suite;
    std::vector<std::string> holes;  ///< what could not be contained
    Shard shard;
    std::vector<Result> results;
    std::vector<TestCase> tests{};  ///< what the suite asks, as far as pages show it
};

/// {format, suite, holes, shard, results}, without times; and the times, one entry for each result, with where its picture is, seen from
/// `folder`.
std::string results_text(const GradeRecord& record);
std::string times_text(const GradeRecord& record, const std::string& folder);
/// {format, suite, tests}: of each test its name, command, expected file, fuzz, tolerance and limits for a pass.
std::string tests_text(const GradeRecord& record);
/// Reads results.json, times.json and, if it is there, tests.json of a folder. Throws OptionError or SceneError.
GradeRecord read_record(const std::string& folder);

/// One line a result: submission, test, kind, required, outcome, credit, weight, every figure, cause, reason, seconds, memory.
std::string csv_text(const GradeRecord& record);
/// Elements and attributes that all readers of JUnit's reports share: a suite a program, failures for wrong answers, errors for the rest.
std::string junit_text(const GradeRecord& record);
/// What Gradescope's autograder takes as results.json: one program's results.
std::string gradescope_text(const std::vector<Result>& results);
/// For a terminal: one program's tests, or a line for each of many programs.
std::string table_text(const GradeRecord& record);

/// The name of a program's own files, without their ending: the program's, with a hash of it behind where that is too long or has a
/// slash, so that no two programs share a file.
std::string report_file_name(const std::string& submission);

/// Writes results.json, times.json, tests.json, results.csv, junit.xml and gradescope.json (of many programs gradescope/NAME.json) into
/// `folder`, and the pages (grade_pages.h).
void write_reports(const GradeRecord& record, const std::string& folder, bool all_pictures);

}  // namespace rt
