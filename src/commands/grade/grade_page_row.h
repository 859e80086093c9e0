// One result as a row of a page.
#pragma once

#include "commands/report/report_page.h"
#include "grading/result.h"

namespace rt {

/// `test` is what the suite asks, or null where that is not known: then there is no expected picture or text, and no command. Texts are
/// cut at a length that a page bears.
ReportRow report_row(const Result& result, const TestCase* test);

}  // namespace rt
