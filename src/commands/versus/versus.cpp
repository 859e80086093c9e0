// raytrace versus SCENE|FOLDER...: POV-Ray and this program on the same scenes with the same settings.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "commands/base/command_line.h"
#include "commands/base/comparable_size.h"
#include "commands/base/content_hash.h"
#include "commands/base/interrupt.h"
#include "commands/base/program.h"
#include "commands/base/run_place.h"
#include "commands/base/task_progress.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "commands/job/job_steps.h"
#include "commands/job/povray_syntax.h"
#include "commands/job/render_arguments.h"
#include "commands/versus/program_told.h"
#include "commands/versus/versus_reports.h"
#include "commands/versus/versus_scene.h"
#include "core/source.h"
#include "grading/workers.h"

namespace rt {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int exit_differs = 1, exit_nothing_compared = 4;

struct VersusJob {
    VersusSettings settings;
    std::vector<std::string> scenes;
    std::string only, povray;
    std::string folder = "versus-results";
    int threads = 0, parallel = 1;
    bool quiet = false;
};

/// The picture's settings, which both programs get: kept as words, since a render knows what they mean.
void define_picture(CommandLine& line, VersusJob& job) {
    const auto shared = [&](const std::string& names, const std::string& type, const std::string& help, const std::string& option) {
        line.values(names, type, help,
                    [&job, option](const std::string& v) { job.settings.words.push_back(fmt::format("{}={}", option, v)); });
    };
    shared("-W,--width", "N", "of the pictures (640)", "--width");
    shared("-H,--height", "N", "(480)", "--height");
    shared("--aa", "M[,T[,R]]", "POV-Ray's method 1 or 2, threshold T, depth R (none)", "--aa");
    shared("--define", "NAME=VALUE", "declare a number or a string", "--define");
    line.values("-L,--library", "DIR", "search includes there too",
                [&](const std::string& v) { job.settings.words.push_back(fmt::format("--library={}", fs::absolute(v).string())); });
    for (const char* option : {"--size", "--antialias", "--aa-method", "--aa-threshold", "--aa-depth", "--aa-gamma", "--jitter",
                               "--jitter-amount", "--clock", "--language"})
        shared(option, "X", "", option);
    line.values("--input", "FILE", "", [&](const std::string& v) { job.scenes.push_back(v); });
    line.value("-t,--threads", "N", "of each program (all processors)",
               [&](const std::string& v) { job.threads = whole_number("threads", v, 0, 4096); });
}

void define(CommandLine& line, VersusJob& job) {
    define_picture(line, job);
    VersusLimits& limits = job.settings.agreement;
    line.value("--percent", "P", "of the pixels must agree (98)",
               [&](const std::string& v) { limits.percent = real_number("percent", v, 0.0, 100.0); });
    line.value("--step", "N", "within N of 255 in every channel (2)",
               [&](const std::string& v) { limits.step = whole_number("step", v, 0, 255); });
    line.value("--rmse", "X", "and the RMSE be below X (0.01)", [&](const std::string& v) {
        limits.rmse = real_number("rmse", v, 0.0, 1.0);
        if (limits.rmse == 0.0) throw OptionError("rmse: 0 is too little: no RMSE is below it");
    });
    line.value("--judge", "NAME", "same (POV-Ray's shading) or general", [&](const std::string& v) {
        constexpr NameTable<Maker, 2> ours{{{"same", Maker::same}, {"general", Maker::general}}};
        limits.judged = value_of_name(ours, "shading to judge", v);
    });
    line.value("--timeout", "S", "for each run (60)",
               [&](const std::string& v) { job.settings.limits.wall_seconds = real_number("timeout", v, 0.01, 1e6); });
    line.value("--only", "REGEX", "scenes whose name matches", [&](const std::string& v) { job.only = v; });
    line.value("-j,--jobs", "N", "scenes at a time (1); times are not fair then",
               [&](const std::string& v) { job.parallel = whole_number("jobs", v, 1, 1024); });
    line.value("--povray", "PROGRAM", "POV-Ray, if not the one in $PATH", [&](const std::string& v) { job.povray = v; });
    line.flag("--fresh", "run POV-Ray again where its picture is known", [&] { job.settings.fresh = true; });
    line.value("-o,--output", "DIR", "reports and pictures (versus-results)", [&](const std::string& v) { job.folder = v; });
    line.flag("-q,--quiet", "no notes, no progress, no table", [&] { job.quiet = true; });
}

/// Gives the size that was not asked for its default. Throws OptionError for what is too large to be compared.
void settle_size(VersusSettings& settings) {
    Words& words = settings.words;
    const auto is_asked = [&](std::string_view option) {
        return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return word.starts_with(option); });
    };
    for (const auto& [option, word] : {std::pair("--height=", "--height=480"), std::pair("--width=", "--width=640")})
        if (!is_asked(option) && !is_asked("--size=")) words.insert(words.begin(), word);
    settings.job = job_of_words(words);
    const long width = settings.job.width, height = settings.job.height;
    expect_comparable_size(width, height);
}

/// What both programs cannot share is refused by name, so that nobody takes it for a mistyped word.
void refuse_options_of_a_render(const Words& words, const CommandLine& line) {
    const Words known = line.long_names(), of_render = render_long_names();
    const auto is_in = [](const Words& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (word == "--") return;
        if (is_in(of_render, name) && !is_in(known, name))
            throw OptionError(
                fmt::format("'{}' is an option of a render and not of a comparison, in which both programs get size, --aa, "
                            "-L, --define and --clock",
                            name));
    }
}

/// Words in any of the ways to write a render. Returns the help's text, or nothing.
std::string read_words(const Words& words, VersusJob& job) {
    CommandLine line(versus_usage, versus_footer), trial_line(versus_usage, versus_footer);
    VersusJob trial;
    define(line, job), define(trial_line, trial);
    refuse_options_of_a_render(words, line);
    const Translation translation = translate_povray_syntax(with_two_dashes(words, line),
                                                            {.takes_value = [&](const std::string& word) { return line.takes_value(word); },
                                                             .long_names = line.long_names(),
                                                             .try_out = [&](const Words& option) { trial_line.parse(option); },
                                                             .short_names = {"-j"}});
    refuse_options_of_a_render(translation.words, line);
    const Words scenes = line.parse(translation.words);
    if (line.help_asked()) return line.help();
    job.scenes.insert(job.scenes.end(), scenes.begin(), scenes.end());
    if (job.scenes.empty()) throw OptionError("versus: expected scenes or folders; see raytrace versus --help");
    settle_size(job.settings);
    std::vector<std::string>& notes = job.settings.job.notes;
    notes.insert(notes.end(), translation.notes.begin(), translation.notes.end());
    if (!translation.ignored.empty())
        notes.push_back(fmt::format("ignored, without a meaning here: {}", fmt::join(translation.ignored, " ")));
    return {};
}

/// The folders of includes are the same for both.
void settle_includes(VersusSettings& settings) {
    std::vector<std::string>& paths = settings.job.parse.library_paths;
    std::error_code none;
    for (const std::string& path : paths)
        if (!fs::is_directory(path, none)) throw OptionError(fmt::format("--library: there is no folder '{}'", printable(path)));
    settings.installed = installed_includes(settings.povray);
    std::vector<std::string> others = default_library_paths();
    others.insert(others.end(), settings.installed.begin(), settings.installed.end());
    for (const char* installed : {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include"})
        std::erase(others, std::string(installed));  // found by both without a word
    for (const std::string& other : others) {
        const std::string path = fs::absolute(other).lexically_normal().string();
        if (fs::is_directory(path, none)) paths.push_back(path), settings.words.push_back("--library=" + path);
    }
}

/// Asks POV-Ray for its version.
void settle_povray(VersusSettings& settings) {
    const RunPlace place;
    if (!povray_can_say(place.folder()))
        throw OptionError(fmt::format("TMPDIR: POV-Ray's command line cannot name '{}'", printable(place.folder())));
    const Ending ending = run_program_for(settings, {settings.povray, "--version"}, {place.folder(), place.folder()}, 0);
    settings.version = povray_version(ending.output), settings.povray_hash = hash_of_file(settings.povray);
    if (settings.version.empty())
        throw OptionError(fmt::format("'{}' is not POV-Ray: --version prints no version of it{}{}", printable(settings.povray),
                                      ending.reason.empty() ? "" : "; ", ending.reason));
}

/// Whatever is wrong is told before anything is written or rendered.
std::vector<VersusScene> settle(VersusJob& job) {
    VersusSettings& settings = job.settings;
    settings.povray = find_povray(job.povray);
    settings.program = fs::canonical("/proc/self/exe").string();
    std::error_code error;
    settings.folder = fs::weakly_canonical(job.folder, error).string();
    std::vector<VersusScene> scenes = scenes_of(job.scenes, job.only, settings.folder);
    settle_includes(settings);
    povray_picture_words(settings.job);  // what POV-Ray's command line cannot say
    settings.containment = find_containment();
    // Neither program is a stranger: they read what the user may read.
    settings.containment.own_user = false;
    settings.limits.processes = 4096, settings.limits.output_bytes = 1u << 26;
    const int processors = static_cast<int>(std::max(1l, sysconf(_SC_NPROCESSORS_ONLN)));
    settings.threads = job.threads > 0 ? job.threads : std::max(1, processors / job.parallel);
    settings.alone = job.parallel == 1;
    settle_povray(settings);
    return scenes;
}

/// An .ini file that says nothing keeps others from POV-Ray.
void make_output_folder(VersusJob& job) {
    make_folder(job.folder);
    job.settings.folder = fs::canonical(job.folder).string();
    write_bytes(no_settings_file(job.settings), "; Nothing: the command line says all.\n");
}

class Comparison {
public:
    Comparison(const VersusJob& job, const std::vector<VersusScene>& scenes, const std::atomic<bool>& stop)
        : job_(job), scenes_(scenes), stop_(stop), known_((fs::path(job.settings.folder) / "known").string()), line_(!job.quiet, "scenes") {
        progress_.tasks = scenes.size();
        for (const VersusScene& scene : scenes) {
            results_.push_back(result_without_run(scene, VersusRun::State::not_run, ""));
            left_.expect(scene.path);
        }
        started_.resize(scenes.size());
    }

    std::vector<VersusResult> run() {
        run_jobs(scenes_.size(), job_.parallel,
                 {.begin = [&](std::size_t i) { begin(i); },
                  .work = [&](std::size_t i, int slot) { run_scene(job_.settings, scenes_[i], known_, slot); },
                  .done = [&](std::size_t i, const WorkerEnd& end) { finish(i, end); },
                  .idle = [&] { tell(); }},
                 stop_);
        return std::move(results_);
    }

private:
    static double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

    /// Nothing of an earlier comparison is taken for this one's.
    void begin(std::size_t i) {
        make_folder(pictures_of(job_.settings, scenes_[i]));
        remove_result_of(job_.settings, scenes_[i]);
        started_[i] = Clock::now();
    }
    void finish(std::size_t i, const WorkerEnd& end) {
        left_.add(scenes_[i].path, since(started_[i]));
        ++progress_.done;
        const std::optional<VersusResult> result = end.done ? result_of_scene(job_.settings, scenes_[i]) : std::nullopt;
        const std::string problem = end.signal ? fmt::format("comparing was ended by signal {}", end.signal) : end.problem;
        results_[i] = result ? *result : result_without_run(scenes_[i], VersusRun::State::failed, problem);
        results_[i].path = scenes_[i].path;  // which JSON holds only if it is UTF-8
    }
    void tell() {
        progress_.seconds = since(start_);
        progress_.seconds_left = left_.seconds(job_.parallel);
        line_.update(progress_);
    }

    const VersusJob& job_;
    const std::vector<VersusScene>& scenes_;
    const std::atomic<bool>& stop_;
    EntryStore known_;
    TaskProgressLine line_;
    TaskProgress progress_;
    TimeLeft left_;
    std::vector<VersusResult> results_;
    std::vector<Clock::time_point> started_;
    Clock::time_point start_ = Clock::now();
};

int exit_status(const std::vector<VersusResult>& results) {
    int status = exit_nothing_compared;  // both refuse whatever there is
    for (const VersusResult& result : results) {
        if (result.cause == VersusCause::not_run) return exit_interrupted;
        if (!counts_as_agreeing(result.cause)) status = exit_differs;
        if (result.cause == VersusCause::agrees && status != exit_differs) status = 0;
    }
    return status;
}

int run(VersusJob job) {
    const MessageSink messages = message_sink(job.quiet);
    for (const std::string& note : job.settings.job.notes) messages("raytrace: note: " + note);
    const std::vector<VersusScene> scenes = settle(job);
    make_output_folder(job);
    remove_left_places();
    VersusRecord record{job.settings.version, job.settings.words, job.settings.agreement, {}};
    {
        const StopOnSignal signals;
        record.results = Comparison(job, scenes, signals.stop()).run();
    }
    remove_left_places();                                     // of workers that an interruption ended
    if (!job.quiet) write_stdout(versus_table_text(record));  // even if the reports cannot be written
    write_versus_reports(record, job.settings.folder);
    messages(fmt::format("raytrace: reports are in {}", printable(job.settings.folder)));
    const int status = exit_status(record.results);
    if (status == exit_nothing_compared) messages("raytrace: nothing was compared: both programs refuse every scene");
    return status;
}

}  // namespace

int run_versus(const Words& words) {
    try {
        VersusJob job;
        const std::string help = read_words(words, job);
        if (help.empty()) return run(std::move(job));
        write_stdout(help);
        return 0;
    } catch (const OptionError& error) {  // status 1 has a meaning of its own here
        write_stderr(fmt::format("raytrace: {}\n", error.what()));
        return exit_nothing_compared;
    }
}

}  // namespace rt
