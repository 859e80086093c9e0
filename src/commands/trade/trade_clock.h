// The time of a trade and how its parts share it.
#pragma once

#include <chrono>

namespace rt {

/// The parts that may not take all of the time, in their order. What one leaves, those after it have.
enum class TradePart { alone, settings, further, instability };

class TradeClock {
public:
    /// Starts now; `seconds` of the clock are for the whole trade.
    explicit TradeClock(double seconds) : seconds_(seconds) {}

    /// Seconds until this part should have ended; below 0 afterwards.
    double left_for(TradePart part) const { return share_of(part) * seconds_ - passed(); }
    double left() const { return left_for(TradePart::instability); }

private:
    static double share_of(TradePart part) {
        switch (part) {
            case TradePart::alone:
                return 0.4;
            case TradePart::settings:
                return 0.75;
            case TradePart::further:
                return 0.9;
            case TradePart::instability:
                return 1.0;
        }
        return 1.0;
    }
    double passed() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double seconds_;
};

}  // namespace rt
