#include "commands/trade/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "commands/trade/plan.h"

namespace rt {

namespace fs = std::filesystem;

RenderJob exact_job(const TradeWork& work) { return work.scene.job_of(words_of(exact_setting(work), work.record.knobs)); }

RenderJob with_grid(RenderJob job, int side) {
    job.sampling.method = Sampling::Method::grid;
    job.sampling.depth = side;
    return job;
}

Setting exact_setting(const TradeWork& work) { return preset_setting(quality_of_name("exact"), work.record.knobs); }

std::string joined_words(const Setting& setting, const TurnedKnobs& knobs) {
    return fmt::format("{}", fmt::join(words_of(setting, knobs), " "));
}

bool chooses_samples(const Knob& knob) { return knob.name == "samples"; }

double expected_seconds(const TradeWork& work, const World& world, const RenderJob& job, double enough) {
    double expected = 0.0, before = 0.0;
    for (const int share : {16, 8, 4, 2}) {
        RenderJob small = job;
        small.width = std::max(1, job.width / share), small.height = std::max(1, job.height / share);
        Timing timing;
        work.scene.trace(world, small, &timing);
        const double seconds = timing.wall.trace, pixels = static_cast<double>(job.width) * job.height;
        const double growth = pixels / (static_cast<double>(small.width) * small.height);
        expected = growth * seconds;
        if (expected <= enough) break;
        // Sampling by error takes more of each pixel the smaller the picture is: its time grows with less than the number of pixels.
        const double power = before > 0.0 ? std::clamp(std::log(seconds / before) / std::log(4.0), 0.5, 1.0) : 0.5;
        expected = std::pow(growth, power) * seconds;
        if (expected > 2.0 * enough || seconds > 0.25 * enough) break;
        before = seconds;
    }
    return expected;
}

std::string picture_path(const std::string& folder, const std::string& setting_name) {
    return (fs::path(folder) / "pictures" / (file_name_of(setting_name) + ".png")).string();
}

std::string reference_path(const std::string& folder) { return (fs::path(folder) / "pictures" / "reference.png").string(); }

void add_setting(TradeRecord& record, const Setting& setting, Origin origin) {
    TradeSetting added;
    added.setting = setting, added.origin = origin;
    added.name = name_of(setting, record.knobs);
    added.comparable = is_comparable(setting, record.knobs);
    record.settings.push_back(std::move(added));
}

void remember(const TradeWork& work) {
    std::vector<KnownSetting> list;
    for (const TradeSetting& setting : work.record.settings)
        list.push_back({setting.setting, setting.origin, setting.state == SettingState::too_slow, setting.expected_seconds});
    work.store.put_settings(list);
}

void recall(TradeWork& work) {
    std::vector<TradeSetting>& settings = work.record.settings;
    for (const KnownSetting& known : work.store.settings()) {
        if (known.setting.values.size() != work.record.knobs.size()) continue;
        const auto is_it = [&](const TradeSetting& setting) { return setting.setting == known.setting; };
        if (std::none_of(settings.begin(), settings.end(), is_it)) add_setting(work.record, known.setting, known.origin);
        TradeSetting& setting = *std::find_if(settings.begin(), settings.end(), is_it);
        if (setting.state == SettingState::not_run && known.too_slow)
            setting.state = SettingState::too_slow, setting.expected_seconds = known.expected_seconds;
    }
    take_known_settings(work), take_known_alone(work), take_known_instability(work);
}

namespace {

/// Measured less often than wanted, or not at all, for no reason but time.
bool is_unfinished(const TradeSetting& setting, const TradeWork& work) {
    return setting.state != SettingState::too_slow && !is_measured(run_seconds(setting.measured, work.record.cost), work.request.rule);
}

/// What lies around the front, and around what was found there; at last whatever else, if all of it is not much.
void search_further(TradeWork& work) {
    constexpr std::size_t passes = 3, a_pass = 10;
    for (std::size_t pass = 1; pass <= passes && work.clock.left_for(TradePart::further) > 0.0; ++pass) {
        const std::size_t room = work.request.most_settings - std::min(work.request.most_settings, work.record.settings.size());
        const std::vector<Setting> found = further_settings(
            work.record, {std::min(a_pass, room), pass == passes ? std::min(least_settings, work.request.most_settings) : 0});
        for (const Setting& setting : found) add_setting(work.record, setting, Origin::neighbour);
        measure_alone(work);
        measure_settings(work, TradePart::further);
        std::erase_if(work.record.settings, [](const TradeSetting& setting) {
            return setting.origin == Origin::neighbour && setting.state == SettingState::not_run;
        });
    }
}

}  // namespace

void carry_out(TradeWork& work) {
    make_reference(work);
    for (const PlannedSetting& planned : first_settings(work.record.knobs))
        if (work.record.settings.size() < work.request.most_settings) add_setting(work.record, planned.setting, planned.origin);
    measure_alone(work);
    measure_settings(work, TradePart::settings);
    search_further(work);
    measure_instability(work);
    work.record.out_of_time |= std::any_of(work.record.settings.begin(), work.record.settings.end(),
                                           [&](const TradeSetting& setting) { return is_unfinished(setting, work); });
}

}  // namespace rt
