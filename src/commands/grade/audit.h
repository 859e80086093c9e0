// What a suite cannot notice.
#pragma once

#include <string>
#include <vector>

#include "grading/suite.h"

namespace rt {

/// One way to be wrong, and the tests by it.
struct AuditLine {
    std::string mistake;               ///< e.g. "mirrored"
    std::vector<std::string> blind;    ///< tests that pass all the same
    std::vector<std::string> unmoved;  ///< tests whose right answer is the same with the mistake: no test of it at all
    std::size_t noticed = 0;
};

/// Judges right answers with one mistake in each, by the suite's own rule: pictures 5 % darker, mirrored, moved by a pixel, without
/// shadows, without anti-aliasing; texts with one digit changed. Pictures without shadows and anti-aliasing are rendered by this program's
/// course profile, for tests whose command it understands.
std::vector<AuditLine> audit(const Suite& suite);

std::string audit_text(const std::vector<AuditLine>& lines);
std::string audit_json(const Suite& suite, const std::vector<AuditLine>& lines);

}  // namespace rt
