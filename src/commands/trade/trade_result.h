// What a trade measures: plain values, the same for every report.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands/job/stats.h"
#include "commands/trade/front.h"
#include "commands/trade/instability_cause.h"
#include "commands/trade/setting.h"
#include "core/name_table.h"
#include "trace/tracer.h"

namespace rt {

/// Seconds of the clock and of all processors, by phase.
struct Timing {
    Phases wall, cpu;
};

/// Which of both a trade is about.
enum class Cost : std::uint8_t { wall, cpu };
inline constexpr NameTable<Cost, 2> cost_names{{{"wall", Cost::wall}, {"cpu", Cost::cpu}}};
inline const Phases& phases_of(const Timing& timing, Cost cost) { return cost == Cost::wall ? timing.wall : timing.cpu; }
inline double total(const Phases& p) { return p.parse + p.build + p.trace + p.write; }

/// How far a picture is from the reference, as both are shown: encoded, clamped, in 65535 steps; shares of full scale.
struct PictureError {
    double rmse = 0.0;  ///< over all channels
    double p99 = 0.0;   ///< 99 % of the pixels have no larger difference in a channel
    double max = 0.0;
    double flip = 0.0;  ///< mean LDR-FLIP
};

struct Measured {
    std::vector<Timing> runs;  ///< parse: 0, the scene is read once for all
    RayCounts rays;
    std::uint64_t non_finite = 0;
    PictureError error;
    std::string picture;  ///< fingerprint of its file
};

/// Why a setting is in the plan.
enum class Origin : std::uint8_t {
    preset,    ///< a quality, or a run that says nothing
    step,      ///< one knob away from a preset
    neighbour  ///< near a setting of the front
};
inline constexpr NameTable<Origin, 3> origin_names{{{"preset", Origin::preset}, {"step", Origin::step}, {"neighbour", Origin::neighbour}}};

enum class SettingState : std::uint8_t {
    not_run,   ///< the trade ended before, or had no time for it
    measured,  ///< perhaps fewer times than asked for
    too_slow   ///< one run would take longer than allowed
};
inline constexpr NameTable<SettingState, 3> setting_state_names{
    {{"not run", SettingState::not_run}, {"measured", SettingState::measured}, {"too slow", SettingState::too_slow}}};

/// Pixels that move by more than 1/255 when numbers are rounded in another way (instability.h).
struct UnstableCount {
    std::uint64_t pixels = 0;
    std::array<std::uint64_t, unstable_causes> by_cause{};
};
/// "12 pixels move with the rounding of numbers (8 silhouette, 4 depth)".
std::string unstable_text(const UnstableCount& unstable);

struct TradeSetting {
    Setting setting;
    std::string name;
    Origin origin = Origin::step;
    SettingState state = SettingState::not_run;
    double expected_seconds = 0.0;  ///< of the clock for one run, before there was any; 0: unknown
    Measured measured;
    Timing median;        ///< of each phase; parse is the scene's
    double spread = 0.0;  ///< of the median of a run, as a share of it
    bool on_front = false;
    bool comparable = true;                 ///< the same surfaces as the reference: no knob that only chooses others is turned
    std::optional<UnstableCount> unstable;  ///< of some settings
};

/// The converged picture, as far as it got.
struct ReferenceFacts {
    double samples = 0.0;    ///< rays through a pixel
    double error = 0.0;      ///< estimated RMSE
    double asked = 0.0;      ///< of the command line
    double seconds = 0.0;    ///< of the clock
    std::vector<int> grids;  ///< sides of the grids that it is the mean of
    bool complete() const { return grids.size() >= 2; }
    /// Errors below are not told apart: they are hardly larger than the reference's own, of which nobody knows the direction.
    double told_apart() const { return 2.0 * error; }
};

/// The error of one value of one knob with everything else exact, and sampled until that does not matter.
struct AloneError {
    std::size_t knob = 0, value = 0;
    double rmse = 0.0;
};

/// What each run takes besides reading the scene.
std::vector<double> run_seconds(const Measured& measured, Cost cost);

struct TradeRecord {
    std::string scene;
    std::vector<std::string> words;  ///< the picture's settings, as options
    std::string size;                ///< "640 x 480"
    int threads = 0, processors = 0;
    Cost cost = Cost::wall;
    TurnedKnobs knobs;
    ReferenceFacts reference;
    std::vector<AloneError> alone;
    std::vector<TradeSetting> settings;
    bool complete = true;      ///< false after an interruption
    bool out_of_time = false;  ///< something was left out or measured less often for lack of time
};

inline TradePoint point_of(const TradeSetting& setting, Cost cost) {
    return {total(phases_of(setting.median, cost)), setting.measured.error.rmse};
}

/// What the front is made of: errors that are not told apart are one.
TradePoint front_point(const TradeRecord& record, const TradeSetting& setting);

/// The settings that count for the front: measured and comparable.
std::vector<std::size_t> comparable_settings(const TradeRecord& record);
/// Of the record's settings, from quick to exact.
std::vector<std::size_t> front_settings(const TradeRecord& record);

/// The error of a value alone; nothing where it was not measured; 0 for the exact value of a knob that has one.
std::optional<double> alone_error(const TradeRecord& record, std::size_t knob, std::size_t value);

}  // namespace rt
