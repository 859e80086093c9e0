#include "commands/trade/trade_result.h"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

std::string unstable_text(const UnstableCount& unstable) {
    std::string causes;
    for (const auto& [name, cause] : unstable_cause_names)
        if (const std::uint64_t count = unstable.by_cause[static_cast<std::size_t>(cause)])
            causes += fmt::format("{}{} {}", causes.empty() ? "" : ", ", count, name);
    return fmt::format("{} pixels move with the rounding of numbers{}", unstable.pixels,
                       causes.empty() ? "" : fmt::format(" ({})", causes));
}

std::vector<double> run_seconds(const Measured& measured, Cost cost) {
    std::vector<double> seconds;
    for (const Timing& run : measured.runs) seconds.push_back(total(phases_of(run, cost)));
    return seconds;
}

std::vector<std::size_t> comparable_settings(const TradeRecord& record) {
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < record.settings.size(); ++i)
        if (record.settings[i].state == SettingState::measured && record.settings[i].comparable) list.push_back(i);
    return list;
}

TradePoint front_point(const TradeRecord& record, const TradeSetting& setting) {
    const TradePoint point = point_of(setting, record.cost);
    return {point.seconds, std::max(point.error, record.reference.told_apart())};
}

std::vector<std::size_t> front_settings(const TradeRecord& record) {
    const std::vector<std::size_t> list = comparable_settings(record);
    std::vector<TradePoint> points;
    for (const std::size_t i : list) points.push_back(front_point(record, record.settings[i]));
    std::vector<std::size_t> front;
    for (const std::size_t i : front_of(points)) front.push_back(list[i]);
    return front;
}

std::optional<double> alone_error(const TradeRecord& record, std::size_t knob, std::size_t value) {
    const auto found = std::find_if(record.alone.begin(), record.alone.end(),
                                    [&](const AloneError& alone) { return alone.knob == knob && alone.value == value; });
    if (found == record.alone.end()) return std::nullopt;
    return found->rmse;
}

}  // namespace rt
