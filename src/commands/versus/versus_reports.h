// What a comparison writes: the same results give the same bytes in every file but that of the times.
#pragma once

#include <string>
#include <vector>

#include "commands/job/missing_counts.h"
#include "commands/versus/versus_result.h"

namespace rt {

/// A comparison's results, and what they are to be read with.
struct VersusRecord {
    std::string povray;                 ///< its version
    std::vector<std::string> settings;  ///< the picture's, as options of ours
    VersusLimits limits;
    std::vector<VersusResult> results;  ///< in the order of the scenes
};

/// Of the scenes that POV-Ray renders and that ask for what is not modelled.
std::vector<MissingCount> missing_counts(const std::vector<VersusResult>& results);

/// Worst first: by cause in the order of VersusCause; those that differ or agree by the pixels beyond the step, then RMSE, then name.
std::vector<const VersusResult*> worst_first(const VersusRecord& record);

/// {format, povray, settings, limits, summary, missing, scenes}, without times; and the times, an entry for each scene.
std::string versus_results_text(const VersusRecord& record);
std::string versus_times_text(const VersusRecord& record);
/// One line a scene: causes, figures of both shadings, times, messages.
std::string versus_csv_text(const VersusRecord& record);
/// For a terminal: the scenes worst first, grouped by cause, what is not modelled by its gain, and a closing count.
std::string versus_table_text(const VersusRecord& record);

/// Writes results.json, times.json, results.csv and report.html (versus_page.h) into `folder`.
void write_versus_reports(const VersusRecord& record, const std::string& folder);

/// Pixels within the step in percent with `digits` behind the point, rounded down: 100 is all of them, and a limit that is not reached
/// never looks as if it were.
std::string percent_text(const Likeness& like, int digits);

}  // namespace rt
