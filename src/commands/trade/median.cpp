#include "commands/trade/median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace rt {

double median(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    return 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
}

double median_spread(std::span<const double> values) {
    if (values.size() < 2) return std::numeric_limits<double>::infinity();
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double n = static_cast<double>(sorted.size());
    const auto below = static_cast<std::size_t>(std::max(0.0, std::floor(0.5 * (n - std::sqrt(n)))));
    const double middle = median(values), width = sorted[sorted.size() - 1 - below] - sorted[below];
    return width == 0.0 ? 0.0 : 0.5 * width / middle;
}

bool is_measured(std::span<const double> seconds, const RepeatRule& rule) {
    const int runs = static_cast<int>(seconds.size());
    if (runs < rule.least) return false;
    return runs >= rule.most || std::accumulate(seconds.begin(), seconds.end(), 0.0) >= rule.seconds ||
           median_spread(seconds) < rule.spread;
}

}  // namespace rt
