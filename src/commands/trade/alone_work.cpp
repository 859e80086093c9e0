// The second part of a trade: what a single value costs in accuracy, with everything else exact.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "commands/trade/work.h"

namespace rt {

namespace {

/// Samples of the pictures that only differ in one knob. They lie at the same points, so what they lack is the same in both and hardly
/// matters to the difference.
constexpr int paired_side = 4;

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

    /// Nothing for a value that makes renders too slow, or that there is no time for.
    std::optional<double> error_of(std::size_t knob, std::size_t value) {
        const bool samples = chooses_samples(*work_.record.knobs[knob].table);
        if (!samples && value == exact_.values[knob]) return 0.0;
        Setting setting = exact_;
        setting.values[knob] = value;
        const std::string words = fmt::format("{} rays: {}", samples ? work_.record.reference.samples : paired_side * paired_side,
                                              joined_words(setting, work_.record.knobs));
        if (const std::optional<double> known = work_.store.alone(words)) return known;
        RenderJob job = work_.scene.job_of(words_of(setting, work_.record.knobs));
        if (!samples) job = with_grid(job, paired_side);
        const World world = work_.scene.build(job);
        const double limit = std::min(work_.request.run_seconds, work_.clock.left_for(TradePart::alone));
        if (limit <= 0.0 || expected_seconds(work_, world, job, limit) > limit) {
            work_.record.out_of_time |= limit < work_.request.run_seconds;
            return std::nullopt;
        }
        const std::optional<RenderResult> result = work_.scene.trace_within(2.0 * limit, world, job);
        if (!result) return std::nullopt;
        const double rmse = rmse_between(samples ? work_.reference : exact_picture(), work_.scene.shown(result->film));
        work_.store.put_alone(words, rmse);
        return rmse;
    }

    const StoredImage& exact_picture() {
        if (paired_.values.empty()) {
            const RenderJob job = with_grid(exact_job(work_), paired_side);
            paired_ = work_.scene.shown(work_.scene.trace(work_.scene.build(job), job).film);
        }
        return paired_;
    }

    TradeWork& work_;
    Setting exact_;
    StoredImage paired_;  ///< the exact picture with the same samples
};

}  // namespace

void measure_alone(TradeWork& work) { Alone(work).run(); }

}  // namespace rt
