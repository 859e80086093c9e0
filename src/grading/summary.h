// Many results as a few numbers.
#pragma once

#include <string>
#include <vector>

#include "grading/result.h"

namespace rt {

/// Of one program. Tests that are only shown do not count.
struct Summary {
    std::string submission;
    int tests = 0, passed = 0;
    int required = 0, required_passed = 0;
    double points = 0.0, out_of = 0.0;  ///< weights times credit
    double wall_seconds = 0.0, cpu_seconds = 0.0;
    bool complete = true;  ///< every test was run
};

Summary summary_of(const std::vector<Result>& results);

/// The results of each program, in the order in which programs first appear.
std::vector<std::vector<Result>> by_submission(const std::vector<Result>& results);

}  // namespace rt
