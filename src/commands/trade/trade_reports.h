// What a trade writes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "commands/trade/trade_result.h"

namespace rt {

/// The words of a render that makes a setting's picture, for a shell.
std::string command_text(const TradeRecord& record, const TradeSetting& setting);

/// {format, scene, settings of the picture, threads, reference, knobs, alone, front, steps, settings}.
nlohmann::ordered_json trade_json(const TradeRecord& record);
/// One line a setting: name, origin, state, front, a column for each knob, runs, seconds by phase, rays, errors.
std::string trade_csv_text(const TradeRecord& record);
/// For a terminal: the reference, the presets, the front.
std::string trade_table_text(const TradeRecord& record);

/// Writes results.json, results.csv and trade.html (trade_page.h) into `folder`.
void write_trade_reports(const TradeRecord& record, const std::string& folder);

}  // namespace rt
