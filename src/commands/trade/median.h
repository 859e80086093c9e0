// When a time has been measured often enough.
#pragma once

#include <span>

namespace rt {

/// Of one number or more.
double median(std::span<const double> values);

/// How far the median may be off, as a share of it: half the distance between the values whose ranks lie sqrt(n)/2 below and above the
/// middle. The rank of the true median among n independent values has that standard deviation (binomial with p = 1/2). Infinite for fewer
/// than two values.
double median_spread(std::span<const double> values);

struct RepeatRule {
    int least = 3, most = 9;  ///< runs
    double spread = 0.03;     ///< of the median
    double seconds = 6.0;     ///< of all runs together; the least number of runs is done all the same
};

/// Whether the runs that took so long tell the time.
bool is_measured(std::span<const double> seconds, const RepeatRule& rule);

}  // namespace rt
