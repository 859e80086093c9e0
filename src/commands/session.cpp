#include "commands/session.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "commands/encoding.h"
#include "commands/interrupt.h"
#include "commands/names.h"
#include "commands/progress.h"
#include "commands/scene_choices.h"
#include "commands/stats.h"
#include "commands/surroundings.h"
#include "commands/text.h"
#include "commands/values.h"
#include "film/image_file.h"
#include "syntax/parser.h"

namespace rt {

namespace {

/// Seconds that one phase takes, added to `sum` when it ends.
class Timed {
public:
    explicit Timed(double& sum) : sum_(sum) {}
    ~Timed() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& sum_;
    Clock::time_point start_ = Clock::now();
};

/// A picture needs its pixels and, while it is written, its encoded samples. Refused before the system would have to kill the program.
void check_memory(const RenderJob& job) {
    constexpr double bytes_per_pixel = sizeof(Pixel) + 4 * sizeof(std::uint16_t);
    const double needed = bytes_per_pixel * job.width * job.height;
    const double installed = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (needed > installed)
        throw LimitError(fmt::format("a picture of {} x {} pixels needs {:.1f} GB of memory; this machine has {:.1f} GB", job.width,
                                     job.height, needed * 1e-9, installed * 1e-9));
}

void fill_defaults(RenderJob& job) {
    // Until the course's own shading exists its profile renders with POV-Ray's.
    if (!job.shading) job.shading = job.profile == Profile::csc473 ? ShadingModel::povray : ShadingModel::general;
    if (!job.distances) job.distances = *job.shading == ShadingModel::povray ? Distances::povray : Distances::scaled;
    if (!job.precision) job.precision = CompileOptions{}.precision;
}

CompileOptions compile_options(const RenderJob& job, const Scene& scene) {
    CompileOptions options;
    options.profile = job.profile;
    options.precision = *job.precision;
    options.index = job.index;
    options.threads = job.threads;
    options.general_shading = *job.shading == ShadingModel::general;
    if (options.general_shading) options.choose = [&](const Finish& finish) { return choice_for(scene, finish.options, job.model); };
    return options;
}

RenderOptions render_options(const RenderJob& job, const Scene& scene) {
    const Gamma& gamma = scene.settings.gamma;
    RenderOptions options;
    options.width = job.width;
    options.height = job.height;
    options.region = job.region;
    options.threads = job.threads;
    options.sampling = job.sampling;
    options.alpha = job.output_alpha;
    options.working_gamma = gamma.power;
    options.working_srgb = gamma.kind == Gamma::Kind::srgb;
    options.trace.shading = *job.shading;
    options.trace.distances = *job.distances;
    if (*job.shading == ShadingModel::general) options.trace.lamps = choice_for(scene, {}, job.model).lamps;
    options.edges = job.edges;
    options.trace.max_trace_level = job.max_trace_level;
    if (job.povray_quality) options.trace.quality = Quality::povray(*job.povray_quality);
    return options;
}

/// Before the work: nobody waits for a picture that cannot be written, or not as it was asked for.
void check_output(const RenderJob& job, const MessageSink& messages) {
    const OutputTarget target = output_target(job.output, job.scene);
    if (target.path.empty()) return;
    if (const std::string note = note_on_name(job.output, target); !note.empty()) messages("raytrace: note: " + note);
    for (const std::string& loss : format_losses(job, target.format)) messages("raytrace: warning: " + loss);
    if (target.path != "-") check_image_target(target.path, target.format);
}

RenderResult trace(const World& world, const RenderJob& job, const Scene& scene, std::shared_ptr<const Environment> surroundings,
                   const StopOnSignal& signals) {
    RenderOptions options = render_options(job, scene);
    const Region all{0, 0, job.width, job.height};
    const Region seen = options.region.value_or(all);
    Progress progress(job.progress && !job.quiet, static_cast<double>(seen.x1 - seen.x0) * (seen.y1 - seen.y0));
    options.stop = &signals.stop();
    options.trace.environment = std::move(surroundings);
    if (progress.shown()) options.progress = [&](double done) { progress.update(done); };
    return render(world, options);
}

/// Returns the exit status.
int write(const RenderResult& result, const RenderJob& job, const Scene& scene) {
    OutputTarget target = output_target(job.output, job.scene);
    if (!result.complete) {
        if (target.path.empty() || target.path == "-" || !std::filesystem::path(target.path).has_extension()) {
            write_stderr("raytrace: interrupted\n");
            return exit_interrupted;
        }
        target.path = partial_name(target.path);
    }
    if (!target.path.empty())
        write_image(result.film, target.path, target.format, encoding_of(job, scene.settings.gamma), {picture_metadata(job, scene)});
    if (result.complete) return 0;
    write_stderr(fmt::format("raytrace: interrupted; what was finished is in '{}'\n", target.path));
    return exit_interrupted;
}

}  // namespace

std::vector<std::string> default_library_paths() {
    std::vector<std::string> paths;
    if (const char* named = std::getenv("RAYTRACE_LIBRARY_PATH"))
        for (const std::string& path : split(named, ':'))
            if (!path.empty()) paths.push_back(path);
    for (const char* installed : {"/usr/share/povray-3.7", "/usr/local/share/povray-3.7"}) {
        std::error_code ignored;
        if (std::filesystem::is_directory(installed, ignored)) paths.push_back(std::string(installed) + "/include");
    }
    return paths;
}

MessageSink message_sink(bool quiet) {
    if (quiet) return [](std::string_view) {};
    return [](std::string_view text) { write_stderr(fmt::format("{}{}", text, text.ends_with('\n') ? "" : "\n")); };
}

int run_session(RenderJob job) {
    const MessageSink messages = message_sink(job.quiet);
    for (const std::string& note : job.notes) messages("raytrace: note: " + note);
    check_memory(job);
    const std::shared_ptr<const Environment> surroundings = read_surroundings(job.environment);
    for (std::string& path : default_library_paths()) job.parse.library_paths.push_back(std::move(path));

    Stats stats;
    Scene scene;
    World world;
    {
        const Timed timed(stats.phases.parse);
        scene = parse_file(job.scene, job.parse, messages);
        apply_scene_choices(scene, job);
        fill_defaults(job);
        if (*job.shading == ShadingModel::povray && !job.model.empty())
            messages(fmt::format("raytrace: note: --{} has no effect: the shading is POV-Ray's", job.model.front().key));
    }
    {
        const Timed timed(stats.phases.build);
        world = compile(scene, compile_options(job, scene), messages);
    }
    check_output(job, messages);
    const StopOnSignal signals;  // until the picture is written, so that no half file stays
    RenderResult result;
    {
        const Timed timed(stats.phases.trace);
        result = trace(world, job, scene, surroundings, signals);
    }
    if (result.non_finite > 0) messages(fmt::format("raytrace: warning: {} pixels were not finite and are black", result.non_finite));
    int status = 0;
    {
        const Timed timed(stats.phases.write);
        status = write(result, job, scene);
    }
    if (job.stats) {
        stats.rays = result.counts;
        stats.threads = result.threads;
        stats.non_finite = result.non_finite;
        stats.peak_bytes = peak_memory();
        if (*job.shading == ShadingModel::general) stats.narrow = narrow_lobes(world, job.width, job.height, job.sampling);
        write_stderr(stats_text(job, scene, stats));
    }
    return status;
}

}  // namespace rt
