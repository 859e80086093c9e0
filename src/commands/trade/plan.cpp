#include "commands/trade/plan.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace rt {

namespace {

/// A list of settings that a command line takes, without repetitions.
class PlanList {
public:
    explicit PlanList(const TurnedKnobs& knobs) : knobs_(knobs) {}
    void add(const Setting& setting, Origin origin) {
        if (goes_together(setting, knobs_) && known_.insert(setting).second) list.push_back({setting, origin});
    }
    std::vector<PlannedSetting> list;

private:
    const TurnedKnobs& knobs_;
    std::set<Setting> known_;
};

Setting with(const Setting& setting, std::size_t knob, std::size_t value) {
    Setting changed = setting;
    changed.values[knob] = value;
    return changed;
}

/// The value so many steps further; nothing beyond the ends and from a value that has no place in the table.
std::optional<std::size_t> stepped(const Knob& knob, std::size_t value, int steps) {
    if (value == as_stated || !knob.converges) return std::nullopt;
    const long place = static_cast<long>(value) + steps;
    if (place < 0 || place >= static_cast<long>(knob.values.size())) return std::nullopt;
    return static_cast<std::size_t>(place);
}

/// The knobs of which some value is off by more than the rounding to the steps in which pictures are compared.
std::vector<std::size_t> knobs_that_matter(const TradeRecord& record) {
    constexpr double rounding = 1.0 / 65535.0;
    std::set<std::size_t> list;
    for (const AloneError& alone : record.alone)
        if (alone.rmse > rounding) list.insert(alone.knob);
    return {list.begin(), list.end()};
}

/// Calls visit(setting) for each one that differs in one or two of these knobs by at most `radius` steps.
template <typename Visit>
void each_neighbour(const Setting& from, const TurnedKnobs& knobs, const std::vector<std::size_t>& turned, int radius, const Visit& visit) {
    const auto each_step = [&](const Setting& setting, std::size_t knob, const auto& then) {
        for (int steps = -radius; steps <= radius; ++steps)
            if (const std::optional<std::size_t> value = stepped(*knobs[knob].table, setting.values[knob], steps); value && steps != 0)
                then(with(setting, knob, *value));
    };
    for (std::size_t i = 0; i < turned.size(); ++i)
        each_step(from, turned[i], [&](const Setting& one) {
            visit(one);
            for (std::size_t j = i + 1; j < turned.size(); ++j) each_step(one, turned[j], visit);
        });
}

struct Candidate {
    Setting setting;
    double beaten = 0.0;
};

/// Of all neighbours that are not in the record, the least beaten first.
std::vector<Candidate> candidates(const TradeRecord& record, int radius) {
    const Prediction prediction(record);
    const std::vector<std::size_t> front = front_settings(record);
    std::vector<TradePoint> points;
    for (const std::size_t i : front) points.push_back(front_point(record, record.settings[i]));
    std::set<Setting> known;
    for (const TradeSetting& setting : record.settings) known.insert(setting.setting);
    const std::vector<std::size_t> turned = knobs_that_matter(record);
    std::vector<Candidate> list;
    for (const std::size_t from : front)
        each_neighbour(record.settings[from].setting, record.knobs, turned, radius, [&](const Setting& setting) {
            if (known.contains(setting) || !goes_together(setting, record.knobs)) return;
            const std::optional<TradePoint> point = prediction.at(setting, from);
            if (!point) return;
            known.insert(setting);
            list.push_back({setting, beaten_by(points, *point)});
        });
    std::stable_sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) { return a.beaten < b.beaten; });
    return list;
}

}  // namespace

std::vector<PlannedSetting> first_settings(const TurnedKnobs& knobs) {
    PlanList plan(knobs);
    std::vector<Setting> presets;
    for (const QualityPreset& preset : quality_presets()) presets.push_back(preset_setting(preset, knobs));
    for (const Setting& preset : presets) plan.add(preset, Origin::preset);
    plan.add(plain_setting(knobs), Origin::preset);
    const Setting good = preset_setting(quality_of_name("good"), knobs);
    for (std::size_t i = 0; i < knobs.size(); ++i)
        for (std::size_t value = 0; value < knobs[i]->values.size(); ++value) plan.add(with(good, i, value), Origin::step);
    for (const Setting& preset : presets)
        for (std::size_t i = 0; i < knobs.size(); ++i)
            for (const int steps : {-1, 1})
                if (const std::optional<std::size_t> value = stepped(*knobs[i].table, preset.values[i], steps))
                    plan.add(with(preset, i, *value), Origin::step);
    return plan.list;
}

bool is_comparable(const Setting& setting, const TurnedKnobs& knobs) {
    const Setting plain = plain_setting(knobs);
    for (std::size_t i = 0; i < knobs.size(); ++i)
        if (!knobs[i]->converges && setting.values[i] != plain.values[i]) return false;
    return true;
}

Prediction::Prediction(const TradeRecord& record) : record_(record) {
    for (const TurnedKnob& knob : record.knobs) factors_.emplace_back(knob->values.size());
    for (std::size_t i = 0; i < record.knobs.size(); ++i) find_factors(i);
}

/// Values are tied together by pairs of measured settings that differ in this knob alone; the mean of a tie's logarithms counts.
void Prediction::find_factors(std::size_t knob) {
    std::vector<Factor>& factors = factors_[knob];
    const std::size_t count = factors.size();
    std::vector<std::vector<std::pair<double, int>>> ties(count, std::vector<std::pair<double, int>>(count));
    const std::vector<std::size_t> measured = comparable_settings(record_);
    for (const std::size_t a : measured)
        for (const std::size_t b : measured) {
            const Setting &first = record_.settings[a].setting, &second = record_.settings[b].setting;
            const std::size_t from = first.values[knob], to = second.values[knob];
            if (from == to || from == as_stated || to == as_stated || with(first, knob, to) != second) continue;
            auto& [sum, pairs] = ties[from][to];
            sum += std::log(point_of(record_.settings[b], record_.cost).seconds / point_of(record_.settings[a], record_.cost).seconds);
            ++pairs;
        }
    const auto first_tied = std::find_if(ties.begin(), ties.end(), [](const auto& row) {
        return std::any_of(row.begin(), row.end(), [](const auto& tie) { return tie.second > 0; });
    });
    if (first_tied == ties.end()) return;
    std::vector<std::size_t> open{static_cast<std::size_t>(first_tied - ties.begin())};
    factors[open[0]].known = true;
    for (std::size_t at = 0; at < open.size(); ++at)
        for (std::size_t to = 0; to < count; ++to) {
            const auto& [sum, pairs] = ties[open[at]][to];
            if (pairs == 0 || factors[to].known) continue;
            factors[to] = {true, factors[open[at]].logarithm + sum / pairs};
            open.push_back(to);
        }
}

std::optional<TradePoint> Prediction::at(const Setting& setting, std::size_t from) const {
    const TradeSetting& known = record_.settings[from];
    double logarithm = 0.0, square = 0.0;
    for (std::size_t i = 0; i < setting.values.size(); ++i) {
        const std::size_t value = setting.values[i], before = known.setting.values[i];
        const std::optional<double> alone = alone_error(record_, i, value);
        if (!alone) return std::nullopt;
        square += *alone * *alone;
        if (value == before) continue;
        const Factor &a = factors_[i][before], &b = factors_[i][value];
        if (!a.known || !b.known) return std::nullopt;
        logarithm += b.logarithm - a.logarithm;
    }
    const double error = std::max(std::sqrt(square), record_.reference.told_apart());
    return TradePoint{point_of(known, record_.cost).seconds * std::exp(logarithm), error};
}

std::vector<Setting> further_settings(const TradeRecord& record, const FurtherWish& wish) {
    constexpr double hardly = 0.05;  // predictions are no better than that
    std::vector<Setting> chosen;
    std::vector<Candidate> list = candidates(record, 1);
    for (const Candidate& candidate : list)
        if (candidate.beaten < hardly && chosen.size() < wish.most) chosen.push_back(candidate.setting);
    std::size_t widest = 0;
    for (const TurnedKnob& knob : record.knobs) widest = std::max(widest, knob->values.size());
    for (int radius = 1; record.settings.size() + chosen.size() < wish.fill_up_to && radius < static_cast<int>(widest); ++radius) {
        if (radius > 1) list = candidates(record, radius);
        for (const Candidate& candidate : list) {
            const bool is_new = std::find(chosen.begin(), chosen.end(), candidate.setting) == chosen.end();
            if (is_new && record.settings.size() + chosen.size() < wish.fill_up_to) chosen.push_back(candidate.setting);
        }
    }
    return chosen;
}

}  // namespace rt
