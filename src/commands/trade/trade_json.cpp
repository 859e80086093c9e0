#include <fmt/format.h>

#include <cmath>

#include "commands/base/program.h"
#include "commands/base/shell_words.h"
#include "commands/trade/sensitivity.h"
#include "commands/trade/trade_reports.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

constexpr NameTable<ErrorSource, 3> source_names{
    {{"sampling", ErrorSource::sampling}, {"model", ErrorSource::model}, {"precision", ErrorSource::precision}}};

Json phases_json(const Phases& p) {
    return {{"parse", p.parse}, {"build", p.build}, {"trace", p.trace}, {"write", p.write}, {"total", total(p)}};
}

Json rays_json(const RayCounts& rays) {
    return {{"camera", rays.camera},
            {"shadow", rays.shadow},
            {"reflected", rays.reflected},
            {"refracted", rays.refracted},
            {"edge", rays.edge}};
}

Json knobs_json(const TradeRecord& record) {
    Json list = Json::array();
    for (std::size_t i = 0; i < record.knobs.size(); ++i) {
        const Knob& knob = *record.knobs[i].table;
        Json values = Json::array();
        for (std::size_t value = 0; value < knob.values.size(); ++value) {
            values.push_back({{"name", knob.values[value].name}, {"words", knob.values[value].words}});
            if (const std::optional<double> alone = alone_error(record, i, value)) values.back()["rmse_alone"] = *alone;
        }
        list.push_back({{"name", knob.name},
                        {"changes", knob.changes},
                        {"source", name_of(source_names, knob.source)},
                        {"converges", knob.converges},
                        {"values", values}});
    }
    return list;
}

/// The errors of a setting's values alone, and their sums by source: roots of sums of squares.
Json sources_json(const TradeRecord& record, const TradeSetting& setting) {
    Json sources, knobs;
    double squares[3] = {};
    for (std::size_t i = 0; i < record.knobs.size(); ++i) {
        const std::optional<double> alone = alone_error(record, i, setting.setting.values[i]);
        if (!alone) continue;
        knobs[std::string(record.knobs[i]->name)] = *alone;
        squares[static_cast<std::size_t>(record.knobs[i]->source)] += *alone * *alone;
    }
    for (const auto& [name, source] : source_names) sources[std::string(name)] = std::sqrt(squares[static_cast<std::size_t>(source)]);
    return {{"by_source", sources}, {"by_knob", knobs}};
}

Json unstable_json(const UnstableCount& unstable) {
    Json causes = Json::object();
    for (const auto& [name, cause] : unstable_cause_names) causes[std::string(name)] = unstable.by_cause[static_cast<std::size_t>(cause)];
    return {{"pixels", unstable.pixels}, {"by_cause", causes}};
}

Json setting_json(const TradeRecord& record, const TradeSetting& setting) {
    Json values;
    for (std::size_t i = 0; i < record.knobs.size(); ++i)
        values[std::string(record.knobs[i]->name)] = value_name(*record.knobs[i].table, setting.setting.values[i]);
    Json json = {{"name", setting.name},
                 {"origin", name_of(origin_names, setting.origin)},
                 {"state", name_of(setting_state_names, setting.state)},
                 {"values", values},
                 {"command", command_text(record, setting)}};
    if (setting.state == SettingState::too_slow) json["expected_seconds"] = setting.expected_seconds;
    if (setting.state != SettingState::measured) return json;
    const Measured& m = setting.measured;
    json["front"] = setting.on_front, json["comparable"] = setting.comparable;
    json["runs"] = m.runs.size();
    if (std::isfinite(setting.spread)) json["spread"] = setting.spread;
    json["wall"] = phases_json(setting.median.wall), json["cpu"] = phases_json(setting.median.cpu);
    json["rays"] = rays_json(m.rays), json["non_finite"] = m.non_finite;
    json["error"] = {{"rmse", m.error.rmse}, {"p99", m.error.p99}, {"max", m.error.max}, {"flip", m.error.flip}};
    json["alone"] = sources_json(record, setting);
    if (setting.unstable) json["unstable"] = unstable_json(*setting.unstable);
    json["picture"] = fmt::format("pictures/{}.png", file_name_of(setting.name));
    return json;
}

Json steps_json(const TradeRecord& record) {
    Json list = Json::array();
    for (const KnobStep& step : knob_steps(record)) {
        const Knob& knob = *record.knobs[step.knob].table;
        list.push_back({{"knob", knob.name},
                        {"preset", step.base},
                        {"from", knob.values[step.from].name},
                        {"to", knob.values[step.to].name},
                        {"seconds", {step.before.seconds, step.after.seconds}},
                        {"time_factor", step.time_factor()},
                        {"rmse", {step.before.error, step.after.error}}});
    }
    return list;
}

}  // namespace

std::string command_text(const TradeRecord& record, const TradeSetting& setting) {
    std::string text = fmt::format("raytrace {}", shell_word(record.scene));
    for (const std::string& word : record.words) text += fmt::format(" {}", shell_word(word));
    for (const std::string& words : words_of(setting.setting, record.knobs)) text += fmt::format(" {}", words);
    return text + fmt::format(" --threads={} -o {}", record.threads, shell_word(file_name_of(setting.name) + ".png"));
}

Json trade_json(const TradeRecord& record) {
    const ReferenceFacts& reference = record.reference;
    Json settings = Json::array(), front = Json::array();
    for (const TradeSetting& setting : record.settings) settings.push_back(setting_json(record, setting));
    for (const std::size_t i : front_settings(record)) front.push_back(record.settings[i].name);
    return {{"format", "raytrace trade 1"},
            {"version", program_version()},
            {"scene", record.scene},
            {"words", record.words},
            {"size", record.size},
            {"threads", record.threads},
            {"processors", record.processors},
            {"cost", name_of(cost_names, record.cost)},
            {"complete", record.complete},
            {"out_of_time", record.out_of_time},
            {"reference",
             {{"samples", reference.samples},
              {"rmse_estimated", reference.error},
              {"rmse_asked", reference.asked},
              {"rmse_told_apart", reference.told_apart()},
              {"seconds", reference.seconds},
              {"grids", reference.grids},
              {"picture", "pictures/reference.png"}}},
            {"knobs", knobs_json(record)},
            {"front_margins",
             {{"worth", FrontMargins{}.worth}, {"same_time", FrontMargins{}.same_time}, {"same_error", FrontMargins{}.same_error}}},
            {"front", front},
            {"steps", steps_json(record)},
            {"settings", settings}};
}

}  // namespace rt
