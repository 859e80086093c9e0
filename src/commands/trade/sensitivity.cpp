#include "commands/trade/sensitivity.h"

#include <algorithm>

namespace rt {

namespace {

const TradeSetting* measured(const TradeRecord& record, const Setting& setting) {
    const auto found = std::find_if(record.settings.begin(), record.settings.end(), [&](const TradeSetting& other) {
        return other.setting == setting && other.state == SettingState::measured;
    });
    return found == record.settings.end() ? nullptr : &*found;
}

}  // namespace

std::vector<KnobStep> knob_steps(const TradeRecord& record) {
    std::vector<KnobStep> steps;
    for (std::size_t knob = 0; knob < record.knobs.size(); ++knob) {
        if (!record.knobs[knob]->converges) continue;
        for (const QualityPreset& preset : quality_presets())
            for (std::size_t to = 1; to < record.knobs[knob]->values.size(); ++to) {
                Setting before = preset_setting(preset, record.knobs), after = before;
                before.values[knob] = to - 1, after.values[knob] = to;
                const TradeSetting *a = measured(record, before), *b = measured(record, after);
                if (a && b)
                    steps.push_back({knob, to - 1, to, std::string(preset.name), point_of(*a, record.cost), point_of(*b, record.cost)});
            }
    }
    return steps;
}

}  // namespace rt
