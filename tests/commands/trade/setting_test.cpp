// Points in the space of knobs, their names and words.
#include "commands/trade/setting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace rt::setting_test {
namespace {

using testing::ElementsAre;

Scene scene_with(int level, double bailout) {
    Scene scene;
    scene.settings.max_trace_level = level, scene.settings.adc_bailout = bailout;
    return scene;
}

TurnedKnobs turned(const std::vector<std::string_view>& names, const Scene& scene = {}) {
    TurnedKnobs list;
    for (const std::string_view name : names) list.push_back(turned_knob(*find_knob(name), scene));
    return list;
}

std::string value_in(const Setting& setting, const TurnedKnobs& knobs, std::string_view name) {
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (knobs[i]->name == name) return std::string(value_name(*knobs[i].table, setting.values[i]));
    return "no such knob";
}

TEST(TurnedKnob, KnowsThePlaceOfWhatTheSceneStates) {
    const TurnedKnob level = turned_knob(*find_knob("max-trace-level"), scene_with(5, 0.1));
    EXPECT_EQ(level.table->values[level.plain].name, "5");
    EXPECT_EQ(level.coarser, level.plain) << "the smaller ones";
    const TurnedKnob between = turned_knob(*find_knob("max-trace-level"), scene_with(10, 0.1));
    EXPECT_EQ(between.plain, as_stated);
    EXPECT_EQ(between.table->values[between.coarser].name, "12");
    const TurnedKnob bailout = turned_knob(*find_knob("adc-bailout"), scene_with(5, 1.0 / 255.0));
    EXPECT_EQ(bailout.table->values[bailout.plain].name, "1/255");
    EXPECT_EQ(bailout.coarser, bailout.plain) << "the larger ones";
    const TurnedKnob samples = turned_knob(*find_knob("samples"), scene_with(5, 0.1));
    EXPECT_EQ(samples.table->values[samples.plain].name, "1");
    EXPECT_EQ(samples.coarser, 0u);
}

TEST(PresetSetting, EveryPresetIsMadeOfTheTablesValues) {
    std::set<std::string_view> names;
    for (const QualityPreset& preset : quality_presets()) {
        names.insert(preset.name);
        EXPECT_EQ(&quality_of_name(preset.name), &preset);
        for (const QualityChoice& choice : preset.choices) EXPECT_NO_THROW(words_of(choice)) << preset.name << " " << choice.knob;
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"draft", "fast", "good", "exact"}));
}

/// A cheap preset is never slower for what it sets beside the scene, an exact one never coarser.
TEST(PresetSetting, GoesOneWayFromWhatTheSceneStates) {
    const std::vector<std::string_view> names{"max-trace-level", "adc-bailout"};
    for (const auto& [level, bailout, level_name, bailout_name] :
         {std::tuple(1, 0.25, "1", "1/4"), std::tuple(20, 0.0, "20", "0"), std::tuple(256, 0.0, "as stated", "0")}) {
        const TurnedKnobs knobs = turned(names, scene_with(level, bailout));
        const Setting plain = plain_setting(knobs);
        EXPECT_EQ(value_in(plain, knobs, "max-trace-level"), level_name);
        EXPECT_EQ(value_in(plain, knobs, "adc-bailout"), bailout_name);
        for (const QualityPreset& preset : quality_presets()) {
            const bool changes =
                preset.cheap == (level > 1);  // a fine scene is made coarser by cheap ones, a coarse one finer by the others
            const Setting setting = preset_setting(preset, knobs);
            if (!changes) {
                EXPECT_EQ(setting, plain) << preset.name << level;
            }
        }
        EXPECT_NE(preset_setting(quality_of_name(level > 1 ? "draft" : "exact"), knobs), plain) << level;
    }
}

TEST(SettingNames, ArePresetsOrWhatDiffersFromTheNearest) {
    const TurnedKnobs knobs = turned({"samples", "precision"});
    const Setting good = preset_setting(quality_of_name("good"), knobs);
    EXPECT_EQ(name_of(good, knobs), "good");
    Setting setting = good;
    setting.values[1] = 0;
    EXPECT_EQ(name_of(setting, knobs), "good: precision fast");
    EXPECT_EQ(file_name_of("good: samples 2 x 2, precision fast"), "good-samples-2-x-2-precision-fast");
    EXPECT_EQ(file_name_of("exact"), "exact");
    EXPECT_LT(file_name_of(std::string(400, 'a')).size(), 200u);
    EXPECT_NE(file_name_of(std::string(400, 'a')), file_name_of(std::string(401, 'a')));
}

TEST(SettingNames, PlainIsOnlyWhatIsNoPreset) {
    const TurnedKnobs knobs = turned({"samples", "scale", "max-trace-level"}, scene_with(7, 0.1));
    EXPECT_EQ(name_of(plain_setting(knobs), knobs), "plain");
    EXPECT_THAT(words_of(plain_setting(knobs), knobs), ElementsAre("--ss 1", "--scale 1")) << "what is stated has no words";
}

TEST(SettingWords, AreThoseOfTheValues) {
    const TurnedKnobs knobs = turned({"samples", "precision"});
    Setting setting{{0, 1}};
    EXPECT_THAT(words_of(setting, knobs), ElementsAre(std::string(find_knob("samples")->values[0].words), "--precision exact"));
}

}  // namespace
}  // namespace rt::setting_test
