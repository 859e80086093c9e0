#include "commands/versus/versus_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "commands/base/shell_words.h"
#include "commands/report/report_page.h"
#include "commands/versus/versus_reports.h"
#include "grading/result_names.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view titles[makers] = {"POV-Ray", "Same shading", "General form"};

std::string_view title_of(Maker maker) { return titles[static_cast<std::size_t>(maker)]; }

/// Of our two pictures the one that is not judged.
Maker other_of(Maker judged) { return judged == Maker::same ? Maker::general : Maker::same; }

std::vector<ReportColumn> columns(Maker judged) {
    const auto hint = [&](std::string_view text) { return fmt::format("{}: {}", title_of(judged), text); };
    return {{"name", "Scene", CellKind::text, ""},
            {"outcome", "Cause", CellKind::outcome, hint("what became of it")},
            {"beyond", "Beyond", CellKind::count, hint("pixels that lie beyond the step in a channel")},
            {"rmse", "RMSE", CellKind::figure, hint("root of the mean squared difference, 1 is full scale")},
            {"p99", "p99", CellKind::figure, hint("99 % of the pixels differ by no more than that, 1 is full scale")},
            {"flip", "FLIP", CellKind::figure, hint("mean LDR-FLIP")},
            {"neighbourhood", "3×3", CellKind::figure, hint("mean difference to the most similar of the 3 by 3 pixels around")},
            {"other_rmse", other_of(judged) == Maker::same ? "Same RMSE" : "General RMSE", CellKind::figure,
             fmt::format("{}, which is not judged", title_of(other_of(judged)))},
            {"missing", "Not modelled", CellKind::text, ""},
            {"povray_wall", "POV-Ray", CellKind::seconds, "seconds of the clock"},
            {"same_wall", "Same", CellKind::seconds, "seconds of the clock, with POV-Ray's shading"},
            {"general_wall", "General", CellKind::seconds, "seconds of the clock, of the general form"}};
}

Json cells_of(const VersusResult& result, Maker judged, const std::string& missing) {
    Json cells = {{"name", result.name}, {"outcome", name_of(cause_names, result.cause)}};
    if (const std::optional<Likeness>& like = result.like(judged)) {
        cells["beyond"] = like->beyond;
        for (const Metric metric : {Metric::rmse, Metric::p99, Metric::flip, Metric::neighbourhood})
            cells[std::string(name_of(metric_names, metric))] = like->figures[metric];
    }
    if (const std::optional<Likeness>& like = result.like(other_of(judged))) cells["other_rmse"] = like->figures[Metric::rmse];
    if (!missing.empty()) cells["missing"] = missing;
    for (const auto& [name, maker] : maker_names)
        if (result.run(maker).state == VersusRun::State::done) cells[fmt::format("{}_wall", name)] = result.run(maker).wall_seconds;
    return cells;
}

std::string likeness_text(const Likeness& like) {
    std::string text = fmt::format("{}: {} % of the pixels within the step, {} beyond", like.agrees ? "agrees" : "differs",
                                   percent_text(like, 3), like.beyond);
    for (const auto& [name, metric] : metric_names) text += fmt::format(", {} {:.6g}", rt::title_of(metric), like.figures[metric]);
    if (!like.region) return text;
    const DifferingRegion& r = *like.region;
    return text + fmt::format("; largest region of {} pixels in columns {} to {}, rows {} to {}; at {}, {} POV-Ray has {}, we {}", r.pixels,
                              r.x0, r.x1 - 1, r.y0, r.y1 - 1, r.x, r.y, fmt::join(like.theirs, " "), fmt::join(like.ours, " "));
}

std::string run_text(const VersusRun& run) {
    std::string text = fmt::format("{:.3f} s of the clock, {:.3f} s of processors, {} threads{}", run.wall_seconds, run.cpu_seconds,
                                   run.threads, run.alone ? "" : " (other scenes beside it: not fair)");
    if (run.peak_memory_bytes) text += fmt::format(", {:.1f} MiB at most", static_cast<double>(run.peak_memory_bytes) / (1 << 20));
    return text + fmt::format("; {} rays, {} shadow tests", run.rays, run.shadow_tests);
}

Json facts_of(const VersusResult& result) {
    Json facts = Json::array();
    const auto tell = [&](std::string_view name, std::string text) { facts.push_back({name, std::move(text)}); };
    tell("Scene", result.path);
    for (const Maker maker : {Maker::same, Maker::general})
        if (result.like(maker)) tell(title_of(maker), likeness_text(*result.like(maker)));
    for (const MissingFeature& m : result.missing) tell("Not modelled", fmt::format("{} ({}:{}:{})", m.name, m.file, m.line, m.column));
    for (const auto& [name, maker] : maker_names)
        if (result.run(maker).state == VersusRun::State::done) tell(fmt::format("{} took", title_of(maker)), run_text(result.run(maker)));
    return facts;
}

/// [[program, [[phase, seconds], ...]], ...]: what is left of the clock is starting and ending.
Json phases_of(const VersusResult& result) {
    Json programs = Json::array();
    for (const auto& [name, maker] : maker_names) {
        const VersusRun& run = result.run(maker);
        if (run.state != VersusRun::State::done) continue;
        const Phases& p = run.phases;
        const double other = std::max(0.0, run.wall_seconds - (p.parse + p.build + p.trace + p.write));
        Json parts = Json::array();
        const std::pair<const char*, double> phases[] = {
            {"parse", p.parse}, {"build", p.build}, {"trace", p.trace}, {"write", p.write}, {"other", other}};
        for (const auto& [phase, seconds] : phases) parts.push_back(Json::array({phase, seconds}));
        programs.push_back(Json::array({title_of(maker), parts}));
    }
    return programs;
}

/// It writes the picture that this page shows.
std::string command_text(const std::string& scene, const std::vector<std::string>& words) {
    return fmt::format("cd {} && {}", shell_word(fs::path(scene).parent_path().string()), shell_words(words));
}

std::string missing_names(const VersusResult& result) {
    std::vector<std::string> names;
    for (const MissingFeature& m : result.missing) names.push_back(m.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

ReportRow row_of(const VersusResult& result, const VersusLimits& limits, const std::string& folder) {
    ReportRow row;
    Json commands = Json::array();
    std::string reason;
    for (const auto& [name, maker] : maker_names) {
        const VersusRun& run = result.run(maker);
        const bool done = run.state == VersusRun::State::done;
        const fs::path path = fs::path(folder) / "pictures" / result.name / fmt::format("{}.png", name);
        row.pictures.push_back(
            {std::string(title_of(maker)), done ? path.string() : "", done ? "" : name_of(run_state_names, run.state).data()});
        if (!run.command.empty()) commands.push_back({title_of(maker), command_text(result.path, run.command)});
        if (!run.message.empty() && reason.find(run.message) == reason.npos)
            reason += fmt::format("{}{}: {}", reason.empty() ? "" : "\n", title_of(maker), run.message);
    }
    row.data = {{"name", result.name},
                {"good", counts_as_agreeing(result.cause)},
                {"cells", cells_of(result, limits.judged, missing_names(result))},
                {"pair", {Maker::povray, limits.judged}}};
    if (!reason.empty()) row.data["reason"] = reason;
    row.data["commands"] = commands, row.data["facts"] = facts_of(result), row.data["phases"] = phases_of(result);
    if (const std::optional<Likeness>& like = result.like(limits.judged); like && like->region) {
        const DifferingRegion& r = *like->region;
        row.data["region"] = {{"box", {r.x0, r.y0, r.x1, r.y1}}, {"pixel", {r.x, r.y}}, {"pixels", r.pixels}};
    }
    return row;
}

}  // namespace

std::string versus_page_text(const VersusRecord& record, const std::string& folder) {
    ReportPage page;
    page.title = "POV-Ray and raytrace", page.about = fmt::format("{} · {}", record.povray, fmt::join(record.settings, " "));
    const auto good = [](const VersusResult& result) { return counts_as_agreeing(result.cause); };
    page.facts = {
        {"Agree", fmt::format("{} of {}", std::count_if(record.results.begin(), record.results.end(), good), record.results.size())}};
    for (const auto& [name, cause] : cause_names) {
        const auto is_of = [wanted = cause](const VersusResult& result) { return result.cause == wanted; };
        const auto count = std::count_if(record.results.begin(), record.results.end(), is_of);
        if (count > 0 && cause != VersusCause::agrees) page.facts.emplace_back(name, fmt::format("{}", count));
    }
    page.notes.push_back(fmt::format(
        "{} is judged: a scene agrees if {:g} % of the pixels lie within {:g} of 255 in every channel and the RMSE is below {:g}.",
        title_of(record.limits.judged), record.limits.percent, record.limits.step, record.limits.rmse));
    const std::vector<MissingCount> missing = missing_counts(record.results);
    if (!missing.empty()) {
        std::string text = "Not modelled, by the scenes that ask for nothing else:";
        for (const MissingCount& count : missing)
            if (count.only_this > 0) text += fmt::format(" {} {} (of {}),", count.name, count.only_this, count.scenes);
        text.back() = '.';
        page.notes.push_back(text);
    }
    page.rows_name = "scenes", page.bad_name = "Not agreeing";
    page.columns = columns(record.limits.judged);
    for (const VersusResult* result : worst_first(record)) page.rows.push_back(row_of(*result, record.limits, folder));
    return report_page(page, {.left_out = "left out of this page so that it stays small; it lies in the folder of the pictures"});
}

}  // namespace rt
