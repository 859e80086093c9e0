#include "commands/trade/sensitivity.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace rt {

namespace {

const TradeSetting* measured(const TradeRecord& record, const Setting& setting) {
    const auto found = std::find_if(record.settings.begin(), record.settings.end(), [&](const TradeSetting& other) {
        return other.setting == setting && other.state == SettingState::measured;
    });
    return found == record.settings.end() ? nullptr : &*found;
}

/// What a value's words choose before its numbers: of --aa also POV-Ray's method.
std::string_view method_of(std::string_view words) {
    return words.starts_with("--aa ") ? words.substr(0, words.find(',')) : words.substr(0, words.find_first_of(" ="));
}

/// The value that is a step below `to`; nothing if there is none.
std::optional<std::size_t> before(const Knob& knob, std::size_t to) {
    for (std::size_t from = to; from-- > 0;)
        if (method_of(knob.values[from].words) == method_of(knob.values[to].words)) return from;
    return std::nullopt;
}

}  // namespace

std::vector<KnobStep> knob_steps(const TradeRecord& record) {
    std::vector<KnobStep> steps;
    for (std::size_t knob = 0; knob < record.knobs.size(); ++knob) {
        if (!record.knobs[knob]->converges) continue;
        for (const QualityPreset& preset : quality_presets())
            for (std::size_t to = 1; to < record.knobs[knob]->values.size(); ++to) {
                const std::optional<std::size_t> from = before(*record.knobs[knob].table, to);
                if (!from) continue;
                Setting first = preset_setting(preset, record.knobs), second = first;
                first.values[knob] = *from, second.values[knob] = to;
                const TradeSetting *a = measured(record, first), *b = measured(record, second);
                if (a && b)
                    steps.push_back({knob, *from, to, std::string(preset.name), point_of(*a, record.cost), point_of(*b, record.cost)});
            }
    }
    return steps;
}

}  // namespace rt
