// What one step of a knob costs.
#pragma once

#include "commands/trade/trade_result.h"

namespace rt {

/// From a value of a knob to the next more exact one of the same method of sampling, everything else as it is in a preset.
struct KnobStep {
    std::size_t knob = 0, from = 0, to = 0;  ///< values
    std::string base;                        ///< name of the preset
    TradePoint before, after;
    double time_factor() const { return after.seconds / before.seconds; }
};

/// All pairs of measured settings that are such a step, by knob, preset and value. Knobs whose values do not converge have none.
std::vector<KnobStep> knob_steps(const TradeRecord& record);

}  // namespace rt
