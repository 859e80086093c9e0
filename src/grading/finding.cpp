#include "grading/finding.h"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

constexpr double most_left = 0.15;  ///< by a cause that is named
/// More may be left by a cause that all others are far behind.
constexpr double most_left_with_lead = 0.3, lead = 2.5;
/// What costs up to this cannot be told from the best.
double as_good(double least) { return 1.5 * std::max(least, 0.0) + 0.004; }

double cost(const Finding& finding) { return finding.left + finding.freedom; }

bool leads(const std::vector<Finding>& causes, double least) {
    return least <= most_left_with_lead &&
           std::count_if(causes.begin(), causes.end(), [&](const Finding& f) { return cost(f) < std::min(lead * least, 1.0); }) == 1;
}

}  // namespace

Verdicts choose(std::vector<Finding> findings) {
    // One cause, one line: its best case.
    std::vector<Finding> causes;
    for (Finding& finding : findings) {
        const auto known = std::find_if(causes.begin(), causes.end(), [&](const Finding& f) { return f.cause == finding.cause; });
        if (known == causes.end())
            causes.push_back(std::move(finding));
        else if (cost(finding) < cost(*known))
            *known = std::move(finding);
    }
    Verdicts verdicts;
    if (causes.empty()) return {"", {"no common mistake explains the difference"}};
    double least = cost(causes.front());
    for (const Finding& finding : causes) least = std::min(least, cost(finding));
    if (least > most_left && !leads(causes, least)) {
        std::stable_sort(causes.begin(), causes.end(), [](const Finding& a, const Finding& b) { return cost(a) < cost(b); });
        verdicts.lines.emplace_back("no common mistake explains the difference; nearest to it:");
        for (std::size_t i = 0; i < std::min<std::size_t>(2, causes.size()); ++i)
            verdicts.lines.push_back(fmt::format("  {}? {}", causes[i].cause, causes[i].evidence));
        return verdicts;
    }
    for (const Finding& finding : causes) {
        if (cost(finding) > as_good(least)) continue;
        verdicts.lines.push_back(verdicts.cause.empty() ? finding.evidence
                                                        : fmt::format("as well explained by {}: {}", finding.cause, finding.evidence));
        if (verdicts.cause.empty()) verdicts.cause = finding.cause;
    }
    return verdicts;
}

}  // namespace rt
