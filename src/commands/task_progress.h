// The line that a terminal shows while programs are graded.
#pragma once

#include <chrono>
#include <string>

#include "commands/grade_run.h"

namespace rt {

/// "  120/18000 tests (40 known)  31.2 tests/s  0:09:31 left".
std::string grade_progress_text(const GradeProgress& progress);

/// Redraws the line at most ten times a second, and only if stderr is a terminal and `wanted`. Removes it at its end.
class GradeProgressLine {
public:
    explicit GradeProgressLine(bool wanted);
    ~GradeProgressLine();
    GradeProgressLine(const GradeProgressLine&) = delete;
    GradeProgressLine& operator=(const GradeProgressLine&) = delete;

    void update(const GradeProgress& progress);

private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    Clock::time_point last_{};
};

}  // namespace rt
