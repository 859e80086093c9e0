#include "grading/suite.h"

#include <algorithm>

namespace rt {

double credit(const CreditCurve& curve, double figure) {
    const auto& points = curve.points;
    if (points.empty()) return 0.0;
    const auto above = std::find_if(points.begin(), points.end(), [&](const auto& point) { return figure <= point.first; });
    if (above == points.begin()) return above->second;
    if (above == points.end()) return points.back().second;
    const auto below = above - 1;
    const double share = (figure - below->first) / (above->first - below->first);
    return below->second + share * (above->second - below->second);
}

}  // namespace rt
