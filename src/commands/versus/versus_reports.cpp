#include "commands/versus/versus_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/base/csv_field.h"
#include "commands/base/write_bytes.h"
#include "commands/report/result_json.h"
#include "commands/versus/versus_json.h"
#include "commands/versus/versus_page.h"
#include "grading/result_names.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What is wrong, in one field.
std::string first_message(const VersusResult& result) {
    for (const VersusRun& run : result.runs)
        if (!run.message.empty()) return run.message;
    return {};
}

std::string figures_cells(const std::optional<Likeness>& like) {
    if (!like) return std::string(metrics + 4, ',');
    std::string text = fmt::format(",{},{}", like->agrees ? "yes" : "no", like->beyond);
    for (const auto& [name, metric] : metric_names) text += fmt::format(",{:.9g}", like->figures[metric]);
    return text + (like->region ? fmt::format(",{},{}", like->region->x, like->region->y) : ",,");
}

std::string time_cells(const VersusRun& run) {
    if (run.state != VersusRun::State::done) return ",,,,,,";
    return fmt::format(",{:.3f},{:.3f},{:.4f},{:.4f},{:.4f},{}", run.wall_seconds, run.cpu_seconds, run.phases.parse, run.phases.build,
                       run.phases.trace, run.rays);
}

}  // namespace

std::vector<MissingCount> missing_counts(const std::vector<VersusResult>& results) {
    MissingOfScenes scenes;
    for (const VersusResult& result : results)
        if (result.cause == VersusCause::not_modelled) scenes.push_back(result.missing);
    return missing_counts(scenes);
}

std::vector<const VersusResult*> worst_first(const VersusRecord& record) {
    std::vector<const VersusResult*> list;
    for (const VersusResult& result : record.results) list.push_back(&result);
    const auto badness = [&](const VersusResult& result) {
        const std::optional<Likeness>& like = result.like(record.limits.judged);
        return like ? std::pair(100.0 - like->percent_within(), like->figures[Metric::rmse]) : std::pair(0.0, 0.0);
    };
    std::sort(list.begin(), list.end(), [&](const VersusResult* a, const VersusResult* b) {
        if (a->cause != b->cause) return a->cause < b->cause;
        const auto worse = badness(*a), better = badness(*b);
        return worse != better ? worse > better : a->name < b->name;
    });
    return list;
}

std::string percent_text(const Likeness& like, int digits) {
    std::uint64_t scale = 1;
    for (int i = 0; i < digits; ++i) scale *= 10;
    const std::uint64_t pixels = like.figures.pixels, within = pixels - like.beyond;
    const std::uint64_t value = pixels ? 100 * scale * within / pixels : 0;
    return fmt::format("{}.{:0{}}", value / scale, value % scale, digits);
}

std::string versus_results_text(const VersusRecord& record) {
    Json summary, missing = Json::array();
    for (const auto& [name, cause] : cause_names)
        summary[std::string(name)] = std::count_if(record.results.begin(), record.results.end(),
                                                   [wanted = cause](const VersusResult& result) { return result.cause == wanted; });
    for (const MissingCount& count : missing_counts(record.results))
        missing.push_back({{"name", count.name}, {"scenes", count.scenes}, {"only_this", count.only_this}});
    std::vector<Json> scenes;
    for (const VersusResult& result : record.results) scenes.push_back(versus_json(result));
    return json_listing({{"format", "raytrace versus 1"},
                         {"povray", record.povray},
                         {"settings", record.settings},
                         {"limits",
                          {{"percent", record.limits.percent},
                           {"step", record.limits.step},
                           {"rmse", record.limits.rmse},
                           {"judged", name_of(maker_names, record.limits.judged)}}},
                         {"summary", summary},
                         {"missing", missing}},
                        "scenes", scenes);
}

std::string versus_times_text(const VersusRecord& record) {
    std::vector<Json> scenes;
    for (const VersusResult& result : record.results) scenes.push_back(versus_times_json(result));
    return json_listing({{"format", "raytrace versus times 1"}, {"povray", record.povray}}, "scenes", scenes);
}

std::string versus_csv_text(const VersusRecord& record) {
    std::string text = "scene,cause";
    for (const char* shading : {"same", "general"}) {
        text += fmt::format(",{0}_agrees,{0}_beyond", shading);
        for (const auto& [name, metric] : metric_names) text += fmt::format(",{}_{}", shading, name);
        text += fmt::format(",{0}_x,{0}_y", shading);
    }
    for (const auto& [name, maker] : maker_names) text += fmt::format(",{0}_wall,{0}_cpu,{0}_parse,{0}_build,{0}_trace,{0}_rays", name);
    text += ",not_modelled,message\n";
    for (const VersusResult& result : record.results) {
        text += fmt::format("{},{}", csv_field(result.name), name_of(cause_names, result.cause));
        text += figures_cells(result.like(Maker::same)) + figures_cells(result.like(Maker::general));
        for (const VersusRun& run : result.runs) text += time_cells(run);
        std::vector<std::string> names;
        for (const MissingFeature& missing : result.missing) names.push_back(missing.name);
        text += fmt::format(",{},{}\n", csv_field(fmt::format("{}", fmt::join(names, " "))), csv_field(first_message(result)));
    }
    return text;
}

void write_versus_reports(const VersusRecord& record, const std::string& folder) {
    const fs::path place(folder);
    write_report((place / "results.json").string(), versus_results_text(record));
    write_report((place / "times.json").string(), versus_times_text(record));
    write_report((place / "results.csv").string(), versus_csv_text(record));
    write_report((place / "report.html").string(), versus_page_text(record, folder));
}

}  // namespace rt
