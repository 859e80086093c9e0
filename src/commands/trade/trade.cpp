// raytrace trade SCENE: time against error, measured.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <system_error>

#include "commands/base/command_line.h"
#include "commands/base/comparable_size.h"
#include "commands/base/content_hash.h"
#include "commands/base/interrupt.h"
#include "commands/base/program.h"
#include "commands/base/values.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "commands/job/job_steps.h"
#include "commands/job/povray_syntax.h"
#include "commands/job/render_arguments.h"
#include "commands/trade/trade_reports.h"
#include "commands/trade/work.h"
#include "core/source.h"
#include "core/utf8.h"
#include "grading/file_lock.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

struct TradeDraft {
    TradeRequest request;
    std::vector<std::string> scenes;
    int threads = 0;
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Options of a render about what a trade does in its own way: it names its pictures itself and shows all of them.
bool is_of_output(std::string_view name) {
    return is_one_of(name, {"--outfile", "--povray-output", "--format", "--povray-type", "--bits", "--output-to-file", "--output-alpha",
                            "--dither", "--dither-method", "--crop", "--start-column", "--end-column", "--start-row", "--end-row",
                            "--stats", "--progress", "--all-console"});
}
bool is_of_sampling(std::string_view name) {
    return is_one_of(name, {"--ss", "--aa", "--scale", "--antialias", "--max-error", "--time", "--preview", "--quality"}) ||
           name.starts_with("--aa-") || name.starts_with("--jitter");
}

void refuse(CommandLine& line, const std::string& name, std::string_view why) {
    const auto refusal = [name, why] { throw OptionError(fmt::format("trade: without {}: {}", name, why)); };
    if (render_option_takes_value(name))
        line.value(name, "X", "", [refusal](const std::string&) { refusal(); });
    else
        line.flag(name, "", refusal);
}

/// The picture's settings, which every render gets: kept as words, since a render knows what they mean.
void define_picture(CommandLine& line, TradeDraft& draft) {
    std::vector<std::string>& words = draft.request.words;
    const auto shared = [&](const std::string& names, const std::string& type, const std::string& help, const std::string& option) {
        line.values(names, type, help, [&words, option](const std::string& v) { words.push_back(fmt::format("{}={}", option, v)); });
    };
    shared("-W,--width", "N", "of the pictures (640, less if slow)", "--width");
    shared("-H,--height", "N", "(480)", "--height");
    shared("-L,--library", "DIR", "search includes there too", "--library");
    shared("--define", "NAME=VALUE", "declare a number or a string", "--define");
    for (const std::string& name : render_long_names()) {
        if (is_one_of(name, {"--width", "--height", "--library", "--define", "--threads", "--quiet", "--output", "--help", "--input"}))
            continue;
        if (is_of_sampling(name))
            refuse(line, name, "it varies the samples and qualities itself");
        else if (is_of_output(name))
            refuse(line, name, "it names its pictures itself and shows all of them");
        else if (render_option_takes_value(name))
            shared(name, "X", "", name);
        else
            line.flag(name, "", [&words, name] { words.push_back(name); });
    }
    line.values("--input", "FILE", "", [&](const std::string& v) { draft.scenes.push_back(v); });
    line.value("-t,--threads", "N", "of every render (all processors)",
               [&](const std::string& v) { draft.threads = whole_number("threads", v, 0, 4096); });
}

void define(CommandLine& line, TradeDraft& draft) {
    TradeRequest& request = draft.request;
    define_picture(line, draft);
    line.value("--seconds", "S", "of the whole, about (300)",
               [&](const std::string& v) { request.seconds = real_number("seconds", v, 0.1, 1e7); });
    line.value("--reference-error", "E", "RMSE that the reference is to reach (1/4096)",
               [&](const std::string& v) { request.reference_error = real_number("reference-error", v, 1e-6, 1.0); });
    line.value("--reference-seconds", "S", "or until it would take longer (1/5 of all)",
               [&](const std::string& v) { request.reference_seconds = real_number("reference-seconds", v, 0.001, 1e6); });
    line.value("--runs", "N[,MOST]", "runs of a setting: at least, at most (3,9)", [&](const std::string& v) {
        const std::vector<std::string> parts = split(v, ',');
        if (parts.size() > 2) throw OptionError(fmt::format("runs: expected LEAST,MOST, not '{}'", v));
        request.rule.least = whole_number("runs", parts[0], 1, 1000);
        request.rule.most =
            parts.size() > 1 ? whole_number("runs", parts[1], request.rule.least, 1000) : std::max(request.rule.least, request.rule.most);
    });
    line.value("--run-seconds", "S", "leave out settings of longer runs (1/50 of all)",
               [&](const std::string& v) { request.run_seconds = real_number("run-seconds", v, 0.001, 1e6); });
    line.value("--settings", "N", "at most so many settings (100)",
               [&](const std::string& v) { request.most_settings = static_cast<std::size_t>(whole_number("settings", v, 1, 10000)); });
    line.value("--cost", "NAME", "what is short: wall (the clock) or cpu",
               [&](const std::string& v) { request.cost = value_of_name(cost_names, "cost", v); });
    line.flag("--fresh", "measure all again", [&] { request.fresh = true; });
    line.value("-o,--output", "DIR", "reports and pictures (trade-results)", [&](const std::string& v) { request.folder = v; });
    line.flag("-q,--quiet", "no notes, no progress, no table", [&] { request.quiet = true; });
}

/// Gives what was not asked for its default. The size is one of a request's words.
void settle(TradeRequest& request) {
    std::vector<std::string>& words = request.words;
    const auto is_asked = [&](std::string_view option) {
        return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return word.starts_with(option); });
    };
    request.size_is_asked = is_asked("--size=") || is_asked("--width=") || is_asked("--height=");
    for (const auto& [option, word] : {std::pair("--height=", "--height=480"), std::pair("--width=", "--width=640")})
        if (!is_asked(option) && !is_asked("--size=")) words.insert(words.begin(), word);
    if (request.reference_seconds == 0.0) request.reference_seconds = request.seconds / 5.0;
    if (request.run_seconds == 0.0) request.run_seconds = request.seconds / 50.0;
}

/// Words in any of the ways to write a render. Returns the help's text, or nothing.
std::string read_words(const Words& words, TradeDraft& draft) {
    CommandLine line(trade_usage, trade_footer), trial_line(trade_usage, trade_footer);
    TradeDraft trial;
    define(line, draft), define(trial_line, trial);
    const Translation translation = translate_povray_syntax(with_two_dashes(words, line),
                                                            {.takes_value = [&](const std::string& word) { return line.takes_value(word); },
                                                             .long_names = line.long_names(),
                                                             .try_out = [&](const Words& option) { trial_line.parse(option); }});
    const Words scenes = line.parse(translation.words);
    if (line.help_asked()) return line.help();
    draft.scenes.insert(draft.scenes.end(), scenes.begin(), scenes.end());
    if (draft.scenes.empty()) throw OptionError("trade: expected a scene; see raytrace trade --help");
    if (draft.scenes.size() > 1)
        throw OptionError(fmt::format("trade: one scene at a time: '{}' or '{}'?", draft.scenes[0], draft.scenes[1]));
    TradeRequest& request = draft.request;
    settle(request);
    Words render = {draft.scenes[0]};
    render.insert(render.end(), request.words.begin(), request.words.end());
    std::string help;
    request.job = parse_picture_arguments(render, help).value();
    expect_comparable_size(request.job.width, request.job.height);
    const int processors = static_cast<int>(std::max(1l, sysconf(_SC_NPROCESSORS_ONLN)));
    request.job.threads = draft.threads > 0 ? draft.threads : processors;
    std::vector<std::string>& notes = request.job.notes;
    notes.insert(notes.end(), translation.notes.begin(), translation.notes.end());
    if (!translation.ignored.empty())
        notes.push_back(fmt::format("ignored, without a meaning here: {}", fmt::join(translation.ignored, " ")));
    return {};
}

/// All that every measurement depends on.
std::string content_of(const TradeRequest& request, const TradeScene& scene, const TradeRecord& record) {
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    return fmt::format("{}\n{}\n{}\n{} {} {}", hash_of_file("/proc/self/exe"), scene.fingerprint(), fmt::join(request.words, "\n"),
                       record.threads, record.processors, host);
}

/// The folder and that of its pictures. Throws OutputError.
void make_folders(const std::string& folder) {
    for (const fs::path& path : {fs::path(folder), fs::path(folder) / "pictures"}) {
        std::error_code error;
        fs::create_directories(path, error);
        if (error) throw OutputError(fmt::format("cannot make the folder '{}': {}", path.string(), error.message()));
    }
}

TradeRecord empty_record(const TradeRequest& request) {
    TradeRecord record;
    record.scene = request.job.scene, record.words = request.words;
    record.size = fmt::format("{} x {}", request.job.width, request.job.height);
    record.threads = request.job.threads, record.cost = request.cost;
    record.processors = static_cast<int>(std::max(1l, sysconf(_SC_NPROCESSORS_ONLN)));
    record.reference.asked = request.reference_error;
    return record;
}

/// Puts the size that the time suffices for in place of the usual one.
void choose_size(TradeRequest& request, TradeScene& scene, const TradeWork& work, const MessageSink& messages) {
    const PictureSize size = usual_size(work);
    RenderJob& job = request.job;
    if (size.width == job.width && size.height == job.height) return;
    messages(fmt::format("raytrace: note: pictures of {} x {} instead of {} x {}, to end in about {:g} s; --seconds, -W and -H choose",
                         size.width, size.height, job.width, job.height, request.seconds));
    for (const auto& [option, side] : {std::pair("--width=", size.width), std::pair("--height=", size.height)})
        for (std::string& word : request.words)
            if (word.starts_with(option)) word = fmt::format("{}{}", option, side);
    job.width = size.width, job.height = size.height;
    scene.resize(size.width, size.height);
}

void measure(TradeRequest& request, TradeScene& scene, const TradeClock& clock, TradeRecord& record, const MessageSink& messages) {
    TradeProgress progress(!request.quiet, clock);
    const auto store = [&] {
        return TradeStore((fs::path(request.folder) / "known").string(), content_of(request, scene, record), request.fresh);
    };
    if (!request.size_is_asked) {
        const TradeStore of_usual_size = store();
        choose_size(request, scene, {request, scene, of_usual_size, clock, progress, record}, messages);
    }
    record.words = request.words, record.size = fmt::format("{} x {}", request.job.width, request.job.height);
    const TradeStore of_this_size = store();
    TradeWork work{request, scene, of_this_size, clock, progress, record};
    try {
        carry_out(work);
    } catch (const TradeStopped&) {
        record.complete = false;
        if (work.reference.values.empty()) return;
        recall(work);
    }
    remember(work);
}

/// Two trades in one folder would mix their pictures. Nothing on a disk without locks.
std::optional<LockFile> lock_folder(const std::string& folder) {
    try {
        std::optional<LockFile> lock((fs::path(folder) / "lock").string());
        if (lock->try_lock(0, LockFile::Kind::exclusive)) return lock;
    } catch (const std::system_error&) {
        return std::nullopt;
    }
    throw OutputError(fmt::format("another trade is at work in '{}'; give this one a folder of its own with -o", one_line(folder)));
}

/// Whether there is something to report; an interruption leaves the reports of an earlier trade rather than to put nothing in their place.
bool leaves_reports(const TradeRecord& record, const std::string& folder) {
    std::error_code none;
    return record.settings.empty() && fs::exists(fs::path(folder) / "results.json", none);
}

int run(TradeRequest request) {
    const MessageSink messages = message_sink(request.quiet);
    for (const std::string& note : request.job.notes) messages("raytrace: note: " + note);
    const TradeClock clock(request.seconds);
    TradeRecord record = empty_record(request);
    const StopOnSignal signals;  // until the reports are written
    TradeScene scene(request.job, messages, signals.stop());
    record.knobs = scene.turned_knobs(request.words, messages);
    make_folders(request.folder);
    const std::optional<LockFile> lock = lock_folder(request.folder);
    try {
        measure(request, scene, clock, record, messages);
    } catch (const TradeStopped&) {
        record.complete = false;
    }
    if (leaves_reports(record, request.folder)) {
        messages(fmt::format("raytrace: interrupted before a setting was measured; the reports in {} are those of before", request.folder));
        return exit_interrupted;
    }
    for (const std::size_t i : front_settings(record)) record.settings[i].on_front = true;
    write_trade_reports(record, request.folder);
    if (!request.quiet) write_stdout(trade_table_text(record));
    messages(fmt::format("raytrace: {}reports are in {}", record.complete ? "" : "interrupted; ", request.folder));
    return record.complete ? 0 : exit_interrupted;
}

}  // namespace

int run_trade(const Words& words) {
    TradeDraft draft;
    const std::string help = read_words(words, draft);
    if (help.empty()) return run(std::move(draft.request));
    write_stdout(help);
    return 0;
}

}  // namespace rt
