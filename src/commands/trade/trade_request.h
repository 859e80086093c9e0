// What a trade is asked for.
#pragma once

#include <string>
#include <vector>

#include "commands/job/render_job.h"
#include "commands/trade/median.h"
#include "commands/trade/trade_result.h"

namespace rt {

struct TradeRequest {
    RenderJob job;                   ///< as the command line has it, with choices still open
    std::vector<std::string> words;  ///< the picture's settings, as options of a render
    std::string folder = "trade-results";
    bool size_is_asked = false;             ///< else a smaller picture is taken where the scene is slow
    double seconds = 300.0;                 ///< of the whole, of the clock
    double reference_error = 1.0 / 4096.0;  ///< RMSE; the reference grows until it is estimated to be below
    double reference_seconds = 0.0;         ///< or would take longer; settled from `seconds` where it is not asked for
    double run_seconds = 0.0;               ///< a setting of which one run takes longer is left out; settled likewise
    RepeatRule rule;
    std::size_t most_settings = 100;
    Cost cost = Cost::wall;
    bool fresh = false, quiet = false;
};

/// Fewer settings are not enough to tell anything; a plan is filled up to so many.
inline constexpr std::size_t least_settings = 25;

}  // namespace rt
