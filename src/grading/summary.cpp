#include "grading/summary.h"

#include <map>

namespace rt {

Summary summary_of(const std::vector<Result>& results) {
    Summary sum;
    for (const Result& result : results) {
        sum.submission = result.submission;
        sum.wall_seconds += result.wall_seconds, sum.cpu_seconds += result.cpu_seconds;
        if (result.outcome == Outcome::not_run) sum.complete = false;
        if (result.kind == TestCase::Kind::shown) continue;
        const bool passed = result.outcome == Outcome::passed;
        ++sum.tests, sum.passed += passed;
        if (result.required) ++sum.required, sum.required_passed += passed;
        sum.points += result.weight * result.credit, sum.out_of += result.weight;
    }
    return sum;
}

std::vector<std::vector<Result>> by_submission(const std::vector<Result>& results) {
    std::vector<std::vector<Result>> groups;
    std::map<std::string, std::size_t> places;
    for (const Result& result : results) {
        const auto [place, is_new] = places.emplace(result.submission, groups.size());
        if (is_new) groups.emplace_back();
        groups[place->second].push_back(result);
    }
    return groups;
}

}  // namespace rt
