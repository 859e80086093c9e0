// The line that a terminal shows while a trade is measured.
#pragma once

#include <string>
#include <string_view>

#include "commands/trade/trade_clock.h"

namespace rt {

/// "0:01:40".
std::string duration_text(double seconds);

/// Shows one line on stderr if that is a terminal and it is wanted: what is done, behind the longest time that all of it may still take.
/// Removes it at its end.
class TradeProgress {
public:
    TradeProgress(bool wanted, const TradeClock& clock);
    ~TradeProgress();
    TradeProgress(const TradeProgress&) = delete;
    TradeProgress& operator=(const TradeProgress&) = delete;

    void show(std::string_view text);

private:
    bool shown_;
    const TradeClock& clock_;
};

}  // namespace rt
