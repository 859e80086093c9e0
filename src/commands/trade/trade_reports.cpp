#include "commands/trade/trade_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "commands/base/csv_field.h"
#include "commands/base/json_text.h"
#include "commands/base/write_bytes.h"
#include "commands/trade/median.h"
#include "commands/trade/trade_page.h"
#include "core/utf8.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr const char* csv_columns =
    ",runs,spread,parse_wall,build_wall,trace_wall,write_wall,total_wall,parse_cpu,build_cpu,trace_cpu,write_cpu,total_cpu,camera_rays,"
    "shadow_rays,reflected_rays,refracted_rays,edge_rays,rmse,p99,max,flip,unstable\n";

std::string phases_cells(const Phases& p) {
    return fmt::format(",{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}", p.parse, p.build, p.trace, p.write, total(p));
}

std::string figures_cells(const TradeSetting& setting) {
    const Measured& m = setting.measured;
    return fmt::format(",{},{}{}{},{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{}", m.runs.size(),
                       std::isfinite(setting.spread) ? fmt::format("{:.4f}", setting.spread) : "", phases_cells(setting.median.wall),
                       phases_cells(setting.median.cpu), m.rays.camera, m.rays.shadow, m.rays.reflected, m.rays.refracted, m.rays.edge,
                       m.error.rmse, m.error.p99, m.error.max, m.error.flip,
                       setting.unstable ? fmt::format("{}", setting.unstable->pixels) : "");
}

std::string line_of(const TradeSetting& setting, Cost cost) {
    const Measured& m = setting.measured;
    return fmt::format("  {:>9.4f}  {:>8.5f}  {:>7.4f}  {:>7.4f}  {:>6.4f}  {:>8}  {}\n", total(phases_of(setting.median, cost)),
                       m.error.rmse, m.error.p99, m.error.max, m.error.flip,
                       setting.unstable ? fmt::format("{}", setting.unstable->pixels) : "", setting.name);
}

long count_unstable_medians(const TradeRecord& record) {
    return std::count_if(record.settings.begin(), record.settings.end(), [](const TradeSetting& setting) {
        return setting.state == SettingState::measured && std::isfinite(setting.spread) && setting.spread >= RepeatRule{}.spread;
    });
}

std::string counts_text(const TradeRecord& record) {
    const auto count = [&](SettingState state) {
        return std::count_if(record.settings.begin(), record.settings.end(),
                             [&](const TradeSetting& setting) { return setting.state == state; });
    };
    std::string text = fmt::format("{} settings measured", count(SettingState::measured));
    if (const auto unstable = count_unstable_medians(record))
        text += fmt::format(" ({} medians may be off by more than {:g} %)", unstable, 100.0 * RepeatRule{}.spread);
    if (const auto slow = count(SettingState::too_slow)) text += fmt::format(", {} too slow", slow);
    if (const auto open = count(SettingState::not_run)) text += fmt::format(", {} not run", open);
    if (record.out_of_time) text += "; the time was over before all was done as often as wanted: the same command goes on";
    return text;
}

}  // namespace

std::string trade_csv_text(const TradeRecord& record) {
    std::string text = "setting,origin,state,front,comparable";
    for (const TurnedKnob& knob : record.knobs) text += fmt::format(",{}", csv_field(std::string(knob->name)));
    text += csv_columns;
    const std::string none(std::count(csv_columns, csv_columns + std::string_view(csv_columns).size(), ','), ',');
    for (const TradeSetting& setting : record.settings) {
        text +=
            fmt::format("{},{},{},{},{}", csv_field(setting.name), name_of(origin_names, setting.origin),
                        name_of(setting_state_names, setting.state), setting.on_front ? "yes" : "no", setting.comparable ? "yes" : "no");
        for (std::size_t i = 0; i < record.knobs.size(); ++i)
            text += fmt::format(",{}", csv_field(std::string(value_name(*record.knobs[i].table, setting.setting.values[i]))));
        text += (setting.state == SettingState::measured ? figures_cells(setting) : none) + "\n";
    }
    return text;
}

std::string trade_table_text(const TradeRecord& record) {
    const ReferenceFacts& reference = record.reference;
    std::string text = fmt::format("{}, {}, {} threads\n", one_line(record.scene), record.size, record.threads);
    if (!reference.complete()) return text + "the reference is not finished; the same command goes on with it\n";
    text += fmt::format("reference: {:.0f} rays a pixel, RMSE {:.5f} (estimated; {:.5f} was asked for), {:.1f} s\n", reference.samples,
                        reference.error, reference.asked, reference.seconds);
    text += fmt::format("below RMSE {:.5f}, twice the reference's, settings are not told apart\n", reference.told_apart());
    text += fmt::format("{}\n", counts_text(record));
    const std::string head = fmt::format("  {:>9}  {:>8}  {:>7}  {:>7}  {:>6}  {:>8}\n", record.cost == Cost::wall ? "seconds" : "CPU s",
                                         "RMSE", "p99", "max", "FLIP", "unstable");
    text += "presets\n" + head;
    for (const TradeSetting& setting : record.settings)
        if (setting.origin == Origin::preset && setting.state == SettingState::measured) text += line_of(setting, record.cost);
    text += "what no other setting beats\n" + head;
    for (const std::size_t i : front_settings(record)) text += line_of(record.settings[i], record.cost);
    return text;
}

void write_trade_reports(const TradeRecord& record, const std::string& folder) {
    const fs::path place(folder);
    write_report((place / "results.json").string(), json_text(trade_json(record), 1));
    write_report((place / "results.csv").string(), trade_csv_text(record));
    write_report((place / "trade.html").string(), trade_page_text(record, folder));
}

}  // namespace rt
