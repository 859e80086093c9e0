// A trade as a page for a browser.
#pragma once

#include <string>

#include "commands/trade/trade_result.h"

namespace rt {

/// Time against error with the front, the settings as a table, each with its picture beside the reference (those below
/// `folder`/pictures), what each step of a knob costs, and where the error comes from: one file that asks the network for nothing.
std::string trade_page_text(const TradeRecord& record, const std::string& folder);

}  // namespace rt
