// Which settings are measured: not all combinations of the knobs' values, but those that tell what each knob does and where the front lies.
#pragma once

#include "commands/trade/trade_result.h"

namespace rt {

struct PlannedSetting {
    Setting setting;
    Origin origin = Origin::preset;
};

/// The presets and what a run has that says nothing; then every value of every knob around "good"; then one step up and down of every knob
/// around the other presets. None twice.
std::vector<PlannedSetting> first_settings(const TurnedKnobs& knobs);

/// Whether a setting shows the surfaces that the reference has: no knob is turned whose values are only different.
bool is_comparable(const Setting& setting, const TurnedKnobs& knobs);

/// What a setting will take and how far off it will be, from those measured: each knob's value multiplies the time by a factor of its own,
/// and adds the square of its error alone.
class Prediction {
public:
    explicit Prediction(const TradeRecord& record);
    /// From the measured setting number `from`. Nothing if a factor or an error is not known.
    std::optional<TradePoint> at(const Setting& setting, std::size_t from) const;

private:
    struct Factor {
        bool known = false;
        double logarithm = 0.0;  ///< of the seconds, beside the first known value of the knob
    };
    void find_factors(std::size_t knob);

    const TradeRecord& record_;
    std::vector<std::vector<Factor>> factors_;  ///< by knob and value
};

/// How much of a search is wanted.
struct FurtherWish {
    std::size_t most = 12;       ///< settings that may lie on the front
    std::size_t fill_up_to = 0;  ///< settings of the record in the end, whether they may lie there or not
};

/// Settings that are not in the record and that differ from one of its front in one or two knobs, by one step each where that is enough:
/// those that are predicted to be beaten least, the best first; none that is predicted to be beaten by more than 5 %, unless to fill up.
std::vector<Setting> further_settings(const TradeRecord& record, const FurtherWish& wish);

}  // namespace rt
