#include "commands/trade/setting.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/base/content_hash.h"

namespace rt {

namespace {

/// as_stated for a name that is none of its values.
std::size_t value_of(const Knob& knob, std::string_view name) {
    const auto found = std::find_if(knob.values.begin(), knob.values.end(), [&](const KnobValue& value) { return value.name == name; });
    return found == knob.values.end() ? as_stated : static_cast<std::size_t>(found - knob.values.begin());
}

std::size_t count_apart(const Setting& a, const Setting& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) count += a.values[i] != b.values[i];
    return count;
}

}  // namespace

TurnedKnob turned_knob(const Knob& knob, const Scene& scene) {
    TurnedKnob turned{&knob, value_of(knob, knob.plain), 0};
    for (std::size_t value = 0; value < knob.values.size(); ++value) {
        const BesideScene beside = beside_scene(knob.values[value].words, scene);
        if (beside == BesideScene::same) turned.plain = value;
        turned.coarser += beside == BesideScene::coarser;
    }
    return turned;
}

Setting plain_setting(const TurnedKnobs& knobs) {
    Setting setting;
    for (const TurnedKnob& knob : knobs) setting.values.push_back(knob.plain);
    return setting;
}

Setting preset_setting(const QualityPreset& preset, const TurnedKnobs& knobs) {
    Setting setting = plain_setting(knobs);
    for (const QualityChoice& choice : preset.choices)
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            if (knobs[i]->name != choice.knob) continue;
            const std::size_t value = value_of(*knobs[i].table, choice.value);
            const bool is_stated = knobs[i]->plain.empty();
            const bool stays = is_stated && (preset.cheap ? value >= knobs[i].coarser : value < knobs[i].coarser);
            if (!stays) setting.values[i] = value;
        }
    return setting;
}

bool goes_together(const Setting& setting, const TurnedKnobs& knobs) {
    bool by_error = false, by_share = false;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (setting.values[i] == as_stated) continue;
        by_error |= knobs[i]->values[setting.values[i]].words.starts_with("--max-error");
        by_share |= knobs[i]->name == "scale" && setting.values[i] != knobs[i].plain;
    }
    return !(by_error && by_share);
}

std::vector<std::string> words_of(const Setting& setting, const TurnedKnobs& knobs) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (setting.values[i] != as_stated) words.emplace_back(knobs[i]->values[setting.values[i]].words);
    return words;
}

std::string name_of(const Setting& setting, const TurnedKnobs& knobs) {
    std::string_view nearest;
    Setting base;
    std::size_t least = 0;
    for (const QualityPreset& preset : quality_presets()) {
        const Setting other = preset_setting(preset, knobs);
        const std::size_t apart = count_apart(setting, other);
        const bool nearer = nearest.empty() || apart < least || (apart == least && apart > 0);
        if (nearer) nearest = preset.name, base = other, least = apart;
    }
    if (least > 0 && setting == plain_setting(knobs)) return "plain";
    std::string name(nearest);
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (setting.values[i] != base.values[i])
            name += fmt::format("{} {} {}", name == nearest ? ":" : ",", knobs[i]->name, value_name(*knobs[i].table, setting.values[i]));
    return name;
}

std::string file_name_of(const std::string& name) {
    std::string text;
    for (const char c : name) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.';
        if (plain)
            text += c;
        else if (!text.empty() && text.back() != '-')
            text += '-';
    }
    while (text.ends_with('-')) text.pop_back();
    constexpr std::size_t longest = 150, digits = 12;  // file systems take 255
    return text.size() <= longest ? text : fmt::format("{}-{}", text.substr(0, longest), hash_of(name).substr(0, digits));
}

std::string_view value_name(const Knob& knob, std::size_t value) { return value == as_stated ? "as stated" : knob.values[value].name; }

}  // namespace rt
