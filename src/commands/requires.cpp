// raytrace requires SCENE|FOLDER...: what each scene needs of the program, and what is missing of it in all.
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/time.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <new>

#include "commands/base/interrupt.h"
#include "commands/base/json_text.h"
#include "commands/base/memory_bound.h"
#include "commands/base/program.h"
#include "commands/base/scene_folder.h"
#include "commands/base/task_progress.h"
#include "commands/base/values.h"
#include "commands/commands.h"
#include "commands/job/job_steps.h"
#include "commands/job/render_arguments.h"
#include "commands/job/requirements.h"
#include "commands/job/requirements_text.h"
#include "commands/job/scene_answers.h"
#include "core/source.h"
#include "grading/descriptor.h"
#include "grading/workers.h"
#include "syntax/parser.h"

namespace rt {

namespace {

constexpr int exit_mistake = 1, exit_limit = 4, exit_internal = 5;

/// Every scene of the words, those of folders in the order of their names.
std::vector<std::string> all_scenes(const std::vector<std::string>& names) {
    std::vector<std::string> scenes;
    std::error_code none;
    for (const std::string& name : names) {
        if (!std::filesystem::is_directory(name, none)) {
            scenes.push_back(name);
            continue;
        }
        const std::vector<std::string> below = scenes_below(name, "");
        if (below.empty()) throw OptionError(fmt::format("there is no scene (*.pov) in the folder '{}'", printable(name)));
        scenes.insert(scenes.end(), below.begin(), below.end());
    }
    return scenes;
}

/// A mistake is told on standard error, too, in full.
SceneReading failed(const std::string& scene, const std::string& error, int status) {
    write_stderr(error + "\n");
    return failed_reading(scene, error, status);
}

SceneReading read(const std::string& scene, const ParseOptions& options) {
    try {
        return reading_of(scene, requirements_of(parse_file(scene, options, message_sink(true))));
    } catch (const SceneError& error) {
        return failed(scene, error.what(), exit_mistake);
    } catch (const OptionError& error) {
        return failed(scene, fmt::format("raytrace: {}", error.what()), exit_mistake);
    } catch (const LimitError& error) {
        const bool placed = std::string_view(error.what()).starts_with("File '");
        return failed(scene, fmt::format("{}{}", placed ? "" : "raytrace: ", error.what()), exit_limit);
    } catch (const std::bad_alloc&) {
        return failed(scene, "raytrace: out of memory", exit_limit);
    }
}

/// Sends this process SIGALRM, which ends it, after that time.
void end_after(double seconds) {
    const double whole = std::floor(seconds);
    const auto rest = static_cast<suseconds_t>((seconds - whole) * 1e6);
    std::signal(SIGALRM, SIG_DFL);
    const itimerval timer{{}, {static_cast<time_t>(whole), rest}};
    setitimer(ITIMER_REAL, &timer, nullptr);
}

/// Memory that processes share: one writes into it, another reads.
class SharedBytes {
public:
    SharedBytes() : file_(memfd_create("bytes", MFD_CLOEXEC)) {
        if (!file_) throw_errno("memory for what scenes need");
    }
    void write(const std::string& bytes) const { write_all(file_.get(), bytes.data(), bytes.size()); }
    /// What was written since the last time.
    std::string take() const {
        std::string bytes;
        lseek(file_.get(), 0, SEEK_SET);
        while (read_some(file_.get(), bytes)) {
        }
        lseek(file_.get(), 0, SEEK_SET);
        if (ftruncate(file_.get(), 0) != 0) throw_errno("memory for what scenes need");
        return bytes;
    }

private:
    Descriptor file_;
};

SceneReading reading_of_end(const std::string& scene, const WorkerEnd& end, const std::string& bytes, double seconds) {
    if (end.done) return unpacked(bytes);
    if (end.signal == SIGALRM)
        return failed(scene, fmt::format("raytrace: {}: reading it takes more than {:g} s", scene, seconds), exit_limit);
    const std::string problem = end.signal ? fmt::format("signal {}", end.signal) : end.problem;
    return failed(scene, fmt::format("raytrace: internal fault: {}: {}", scene, problem), exit_internal);
}

/// Scenes one after the other, each in a process of its own: one that never ends or that ends its process stops no other.
std::vector<SceneReading> readings_of(const std::vector<std::string>& scenes, const RequiresArguments& arguments,
                                      const std::atomic<bool>& stop) {
    const SharedBytes shared;
    std::vector<SceneReading> readings;
    TaskProgressLine line(scenes.size() > 1, "scenes");
    run_jobs(scenes.size(), 1,
             {.begin = {},
              .work =
                  [&](std::size_t i, int) {
                      end_after(arguments.seconds);
                      shared.write(packed(read(scenes[i], arguments.parse)));
                  },
              .done = [&](std::size_t i,
                          const WorkerEnd& end) { readings.push_back(reading_of_end(scenes[i], end, shared.take(), arguments.seconds)); },
              .idle = [&] { line.update({.tasks = scenes.size(), .done = readings.size()}); }},
             stop);
    return readings;
}

}  // namespace

int run_requires(const Words& words) {
    std::string help;
    std::optional<RequiresArguments> arguments = parse_requires_arguments(words, help);
    if (!arguments) {
        write_stdout(help);
        return 0;
    }
    for (std::string& path : default_library_paths()) arguments->parse.library_paths.push_back(std::move(path));
    give_answers(arguments->parse);
    bound_memory(arguments->parse.max_memory_bytes / 8 * 9);
    const std::vector<std::string> scenes = all_scenes(arguments->scenes);
    std::vector<SceneReading> readings;
    {
        const StopOnSignal signals;
        readings = readings_of(scenes, *arguments, signals.stop());
    }
    int status = readings.size() < scenes.size() ? exit_interrupted : 0;
    for (const SceneReading& reading : readings) status = std::max(status, reading.status);
    if (arguments->json) {
        write_stdout(json_text(readings_json(readings), 2));
        return status;
    }
    std::string text;
    for (const SceneReading& reading : readings)
        if (scenes.size() > 1 || reading.status == 0) text += reading.text;
    write_stdout(scenes.size() > 1 ? text + missing_text(readings) : text);
    return status;
}

}  // namespace rt
