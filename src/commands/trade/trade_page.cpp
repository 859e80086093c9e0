#include "commands/trade/trade_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "commands/report/report_page.h"
#include "commands/trade/trade_reports.h"
#include "commands/trade/work.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<ReportColumn> columns(const TradeRecord& record) {
    std::vector<ReportColumn> list = {{"name", "Setting", CellKind::text, ""},
                                      {"outcome", "Front", CellKind::outcome, "whether no other setting is quicker and more exact"},
                                      {"wall", "Clock", CellKind::seconds, "medians of reading, building, tracing and encoding, added"},
                                      {"cpu", "Processors", CellKind::seconds, "the same in seconds of all processors"},
                                      {"trace", "Trace", CellKind::seconds, "seconds of the clock"},
                                      {"rmse", "RMSE", CellKind::figure, "against the reference, encoded, 1 is full scale"},
                                      {"p99", "p99", CellKind::figure, "99 % of the pixels differ by no more than that"},
                                      {"max", "Max", CellKind::figure, "largest difference of a channel"},
                                      {"flip", "FLIP", CellKind::figure, "mean LDR-FLIP"},
                                      {"rays", "Rays", CellKind::count, "of all kinds"}};
    const auto counted = [](const TradeSetting& setting) { return setting.unstable.has_value(); };
    if (std::any_of(record.settings.begin(), record.settings.end(), counted))
        list.push_back({"unstable", "Unstable", CellKind::count, "pixels that move with the rounding of numbers"});
    for (const TurnedKnob& knob : record.knobs)
        list.push_back({fmt::format("knob {}", knob->name), std::string(knob->name), CellKind::text, std::string(knob->changes)});
    return list;
}

std::string_view outcome_of(const TradeSetting& setting) {
    if (setting.state != SettingState::measured) return name_of(setting_state_names, setting.state);
    if (!setting.comparable) return "other surfaces";
    return setting.on_front ? "front" : "beaten";
}

Json cells_of(const TradeRecord& record, const TradeSetting& setting) {
    Json cells = {{"name", setting.name}, {"outcome", outcome_of(setting)}};
    for (std::size_t i = 0; i < record.knobs.size(); ++i)
        cells[fmt::format("knob {}", record.knobs[i]->name)] = value_name(*record.knobs[i].table, setting.setting.values[i]);
    if (setting.state != SettingState::measured) return cells;
    const Measured& m = setting.measured;
    cells["wall"] = total(setting.median.wall), cells["cpu"] = total(setting.median.cpu), cells["trace"] = setting.median.wall.trace;
    cells["rmse"] = m.error.rmse, cells["p99"] = m.error.p99, cells["max"] = m.error.max, cells["flip"] = m.error.flip;
    cells["rays"] = m.rays.camera + m.rays.shadow + m.rays.reflected + m.rays.refracted + m.rays.edge;
    if (setting.unstable) cells["unstable"] = setting.unstable->pixels;
    return cells;
}

Json phases_json(std::string_view name, const Phases& p) {
    return Json::array({name, Json::array({Json::array({"parse", p.parse}), Json::array({"build", p.build}),
                                           Json::array({"trace", p.trace}), Json::array({"write", p.write})})});
}

Json facts_of(const TradeSetting& setting) {
    const Measured& m = setting.measured;
    Json facts = Json::array();
    const std::string spread = std::isfinite(setting.spread) ? fmt::format(", the median within {:.1f} %", 100.0 * setting.spread) : "";
    facts.push_back({"Runs", fmt::format("{}{}", m.runs.size(), spread)});
    facts.push_back({"Rays", fmt::format("{} from the camera, {} to lights, {} mirrored, {} refracted", m.rays.camera, m.rays.shadow,
                                         m.rays.reflected, m.rays.refracted)});
    if (m.non_finite) facts.push_back({"Not finite", fmt::format("{} pixels, which are black", m.non_finite)});
    if (setting.unstable) facts.push_back({"Unstable", unstable_text(*setting.unstable)});
    return facts;
}

ReportRow row_of(const TradeRecord& record, const TradeSetting& setting, const std::string& folder) {
    ReportRow row;
    const bool measured = setting.state == SettingState::measured;
    row.data = {{"name", setting.name},
                {"good", setting.on_front},
                {"cells", cells_of(record, setting)},
                {"pair", {0, 1}},
                {"command", command_text(record, setting)}};
    row.pictures.push_back({"Reference", record.reference.complete() ? reference_path(folder) : "", "not finished"});
    row.pictures.push_back({"This setting", measured ? picture_path(folder, setting.name) : "", std::string(outcome_of(setting))});
    if (setting.state == SettingState::too_slow)
        row.data["reason"] = fmt::format("one run would take about {:.0f} s or more", setting.expected_seconds);
    if (!measured) return row;
    row.data["facts"] = facts_of(setting);
    row.data["phases"] = {phases_json("the clock", setting.median.wall), phases_json("processors", setting.median.cpu)};
    return row;
}

/// From quick to exact; what was not measured comes last.
std::vector<std::size_t> by_time(const TradeRecord& record) {
    std::vector<std::size_t> order(record.settings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto key = [&](const TradeSetting& s) {
            return std::pair(s.state != SettingState::measured, total(phases_of(s.median, record.cost)));
        };
        return key(record.settings[a]) < key(record.settings[b]);
    });
    return order;
}

}  // namespace

std::string trade_page_text(const TradeRecord& record, const std::string& folder) {
    const ReferenceFacts& reference = record.reference;
    ReportPage page;
    page.title = fmt::format("{}: time against error", fs::path(record.scene).filename().string());
    page.about = fmt::format("{} · {} threads", record.size, record.threads);
    for (const std::string& word : record.words)
        if (!word.starts_with("--width=") && !word.starts_with("--height=")) page.about += fmt::format(" · {}", word);
    page.facts = {{"Settings", fmt::format("{}", record.settings.size())},
                  {"On the front", fmt::format("{}", front_settings(record).size())},
                  {"Rays a pixel of the reference", fmt::format("{:.0f}", reference.samples)},
                  {"RMSE of the reference, estimated", fmt::format("{:.5f}", reference.error)}};
    if (!record.complete) page.notes.emplace_back("Interrupted: these are the settings that were measured. The same command goes on.");
    if (record.out_of_time)
        page.notes.emplace_back("The time was over before everything was measured as often as wanted. The same command goes on.");
    if (reference.complete() && reference.error > reference.asked)
        page.notes.push_back(fmt::format(
            "The reference did not reach the RMSE of {:.5f} that was asked for: --reference-seconds gives it time.", reference.asked));
    page.rows_name = "settings", page.bad_name = "Not on the front", page.first = "good";
    page.columns = columns(record);
    for (const std::size_t i : by_time(record)) page.rows.push_back(row_of(record, record.settings[i], folder));
    page.skeleton = "trade_page.html", page.more = {{"trade", trade_json(record)}};
    return report_page(page, {.left_out = "left out of this page so that it stays small; it lies beside it", .good_first = true});
}

}  // namespace rt
