// Results of a comparison for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/base/values.h"
#include "commands/versus/versus_reports.h"

namespace rt {

namespace {

constexpr std::size_t longest_cell = 160;

std::string first_line(const std::string& text) { return printable(text.substr(0, text.find('\n')), longest_cell); }

/// A text without the scene's folder where a path begins, behind `mark`: the scene is named beside it.
std::string without_folder(const VersusResult& result, std::string text, std::string_view mark) {
    const std::string folder = fmt::format("{}{}/", mark, std::filesystem::path(result.path).parent_path().string());
    if (const std::size_t at = text.find(folder); at != text.npos && (at == 0 || !mark.empty()))
        text.erase(at + mark.size(), folder.size() - mark.size());
    return text;
}

std::string message_of(const VersusResult& result, Maker maker) {
    return first_line(without_folder(result, result.run(maker).message, "File '"));
}

/// Names of files may hold anything.
std::string name_text(const VersusResult& result) { return printable(result.name, longest_cell); }

std::string colour_text(const std::array<int, 3>& colour) { return fmt::format("{} {} {}", colour[0], colour[1], colour[2]); }

/// "99.98  0.0012  0.000  0.0003  0.0001", or as wide a blank.
std::string figures_text(const std::optional<Likeness>& like) {
    if (!like) return fmt::format("{:42}", "");
    const PictureFigures& f = like->figures;
    return fmt::format("{:>7} %  {:.4f}  {:.4f}  {:.4f}  {:.4f} ", percent_text(*like, 2), f[Metric::rmse], f[Metric::p99], f[Metric::flip],
                       f[Metric::neighbourhood]);
}

std::string seconds_text(const VersusRun& run) {
    return run.state == VersusRun::State::done ? fmt::format("{:>8.2f}", run.wall_seconds) : fmt::format("{:>8}", "");
}

std::string place_text(const Likeness& like) {
    if (!like.region) return {};
    const DifferingRegion& r = *like.region;
    return fmt::format("      {} pixels in ({}, {}) to ({}, {}); at ({}, {}) POV-Ray has {}, we {}\n", r.pixels, r.x0, r.y0, r.x1 - 1,
                       r.y1 - 1, r.x, r.y, colour_text(like.theirs), colour_text(like.ours));
}

/// Each message once, behind those whose it is.
std::string messages_text(const VersusResult& result) {
    const std::string theirs = message_of(result, Maker::povray);
    std::string text;
    if (!theirs.empty()) text += fmt::format("      {}: {}\n", theirs == message_of(result, Maker::same) ? "both" : "POV-Ray", theirs);
    std::string before = theirs;
    for (const Maker maker : {Maker::same, Maker::general}) {
        const std::string ours = message_of(result, maker);
        if (!ours.empty() && ours != before) text += fmt::format("      we: {}\n", ours);
        before = ours;
    }
    return text;
}

std::string scene_text(const VersusResult& result, const VersusLimits& limits, std::size_t width) {
    const std::optional<Likeness>& general = result.like(Maker::general);
    std::string text = fmt::format("  {:<{}} {}", name_text(result), width, figures_text(result.like(Maker::same)));
    text += general ? fmt::format("{:>8} %", percent_text(*general, 2)) : fmt::format("{:>10}", "");
    for (const VersusRun& run : result.runs) text += seconds_text(run);
    while (text.ends_with(' ')) text.pop_back();
    text += "\n";
    if (result.cause == VersusCause::differs && result.like(limits.judged)) text += place_text(*result.like(limits.judged));
    return text + messages_text(result);
}

/// A scene that is not modelled: its features, and where the first of them stands.
std::string missing_line(const VersusResult& result, std::size_t width) {
    std::vector<std::string> names;
    for (const MissingFeature& missing : result.missing) names.push_back(missing.name);
    const MissingFeature& first = result.missing.front();
    return fmt::format("  {:<{}} {} ({}:{}:{})\n", name_text(result), width, fmt::join(names, ", "),
                       printable(without_folder(result, first.file, ""), longest_cell), first.line, first.column);
}

std::string gains_text(const std::vector<VersusResult>& results) {
    std::string text = "what is not modelled, by gain         scenes that ask for it    for nothing else\n";
    for (const MissingCount& count : missing_counts(results))
        text += fmt::format("  {:<38} {:>20} {:>19}\n", count.name, count.scenes, count.only_this);
    return text;
}

bool all_rendered(const VersusResult& result) {
    return std::all_of(result.runs.begin(), result.runs.end(), [](const VersusRun& run) { return run.state == VersusRun::State::done; });
}

/// Our wall clock as a share of POV-Ray's, scene by scene.
std::string ratio_text(const std::vector<const VersusResult*>& results, Maker maker) {
    std::vector<std::pair<double, const VersusResult*>> ratios;
    for (const VersusResult* result : results)
        ratios.emplace_back(result->run(maker).wall_seconds / result->run(Maker::povray).wall_seconds, result);
    std::sort(ratios.begin(), ratios.end(),
              [](const auto& a, const auto& b) { return std::pair(a.first, a.second->name) < std::pair(b.first, b.second->name); });
    const double median = 0.5 * (ratios[(ratios.size() - 1) / 2].first + ratios[ratios.size() / 2].first);
    const auto& [worst, scene] = ratios.back();
    return fmt::format("  {} / POV-Ray: median {:.2f}, at most {:.2f} ({})\n", name_of(maker_names, maker), median, worst,
                       name_text(*scene));
}

/// Sums over the scenes that all three rendered, and how they divide among the phases that the programs print.
std::string times_text(const VersusRecord& record) {
    std::vector<const VersusResult*> results;
    for (const VersusResult& result : record.results)
        if (all_rendered(result)) results.push_back(&result);
    if (results.empty()) return {};
    bool fair = true;
    std::string lines;
    for (const auto& [name, maker] : maker_names) {
        double wall = 0.0;
        Phases sum;
        for (const VersusResult* result : results) {
            const VersusRun& run = result->run(maker);
            wall += run.wall_seconds, sum.parse += run.phases.parse, sum.build += run.phases.build;
            sum.trace += run.phases.trace, sum.write += run.phases.write;
            fair = fair && run.alone && run.threads == results.front()->run(Maker::povray).threads;
        }
        lines += fmt::format("  {:<8}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}", maker == Maker::povray ? "POV-Ray" : name, wall, sum.parse,
                             sum.build, sum.trace);
        lines += maker == Maker::povray ? "\n" : fmt::format("{:>10.2f}\n", sum.write);
    }
    return fmt::format("seconds of {} that all rendered{}\n  {:<8}{:>10}{:>10}{:>10}{:>10}{:>10}\n{}{}{}",
                       results.size() == 1 ? "the scene" : fmt::format("the {} scenes", results.size()),
                       fair ? "" : " (not fair: not all ran alone with as many threads)", "", "wall", "parse", "build", "trace", "write",
                       lines, ratio_text(results, Maker::same), ratio_text(results, Maker::general));
}

std::string closing_text(const VersusRecord& record) {
    std::string counts;
    std::size_t good = 0;
    for (const auto& [name, cause] : cause_names) {
        const auto is_of = [wanted = cause](const VersusResult& result) { return result.cause == wanted; };
        const auto count = std::count_if(record.results.begin(), record.results.end(), is_of);
        if (counts_as_agreeing(cause)) good += static_cast<std::size_t>(count);
        if (count > 0) counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, name);
    }
    return fmt::format("{}{} of {} scenes agree: {}\n", times_text(record), good, record.results.size(), counts);
}

}  // namespace

std::string versus_table_text(const VersusRecord& record) {
    std::size_t width = 5;
    for (const VersusResult& result : record.results) width = std::max(width, name_text(result).size());
    std::string text = fmt::format("  {:<{}} {:<43}{:>9}{:>25}\n", "", width, "with POV-Ray's shading", "general", "wall clock, s");
    text += fmt::format("  {:<{}} {:>9}  {:<6}  {:<6}  {:<6}  {:<6} {:>10}{:>8}{:>8}{:>8}\n", "scene", width, "within", "rmse", "p99",
                        "flip", "3x3", "within", "POV-Ray", "same", "general");
    const std::vector<const VersusResult*> results = worst_first(record);
    for (const auto& [name, cause] : cause_names) {
        const auto is_of = [wanted = cause](const VersusResult* result) { return result->cause == wanted; };
        const auto count = std::count_if(results.begin(), results.end(), is_of);
        if (count == 0) continue;
        text += fmt::format("{} ({})\n", name, count);
        for (const VersusResult* result : results)
            if (is_of(result))
                text += cause == VersusCause::not_modelled ? missing_line(*result, width) : scene_text(*result, record.limits, width);
        if (cause == VersusCause::not_modelled) text += gains_text(record.results);
    }
    return text + closing_text(record);
}

}  // namespace rt
