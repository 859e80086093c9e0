#include "commands/job/session.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "commands/base/interrupt.h"
#include "commands/base/process_age.h"
#include "commands/base/program.h"
#include "commands/base/progress.h"
#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/job/stats.h"
#include "commands/job/stepwise.h"
#include "commands/job/surroundings.h"
#include "commands/job/text.h"
#include "commands/job/without_effect.h"
#include "core/source.h"
#include "film/image_file.h"
#include "trace/enlarged.h"

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

/// A picture written there takes the place of the one before, and does not follow it.
bool can_be_replaced(const std::string& path) {
    std::error_code none;
    return path != "-" && !path.empty() && (std::filesystem::is_regular_file(path, none) || !std::filesystem::exists(path, none));
}

/// Before the work: nobody waits for a picture that cannot be written, or not as it was asked for.
void check_output(const RenderJob& job, const MessageSink& messages) {
    const OutputTarget target = output_target(job.output, job.scene);
    if (target.path.empty()) return;
    if (const std::string note = note_on_name(job.output, target); !note.empty()) messages("raytrace: note: " + note);
    for (const std::string& loss : format_losses(job, target.format)) messages("raytrace: warning: " + loss);
    if (target.path != "-") check_image_target(target.path, target.format);
    if (job.preview && !can_be_replaced(target.path))
        throw OptionError(
            fmt::format("--preview writes the picture again and again, which '{}' does not allow; give it a file", target.path));
}

void write_film(const Film& film, const OutputTarget& target, const RenderJob& job, const Scene& scene) {
    write_image(film, target.path, target.format, encoding_of(job, scene.settings.gamma), {picture_metadata(job, scene)});
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
    if (!job.preview && !job.time) return render(world, options);
    const OutputTarget target = output_target(job.output, job.scene);
    std::function<void(const Film&)> write;
    if (can_be_replaced(target.path)) write = [&](const Film& film) { write_film(film, target, job, scene); };
    return render_stepwise(world, options, job, write);
}

/// Returns the exit status. Of a preview the best picture so far takes the place of the ones before.
int write(const RenderResult& result, const RenderJob& job, const Scene& scene) {
    OutputTarget target = output_target(job.output, job.scene);
    const bool is_whole = result.convergence && result.convergence->spacing > 0;
    if (!result.complete && !(job.preview && is_whole)) {
        if (job.preview || target.path.empty() || target.path == "-" || !std::filesystem::path(target.path).has_extension()) {
            write_stderr("raytrace: interrupted\n");
            return exit_interrupted;
        }
        target.path = partial_name(target.path);
    }
    if (!target.path.empty()) write_film(result.film, target, job, scene);
    if (result.complete) return 0;
    write_stderr(
        fmt::format("raytrace: interrupted; {} is in '{}'\n", job.preview ? "the picture so far" : "what was finished", target.path));
    return exit_interrupted;
}

/// What a sampling by error or time has come to.
void tell_reached(const RenderResult& result, const RenderJob& job, const MessageSink& messages) {
    if (!result.convergence || !result.complete) return;
    const Convergence& reached = *result.convergence;
    if (job.time) messages(fmt::format("raytrace: {}", reached_text(reached, process_age())));
    if (!job.time && reached.error && !reached.reached)
        messages(fmt::format("raytrace: warning: the error is estimated to be {:.3g}, not {:.3g}: no pixel gets more than {} samples",
                             *reached.error, job.sampling.max_error, reached.most));
}

}  // namespace

int run_session(RenderJob job) {
    const MessageSink messages = message_sink(job.quiet);
    for (const std::string& note : job.notes) messages("raytrace: note: " + note);
    check_memory(job);
    const std::shared_ptr<const Environment> surroundings = read_surroundings(job.environment);

    Stats stats;
    Scene scene;
    World world;
    {
        const Timed timed(stats.phases.parse);
        scene = read_scene(job, messages);
    }
    {
        const Timed timed(stats.phases.build);
        world = build_world(job, scene, messages);
    }
    if (const std::string note = note_on_choices_without_effect(job, scene, world); !note.empty()) messages("raytrace: note: " + note);
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
    tell_reached(result, job, messages);
    if (job.stats) {
        stats.rays = result.counts;
        stats.threads = result.threads;
        stats.non_finite = result.non_finite;
        stats.convergence = result.convergence;
        stats.peak_bytes = peak_memory();
        if (*job.shading == ShadingModel::general)
            stats.narrow = narrow_lobes(world, scaled_down(job.width, job.scale), scaled_down(job.height, job.scale), job.sampling);
        write_stderr(stats_text(job, scene, stats));
    }
    return status;
}

int run_animation(const RenderJob& job) {
    const Animation& animation = *job.animation;
    const int frames = (animation.last - animation.first) / animation.step + 1;
    const OutputTarget target = output_target(job.output, job.scene);
    const MessageSink messages = message_sink(job.quiet);
    for (int i = 0; i < frames; ++i) {
        const int number = animation.first + i * animation.step;
        RenderJob frame = job;
        if (i > 0) frame.notes.clear();
        set_frame(frame.parse, animation, number);
        frame.output.name = frame_name(target.path, animation, number);
        if (job.progress) messages(fmt::format("raytrace: frame {} ({} of {})", number, i + 1, frames));
        if (const int status = run_session(std::move(frame)); status != 0) return status;
    }
    return 0;
}

}  // namespace rt
