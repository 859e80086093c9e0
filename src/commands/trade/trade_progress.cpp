#include "commands/trade/trade_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "commands/base/program.h"

namespace rt {

namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

std::string duration_text(double seconds) {
    const auto whole = static_cast<long>(std::ceil(seconds));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

TradeProgress::TradeProgress(bool wanted, const TradeClock& clock) : shown_(wanted && isatty(STDERR_FILENO) == 1), clock_(clock) {}

TradeProgress::~TradeProgress() {
    if (shown_) write_stderr(clear_line);
}

void TradeProgress::show(std::string_view text) {
    constexpr std::size_t columns = 79;  // a line that is broken is not cleared
    const std::string line = fmt::format("  {} left at most  {}", duration_text(std::max(0.0, clock_.left())), text);
    if (shown_) write_stderr(clear_line + line.substr(0, columns));
}

}  // namespace rt
