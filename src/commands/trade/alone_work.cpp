// The second part of a trade: what a single value costs in accuracy, with everything else exact.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "commands/trade/work.h"

namespace rt {

namespace {

/// Samples of the pictures that only differ in one knob. They lie at the same points, so what they lack is the same in both and hardly
/// matters to the difference.
constexpr int paired_side = 4;

/// A highlight is widened by what one sample covers, so with pairs it would hardly be. The exact setting, which samples by the error,
/// widens it by a whole pixel.
bool hangs_by_samples(const Knob& knob) { return knob.name == "specular-aa"; }

class Alone {
public:
    explicit Alone(TradeWork& work) : work_(work), exact_(exact_setting(work)) {}

    void run() {
        std::size_t done = 0;
        const std::vector<std::pair<std::size_t, std::size_t>> wanted = values();
        for (const auto& [knob, value] : wanted) {
            work_.progress.show(fmt::format("{}/{} values alone: {} {}", ++done, wanted.size(), work_.record.knobs[knob]->name,
                                            value_name(*work_.record.knobs[knob].table, value)));
            if (const std::optional<double> rmse = error_of(knob, value)) work_.record.alone.push_back({knob, value, *rmse});
        }
    }

    void take_known() {
        for (const auto& [knob, value] : values())
            if (const std::optional<double> rmse = known_error(knob, value)) work_.record.alone.push_back({knob, value, *rmse});
    }

private:
    /// Those of the settings that are not known yet, knob by knob.
    std::vector<std::pair<std::size_t, std::size_t>> values() const {
        std::set<std::pair<std::size_t, std::size_t>> list;
        for (const TradeSetting& setting : work_.record.settings)
            for (std::size_t i = 0; i < setting.setting.values.size(); ++i)
                if (const std::size_t value = setting.setting.values[i]; value != as_stated && !alone_error(work_.record, i, value))
                    list.emplace(i, value);
        return {list.begin(), list.end()};
    }

    const Knob& table(std::size_t knob) const { return *work_.record.knobs[knob].table; }
    /// Whether the samples are those of the exact setting, instead of pairs.
    bool has_own_samples(std::size_t knob) const { return chooses_samples(table(knob)) || hangs_by_samples(table(knob)); }

    Setting setting_of(std::size_t knob, std::size_t value) const {
        Setting setting = exact_;
        setting.values[knob] = value;
        return setting;
    }
    std::string words(std::size_t knob, std::size_t value) const {
        return fmt::format("{} rays: {}", has_own_samples(knob) ? work_.record.reference.samples : paired_side * paired_side,
                           joined_words(setting_of(knob, value), work_.record.knobs));
    }
    bool is_exact(std::size_t knob, std::size_t value) const { return !chooses_samples(table(knob)) && value == exact_.values[knob]; }
    std::optional<double> known_error(std::size_t knob, std::size_t value) const {
        return is_exact(knob, value) ? 0.0 : work_.store.alone(words(knob, value));
    }

    /// Nothing for a value that makes renders too slow, or that there is no time for.
    std::optional<double> error_of(std::size_t knob, std::size_t value) {
        if (const std::optional<double> known = known_error(knob, value)) return known;
        RenderJob job = work_.scene.job_of(words_of(setting_of(knob, value), work_.record.knobs));
        if (!has_own_samples(knob)) job = with_grid(job, paired_side);
        const World world = work_.scene.build(job);
        const double limit = std::min(work_.request.run_seconds, work_.clock.left_for(TradePart::alone));
        if (limit <= 0.0 || expected_seconds(work_, world, job, limit) > limit) {
            work_.record.out_of_time |= limit < work_.request.run_seconds;
            return std::nullopt;
        }
        const std::optional<RenderResult> result = work_.scene.trace_within(2.0 * limit, world, job);
        if (!result) return std::nullopt;
        const StoredImage shown = work_.scene.shown(result->film);
        const double rmse = rmse_between(has_own_samples(knob) ? work_.reference : exact_picture(), shown);
        const double alone = hangs_by_samples(table(knob)) ? without_sampling(rmse) : rmse;
        work_.store.put_alone(words(knob, value), alone);
        return alone;
    }

    /// What is left of an error of the exact setting's samples when the error of these samples is taken away.
    double without_sampling(double rmse) {
        if (!exact_error_) exact_error_ = rmse_between(work_.reference, exact_picture_of_its_own());
        return std::sqrt(std::max(0.0, rmse * rmse - *exact_error_ * *exact_error_));
    }

    const StoredImage& exact_picture() {
        if (paired_.values.empty()) {
            const RenderJob job = with_grid(exact_job(work_), paired_side);
            paired_ = work_.scene.shown(work_.scene.trace(work_.scene.build(job), job).film);
        }
        return paired_;
    }

    StoredImage exact_picture_of_its_own() const {
        const RenderJob job = exact_job(work_);
        return work_.scene.shown(work_.scene.trace(work_.scene.build(job), job).film);
    }

    TradeWork& work_;
    Setting exact_;
    StoredImage paired_;                 ///< the exact picture with the same samples
    std::optional<double> exact_error_;  ///< of the exact setting, with its own samples
};

}  // namespace

void measure_alone(TradeWork& work) { Alone(work).run(); }
void take_known_alone(TradeWork& work) { Alone(work).take_known(); }

}  // namespace rt
