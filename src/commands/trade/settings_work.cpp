// The third part of a trade: times and errors of the settings.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>

#include "commands/base/content_hash.h"
#include "commands/base/write_bytes.h"
#include "commands/trade/work.h"
#include "grading/difference.h"

namespace rt {

namespace {

/// The median of each phase by itself.
Phases median_phases(const std::vector<Timing>& runs, Cost cost) {
    Phases medians;
    for (double Phases::*phase : {&Phases::parse, &Phases::build, &Phases::trace, &Phases::write}) {
        std::vector<double> seconds;
        for (const Timing& run : runs) seconds.push_back(phases_of(run, cost).*phase);
        medians.*phase = median(seconds);
    }
    return medians;
}

class SettingsWork {
public:
    SettingsWork(TradeWork& work, TradePart part) : work_(work), part_(part) {
        for (TradeSetting& setting : work_.record.settings)
            if (setting.state == SettingState::not_run) take_known(setting);
    }

    /// Rounds of one run of each setting, so that what else the machine does falls on all of them alike; every other round backwards.
    void run() {
        for (std::size_t round = 0;; ++round) {
            std::vector<std::size_t> open = open_settings();
            if (open.empty()) return;
            if (round % 2 == 1) std::reverse(open.begin(), open.end());
            run_round(open);
        }
    }

private:
    /// A setting's words, with what its error is counted from.
    std::string words(const TradeSetting& setting) const {
        return fmt::format("{} rays: {}", work_.record.reference.samples, joined_words(setting.setting, work_.record.knobs));
    }

    /// The words of the knobs that a world depends on.
    std::string world_words(const TradeSetting& setting) const {
        std::string text;
        for (std::size_t i = 0; i < setting.setting.values.size(); ++i)
            if (const std::size_t value = setting.setting.values[i]; value != as_stated && work_.record.knobs[i]->builds)
                text += fmt::format("{} ", work_.record.knobs[i]->values[value].words);
        return text;
    }

    /// Of an earlier trade, unless its picture has gone.
    void take_known(TradeSetting& setting) {
        std::optional<Measured> known = work_.store.measured(words(setting));
        if (!known || known->runs.empty()) return;
        if (hash_of_file(picture_path(work_.request.folder, setting.name)) != known->picture) return;
        setting.measured = std::move(*known);
        settle(setting);
    }

    bool is_open(const TradeSetting& setting) const {
        return setting.state != SettingState::too_slow && !no_time_for_.contains(setting.setting) &&
               !is_measured(run_seconds(setting.measured, work_.record.cost), work_.request.rule) &&
               (least_runs_left(setting) > 0 || work_.clock.left_for(part_) > 0.0);
    }

    /// What the settings that were begun will take until each has the least number of runs.
    double promised_seconds() const {
        double seconds = 0.0;
        for (const TradeSetting& setting : work_.record.settings)
            if (!setting.measured.runs.empty() && is_open(setting)) seconds += least_runs_left(setting) * total(setting.median.wall);
        return seconds;
    }
    int least_runs_left(const TradeSetting& setting) const {
        return std::max(0, work_.request.rule.least - static_cast<int>(setting.measured.runs.size()));
    }

    /// Presets first; then those with the same world stand together.
    std::vector<std::size_t> open_settings() const {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < work_.record.settings.size(); ++i)
            if (is_open(work_.record.settings[i])) open.push_back(i);
        const auto key = [&](std::size_t i) {
            const TradeSetting& setting = work_.record.settings[i];
            return std::pair(setting.origin != Origin::preset, world_words(setting));
        };
        std::stable_sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
        return open;
    }

    void run_round(const std::vector<std::size_t>& open) {
        for (std::size_t first = 0; first < open.size();) {
            const std::string shared = world_words(work_.record.settings[open[first]]);
            Timing built;
            const World world =
                work_.scene.build(work_.scene.job_of(words_of(work_.record.settings[open[first]].setting, work_.record.knobs)), &built);
            for (; first < open.size() && world_words(work_.record.settings[open[first]]) == shared; ++first)
                if (TradeSetting& setting = work_.record.settings[open[first]]; is_open(setting)) run_once(setting, world, built);
        }
    }

    void run_once(TradeSetting& setting, const World& world, Timing timing) {
        tell(setting);
        const RenderJob job = work_.scene.job_of(words_of(setting.setting, work_.record.knobs));
        if (setting.measured.runs.empty()) {
            setting.expected_seconds = expected_seconds(work_, world, job, work_.request.run_seconds);
            if (!is_worth_beginning(setting)) return;
        }
        const std::optional<RenderResult> result = first_or_further(setting, world, job, timing);
        if (!result) return;
        const std::string png = work_.scene.picture(result->film, job, &timing);
        if (setting.measured.runs.empty()) judge(setting, *result, png);
        setting.measured.runs.push_back(timing);
        settle(setting);
        work_.store.put_measured(words(setting), setting.measured);
    }

    /// Of the clock. The others stand beside the presets.
    double longest_run(const TradeSetting& setting) const {
        return (setting.origin == Origin::preset ? 3.0 : 1.0) * work_.request.run_seconds;
    }

    /// A first run may turn out slower than a small picture foretold: sampling by error may find a pixel that never settles.
    std::optional<RenderResult> first_or_further(TradeSetting& setting, const World& world, const RenderJob& job, Timing& timing) const {
        if (!setting.measured.runs.empty()) return work_.scene.trace(world, job, &timing);
        const double most = 2.0 * longest_run(setting);
        std::optional<RenderResult> result = work_.scene.trace_within(most, world, job, &timing);
        if (!result) setting.state = SettingState::too_slow, setting.expected_seconds = most;
        return result;
    }

    bool is_worth_beginning(TradeSetting& setting) {
        if (setting.expected_seconds > longest_run(setting)) {
            setting.state = SettingState::too_slow;
            return false;
        }
        const double needed = promised_seconds() + work_.request.rule.least * setting.expected_seconds;
        if (setting.origin == Origin::preset || needed <= work_.clock.left_for(part_)) return true;
        no_time_for_.insert(setting.setting);
        return false;
    }

    void judge(TradeSetting& setting, const RenderResult& result, const std::string& png) const {
        Measured& measured = setting.measured;
        const Difference d = compare(work_.reference, work_.scene.shown(result.film), {});
        measured.error = {d.rmse, d.p99, d.max, d.flip_mean};
        measured.rays = result.counts, measured.non_finite = result.non_finite;
        write_bytes(picture_path(work_.request.folder, setting.name), png);
        measured.picture = hash_of(png);  // by which a picture that was not written to its end is known
    }

    void settle(TradeSetting& setting) const {
        setting.state = SettingState::measured;
        setting.median = {median_phases(setting.measured.runs, Cost::wall), median_phases(setting.measured.runs, Cost::cpu)};
        setting.median.wall.parse = work_.scene.reading().wall.parse;
        setting.median.cpu.parse = work_.scene.reading().cpu.parse;
        setting.spread = median_spread(run_seconds(setting.measured, work_.record.cost));
    }

    /// Runs that are still needed at least, and what they will take.
    void tell(const TradeSetting& setting) const {
        std::size_t settled = 0;
        double left = 0.0, known = 0.0;
        std::size_t unknown = 0;
        for (const TradeSetting& other : work_.record.settings) {
            const double runs_left = std::max(1, least_runs_left(other));
            if (!is_open(other))
                ++settled;
            else if (other.measured.runs.empty())
                ++unknown;
            else
                left += runs_left * total(other.median.wall);
            if (!other.measured.runs.empty()) known += total(other.median.wall);
        }
        const double seen = static_cast<double>(work_.record.settings.size() - unknown);
        if (seen > 0.0) left += static_cast<double>(unknown) * work_.request.rule.least * known / seen;
        work_.progress.show(fmt::format("{}/{} settings in {}: {} (run {})", settled, work_.record.settings.size(), duration_text(left),
                                        setting.name, setting.measured.runs.size() + 1));
    }

    TradeWork& work_;
    TradePart part_;
    std::set<Setting> no_time_for_;
};

}  // namespace

void measure_settings(TradeWork& work, TradePart part) { SettingsWork(work, part).run(); }
void take_known_settings(TradeWork& work) { SettingsWork(work, TradePart::settings); }

}  // namespace rt
