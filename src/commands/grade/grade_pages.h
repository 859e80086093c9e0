// A grading's results as pages for a browser.
#pragma once

#include <string>

#include "commands/grade/grade_reports.h"

namespace rt {

/// Of one program `report.html`; of many `reports/NAME.html` each, and `index.html` that leads to them. A page that has the same bytes
/// already is left alone. Pictures of one program's page are at most 64 MiB; of many programs those of passed tests are left out, and the
/// others are at most 2 GiB together; what is left out says so. `all_pictures`: nothing is. Throws OutputError.
void write_grade_pages(const GradeRecord& record, const std::string& folder, bool all_pictures);

}  // namespace rt
