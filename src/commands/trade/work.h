// The work of a trade, in three parts: the reference, the errors of single knobs, the settings.
#pragma once

#include "commands/trade/trade_clock.h"
#include "commands/trade/trade_progress.h"
#include "commands/trade/trade_request.h"
#include "commands/trade/trade_scene.h"
#include "commands/trade/trade_store.h"

namespace rt {

/// What all parts share; the record is filled by them.
struct TradeWork {
    const TradeRequest& request;
    const TradeScene& scene;
    const TradeStore& store;
    const TradeClock& clock;
    TradeProgress& progress;
    TradeRecord& record;
    StoredImage reference{};  ///< as it is shown; made by the first part
};

/// All of it: what is known is taken, what is measured is put into the store at once. Throws TradeStopped; the record has then what
/// there was. Throws LimitError if the scene is too slow for any reference, OutputError.
void carry_out(TradeWork& work);

struct PictureSize {
    int width = 0, height = 0;
};
/// That of the request, or smaller where the time does not suffice for it. What was chosen once stays. Throws TradeStopped.
PictureSize usual_size(const TradeWork& work);

/// Of an interrupted trade: whatever an earlier one had reported and the store still knows counts as measured.
void recall(TradeWork& work);
/// Puts into the store which settings there are.
void remember(const TradeWork& work);

void make_reference(TradeWork& work);
void add_setting(TradeRecord& record, const Setting& setting, Origin origin);
/// The errors of the values that occur in the record's settings.
void measure_alone(TradeWork& work);
/// Every setting of the record, until its median is stable or the time of this part is over: presets first, the others only if there is
/// time for the least number of runs.
void measure_settings(TradeWork& work, TradePart part);
/// What an earlier trade measured of the record's settings, of their values alone, and of pixels that hang by the last bits.
void take_known_settings(TradeWork& work);
void take_known_alone(TradeWork& work);
void take_known_instability(TradeWork& work);

/// Pixels that hang by the last bits, for the presets and what differs from one only in a knob of precision.
void measure_instability(TradeWork& work);

/// The job of the exact preset, and with every pixel sampled by a grid.
RenderJob exact_job(const TradeWork& work);
RenderJob with_grid(RenderJob job, int side);
Setting exact_setting(const TradeWork& work);
/// The words of a setting as one text: what it is kept by.
std::string joined_words(const Setting& setting, const TurnedKnobs& knobs);
/// Whether a knob chooses the samples of a pixel, which the reference has enough of.
bool chooses_samples(const Knob& knob);

/// Seconds of the clock that a render will take, from small pictures of the same view: no less than it takes if that is not more than
/// `enough`, else roughly.
double expected_seconds(const TradeWork& work, const World& world, const RenderJob& job, double enough);

/// Paths of pictures in a trade's folder.
std::string picture_path(const std::string& folder, const std::string& setting_name);
std::string reference_path(const std::string& folder);

}  // namespace rt
