// Which settings are measured, and what is predicted of others.
#include "commands/trade/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "commands/trade/sensitivity.h"

namespace rt::plan_test {
namespace {

TurnedKnobs turned(const std::vector<std::string_view>& names) {
    TurnedKnobs list;
    for (const std::string_view name : names) list.push_back(turned_knob(*find_knob(name), Scene()));
    return list;
}

std::size_t count_apart(const Setting& a, const Setting& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) count += a.values[i] != b.values[i];
    return count;
}

/// A world in which every value multiplies the time and has an error alone, as the prediction takes it to be.
struct Model {
    static double seconds(const Setting& setting) {
        double seconds = 0.01;
        for (std::size_t i = 0; i < setting.values.size(); ++i)
            seconds *= std::pow(1.5 + 0.1 * static_cast<double>(i), static_cast<double>(setting.values[i]));
        return seconds;
    }
    static double alone(std::size_t knob, std::size_t value, const TurnedKnobs& knobs) {
        const double last = static_cast<double>(knobs[knob]->values.size() - 1);
        return (last - static_cast<double>(value)) * 0.01;
    }
    static double error(const Setting& setting, const TurnedKnobs& knobs) {
        double square = 0.0;
        for (std::size_t i = 0; i < setting.values.size(); ++i) square += std::pow(alone(i, setting.values[i], knobs), 2);
        return std::sqrt(square);
    }
};

void measure(TradeRecord& record, const Setting& setting) {
    TradeSetting measured;
    measured.setting = setting, measured.state = SettingState::measured;
    measured.comparable = is_comparable(setting, record.knobs);
    measured.median.wall.trace = Model::seconds(setting);
    measured.measured.error.rmse = Model::error(setting, record.knobs);
    record.settings.push_back(measured);
}

TradeRecord measured_record(const TurnedKnobs& knobs) {
    TradeRecord record;
    record.knobs = knobs;
    for (std::size_t i = 0; i < knobs.size(); ++i)
        for (std::size_t value = 0; value < knobs[i]->values.size(); ++value)
            record.alone.push_back({i, value, Model::alone(i, value, knobs)});
    for (const PlannedSetting& planned : first_settings(knobs)) measure(record, planned.setting);
    return record;
}

TEST(FirstSettings, ArePresetsAndTheirStepsNoneTwice) {
    const TurnedKnobs knobs = turned({"samples", "max-trace-level", "adc-bailout", "precision"});
    const std::vector<PlannedSetting> plan = first_settings(knobs);
    std::set<Setting> seen, presets;
    for (const QualityPreset& preset : quality_presets()) presets.insert(preset_setting(preset, knobs));
    for (const PlannedSetting& planned : plan) {
        EXPECT_TRUE(seen.insert(planned.setting).second);
        const bool is_preset = presets.contains(planned.setting) || planned.setting == plain_setting(knobs);
        EXPECT_EQ(planned.origin == Origin::preset, is_preset);
        const bool one_step =
            std::any_of(presets.begin(), presets.end(), [&](const Setting& preset) { return count_apart(preset, planned.setting) <= 1; });
        EXPECT_TRUE(is_preset || one_step);
    }
    for (const Setting& preset : presets) EXPECT_TRUE(seen.contains(preset));
    EXPECT_GE(plan.size(), 25u);
}

TEST(FirstSettings, HaveEveryValueOfEveryKnobAroundGood) {
    const TurnedKnobs knobs = turned({"samples", "adc-bailout", "distribution"});
    const Setting good = preset_setting(quality_of_name("good"), knobs);
    std::set<Setting> seen;
    for (const PlannedSetting& planned : first_settings(knobs)) seen.insert(planned.setting);
    for (std::size_t i = 0; i < knobs.size(); ++i)
        for (std::size_t value = 0; value < knobs[i]->values.size(); ++value) {
            Setting setting = good;
            setting.values[i] = value;
            EXPECT_TRUE(seen.contains(setting)) << knobs[i]->name << " " << knobs[i]->values[value].name;
        }
}

TEST(IsComparable, UnlessOtherSurfacesAreShown) {
    const TurnedKnobs knobs = turned({"samples", "distribution"});
    Setting setting = preset_setting(quality_of_name("good"), knobs);
    EXPECT_TRUE(is_comparable(setting, knobs));
    setting.values[0] = 0;
    EXPECT_TRUE(is_comparable(setting, knobs));
    setting.values[1] = 1;
    EXPECT_FALSE(is_comparable(setting, knobs));
}

TEST(Prediction, IsRightWhereTimesMultiplyAndErrorsAddAsSquares) {
    const TurnedKnobs knobs = turned({"samples", "max-trace-level", "adc-bailout"});
    const TradeRecord record = measured_record(knobs);
    const Prediction prediction(record);
    for (std::size_t a = 0; a < knobs[0]->values.size(); a += 3)
        for (std::size_t b = 0; b < knobs[1]->values.size(); b += 2)
            for (std::size_t c = 0; c < knobs[2]->values.size(); ++c) {
                const Setting setting{{a, b, c}};
                const std::optional<TradePoint> point = prediction.at(setting, 0);
                ASSERT_TRUE(point);
                EXPECT_NEAR(point->seconds / Model::seconds(setting), 1.0, 1e-9);
                EXPECT_NEAR(point->error, Model::error(setting, knobs), 1e-12);
            }
}

TEST(Prediction, SaysNothingOfValuesThatWereNotMeasured) {
    const TurnedKnobs knobs = turned({"samples", "precision"});
    TradeRecord record = measured_record(knobs);
    Setting setting = record.settings[0].setting;
    setting.values[0] = as_stated;
    EXPECT_FALSE(Prediction(record).at(setting, 0));
    setting.values[0] = 0;
    EXPECT_TRUE(Prediction(record).at(setting, 0));
    std::erase_if(record.alone, [](const AloneError& alone) { return alone.knob == 0 && alone.value == 0; });
    EXPECT_FALSE(Prediction(record).at(setting, 0)) << "without its error alone";
    std::erase_if(record.settings, [](const TradeSetting& s) { return s.setting.values[1] == 0; });
    EXPECT_FALSE(Prediction(record).at({{1, 0}}, 0)) << "without a time";
}

TEST(FurtherSettings, LieBesideTheFrontAndAreNew) {
    const TurnedKnobs knobs = turned({"samples", "max-trace-level", "adc-bailout"});
    const TradeRecord record = measured_record(knobs);
    std::set<Setting> known;
    for (const TradeSetting& setting : record.settings) known.insert(setting.setting);
    const std::vector<Setting> further = further_settings(record, {.most = 7});
    EXPECT_EQ(further.size(), 7u);
    for (const Setting& setting : further) {
        EXPECT_TRUE(known.insert(setting).second);
        bool near = false;
        for (const std::size_t i : front_settings(record)) near = near || count_apart(record.settings[i].setting, setting) <= 2;
        EXPECT_TRUE(near);
    }
}

/// The predictions are right here, so what is found does push the front.
TEST(FurtherSettings, ImproveTheFrontOfSuchAWorld) {
    const TurnedKnobs knobs = turned({"samples", "max-trace-level", "adc-bailout"});
    TradeRecord record = measured_record(knobs);
    std::vector<TradePoint> before;
    for (const std::size_t i : front_settings(record)) before.push_back(point_of(record.settings[i], Cost::wall));
    for (const Setting& setting : further_settings(record, {.most = 5})) {
        measure(record, setting);
        EXPECT_LT(beaten_by(before, point_of(record.settings.back(), Cost::wall)), 0.05);
    }
    EXPECT_GT(front_settings(record).size(), before.size() / 2);
}

TEST(FurtherSettings, FillUpAFewKnobsWithWhateverThereIs) {
    const TurnedKnobs knobs = turned({"samples", "precision"});
    TradeRecord record = measured_record(knobs);
    EXPECT_LT(record.settings.size(), 25u);
    for (const Setting& setting : further_settings(record, {.most = 0, .fill_up_to = 25})) measure(record, setting);
    EXPECT_EQ(record.settings.size(), 25u);
}

TEST(FurtherSettings, LeaveAloneWhatMattersNothing) {
    const TurnedKnobs knobs = turned({"samples", "adc-bailout"});
    TradeRecord record = measured_record(knobs);
    for (AloneError& alone : record.alone)
        if (alone.knob == 1) alone.rmse = 1e-7;
    for (const Setting& setting : further_settings(record, {.most = 20})) {
        bool has_that_bailout = false;
        for (const std::size_t i : front_settings(record))
            has_that_bailout = has_that_bailout || record.settings[i].setting.values[1] == setting.values[1];
        EXPECT_TRUE(has_that_bailout);
    }
}

TEST(KnobSteps, AreMeasuredNeighboursOfOnePreset) {
    const TurnedKnobs knobs = turned({"samples", "max-trace-level", "distribution"});
    const TradeRecord record = measured_record(knobs);
    const std::vector<KnobStep> steps = knob_steps(record);
    std::size_t around_good = 0;
    for (const KnobStep& step : steps) {
        EXPECT_TRUE(step.to == step.from + 1 || knobs[step.knob]->name == "samples");
        EXPECT_NE(knobs[step.knob]->name, "distribution");
        EXPECT_NEAR(step.time_factor(), std::pow(1.5 + 0.1 * static_cast<double>(step.knob), static_cast<double>(step.to - step.from)),
                    1e-9 * step.time_factor());
        EXPECT_LE(step.after.error, step.before.error);
        around_good += step.base == "good";
    }
    constexpr std::size_t methods = 4;  // of samples: the first of each is no step from another
    EXPECT_EQ(around_good, knobs[0]->values.size() - methods + knobs[1]->values.size() - 1);
}

/// "3 x 3" stands behind POV-Ray's methods, which lie between in time: what it is a step from is "2 x 2".
TEST(KnobSteps, StayWithinOneMethodOfSampling) {
    const TurnedKnobs knobs = turned({"samples"});
    const auto words = [&](std::size_t value) { return knobs[0]->values[value].words; };
    std::set<std::pair<std::string_view, std::string_view>> pairs;
    for (const KnobStep& step : knob_steps(measured_record(knobs))) pairs.emplace(words(step.from), words(step.to));
    EXPECT_TRUE(pairs.contains({"--ss 2", "--ss 3"}));
    EXPECT_TRUE(pairs.contains({"--aa 1,0.3,2", "--aa 1,0.1,3"}));
    EXPECT_TRUE(pairs.contains({"--aa 2,0.1,3", "--aa 2,0.03,4"}));
    EXPECT_TRUE(pairs.contains({"--max-error 0.03125", "--max-error 0.015625"}));
    EXPECT_FALSE(pairs.contains({"--aa 2,0.1,3", "--ss 3"}));
}

/// Of settings that the reference cannot tell apart the quickest is on the front.
TEST(FrontSettings, EndWhereTheReferenceEnds) {
    const TurnedKnobs knobs = turned({"samples"});
    TradeRecord record = measured_record(knobs);
    const std::size_t all = front_settings(record).size();
    record.reference.grids = {5, 7}, record.reference.error = 0.5 * Model::alone(0, 4, knobs);
    const std::vector<std::size_t> front = front_settings(record);
    EXPECT_LT(front.size(), all);
    EXPECT_EQ(record.settings[front.back()].setting.values[0], 4u);
    EXPECT_EQ(front_point(record, record.settings[front.back()]).error, record.reference.told_apart());
}

/// The command line refuses it.
TEST(Plan, AsksForNoErrorOfAShareOfThePixels) {
    const TurnedKnobs knobs = turned({"samples", "scale"});
    const TradeRecord record = measured_record(knobs);
    std::size_t shares = 0;
    const auto look = [&](const Setting& setting) {
        const bool share = knobs[1]->values[setting.values[1]].name != "all";
        shares += share;
        EXPECT_FALSE(share && knobs[0]->values[setting.values[0]].words.starts_with("--max-error")) << name_of(setting, knobs);
    };
    for (const PlannedSetting& planned : first_settings(knobs)) look(planned.setting);
    EXPECT_GT(shares, 0u) << "with samples that are counted it is measured";
    for (const Setting& setting : further_settings(record, {100, 200})) look(setting);
}

}  // namespace
}  // namespace rt::plan_test
