#include "commands/trade/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rt {

std::vector<std::size_t> front_of(std::span<const TradePoint> points, const FrontMargins& margins) {
    std::vector<std::size_t> order(points.size()), front;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(points[a].seconds, points[a].error) < std::pair(points[b].seconds, points[b].error);
    });
    for (const std::size_t i : order)
        if (front.empty() || points[i].error < (1.0 - margins.worth) * points[front.back()].error) front.push_back(i);
    for (std::size_t& i : front) {
        const auto as_good = [&, best = points[i]](const TradePoint& other) {
            return other.seconds <= (1.0 + margins.same_time) * best.seconds && other.error <= (1.0 + margins.same_error) * best.error;
        };
        i = static_cast<std::size_t>(std::find_if(points.begin(), points.end(), as_good) - points.begin());
    }
    front.erase(std::unique(front.begin(), front.end()), front.end());
    return front;
}

double beaten_by(std::span<const TradePoint> front, const TradePoint& point) {
    constexpr double least = 1e-12;  // so that an error of 0 has a logarithm
    double most = -std::numeric_limits<double>::infinity();
    for (const TradePoint& other : front) {
        const double slower = std::log(std::max(point.seconds, least) / std::max(other.seconds, least));
        const double worse = std::log(std::max(point.error, least) / std::max(other.error, least));
        most = std::max(most, std::min(slower, worse));
    }
    return most;
}

}  // namespace rt
