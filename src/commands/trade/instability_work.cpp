// The last part of a trade: pixels that hang by the last bits.
#include <fmt/format.h>

#include <algorithm>

#include "commands/trade/instability.h"
#include "commands/trade/work.h"

namespace rt {

namespace {

bool is_wanted(const TradeSetting& setting, const TradeRecord& record) {
    if (setting.state != SettingState::measured || !setting.comparable) return false;
    if (setting.origin == Origin::preset) return true;
    const auto turns_only_precision = [&](const TradeSetting& preset) {
        if (preset.origin != Origin::preset) return false;
        for (std::size_t i = 0; i < record.knobs.size(); ++i)
            if (preset.setting.values[i] != setting.setting.values[i] && record.knobs[i]->source != ErrorSource::precision) return false;
        return true;
    };
    return std::any_of(record.settings.begin(), record.settings.end(), turns_only_precision);
}

}  // namespace

void take_known_instability(TradeWork& work) {
    for (TradeSetting& setting : work.record.settings)
        if (is_wanted(setting, work.record)) setting.unstable = work.store.unstable(joined_words(setting.setting, work.record.knobs));
}

void measure_instability(TradeWork& work) {
    for (TradeSetting& setting : work.record.settings) {
        if (!is_wanted(setting, work.record)) continue;
        const std::string words = joined_words(setting.setting, work.record.knobs);
        setting.unstable = work.store.unstable(words);
        const double renders = 1 + variant_count;
        if (setting.unstable) continue;
        if (renders * total(setting.median.wall) > work.clock.left()) {
            work.record.out_of_time = true;
            continue;
        }
        work.progress.show(fmt::format("what hangs by the last bits: {}", setting.name));
        setting.unstable = work.scene.unstable(work.scene.job_of(words_of(setting.setting, work.record.knobs)));
        if (setting.unstable) work.store.put_unstable(words, *setting.unstable);
    }
}

}  // namespace rt
