// Settings as points of time and error, and which of them no other beats.
#pragma once

#include <span>
#include <vector>

namespace rt {

/// Both above 0, but for an error of 0.
struct TradePoint {
    double seconds = 0.0, error = 0.0;
};

/// Shares by which numbers differ without a meaning.
struct FrontMargins {
    double worth = 0.02;      ///< of an error: no smaller gain is worth any time
    double same_time = 0.05;  ///< from run to run
    double same_error = 0.005;
};

/// The points that no other beats, from quick to exact: the error of each is smaller than that of every quicker one by what is worth it.
/// For one of them stands the first in the list that is as good.
std::vector<std::size_t> front_of(std::span<const TradePoint> points, const FrontMargins& margins = {});

/// By how much a point is beaten by one of `front`: the logarithm of the factor by which both its time and its error are larger; below 0
/// for one that none of them beats. -infinity where the front is empty.
double beaten_by(std::span<const TradePoint> front, const TradePoint& point);

}  // namespace rt
