#include "commands/job/job_steps.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <new>

#include "commands/base/memory_bound.h"
#include "commands/base/program.h"
#include "commands/base/values.h"
#include "commands/job/course_scene.h"
#include "commands/job/encoding.h"
#include "commands/job/quality.h"
#include "commands/job/scene_answers.h"
#include "commands/job/scene_choices.h"
#include "syntax/limits.h"

namespace rt {

namespace {

/// The course's profile has rules of its own, unless a shading is asked for.
void settle_course(RenderJob& job) {
    const bool course = job.profile == Profile::csc473 && !job.shading && job.model.empty();
    if (!course && job.course) throw OptionError("the course's options go with its own rules, not with another shading");
    if (!course) return;
    if (!job.environment.empty()) throw OptionError("--environment goes with another shading, not with the course's rules");
    if (job.povray_quality) throw OptionError("a quality (+Q) goes with another shading, not with the course's rules");
    for (const auto& [stated, option] :
         {std::pair(job.adc_bailout.has_value(), "--adc-bailout"), std::pair(job.shadows.has_value(), "--shadows"),
          std::pair(job.light_samples.has_value(), "--light-samples"), std::pair(job.specular_aa.has_value(), "--specular-aa")})
        if (stated) throw OptionError(fmt::format("{} goes with another shading, not with the course's rules", option));
    if (!job.course) job.course.emplace();
    give_course_its_depth(job);
}

void fill_defaults(RenderJob& job) {
    settle_course(job);
    if (!job.shading) job.shading = job.course ? ShadingModel::povray : ShadingModel::general;
    if (*job.shading == ShadingModel::povray && job.specular_aa.value_or(false))
        throw OptionError("--specular-aa goes with the general shading: POV-Ray's own highlights have no width that it could change");
    if (!job.distances) job.distances = *job.shading == ShadingModel::povray ? Distances::povray : Distances::scaled;
    if (!job.precision) job.precision = CompileOptions{}.precision;
}

CompileOptions compile_options(const RenderJob& job, const Scene& scene) {
    CompileOptions options;
    options.profile = job.profile;
    options.precision = *job.precision;
    options.index = job.index;
    options.light_samples = job.light_samples;
    options.threads = job.threads;
    options.general_shading = *job.shading == ShadingModel::general;
    if (options.general_shading) options.choose = [&](const Finish& finish) { return choice_for(scene, finish.options, job.model); };
    return options;
}

/// What `work` gives; throws LimitError where it gets no memory.
template <typename Work>
auto within_memory(const RenderJob& job, const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw LimitError(fmt::format("The scene takes more than {:.1f} GB of memory.{}",
                                     1e-9 * static_cast<double>(job.parse.max_memory_bytes), allow_more("memory")));
    }
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

void give_course_its_depth(RenderJob& job) {
    if (job.course && job.max_trace_level) job.course->further_rays = *job.max_trace_level - 1;
}

MessageSink message_sink(bool quiet) {
    if (quiet) return [](std::string_view) {};
    return [](std::string_view text) { write_stderr(fmt::format("{}{}", text, text.ends_with('\n') ? "" : "\n")); };
}

Scene read_scene(RenderJob& job, const MessageSink& messages) {
    for (std::string& path : default_library_paths()) job.parse.library_paths.push_back(std::move(path));
    give_answers(job.parse);
    bound_memory(job.parse.max_memory_bytes / 8 * 9);  // what is found while reading has a place: that comes first
    Scene scene = within_memory(job, [&] { return parse_file(job.scene, job.parse, messages); });
    apply_scene_choices(scene, job);
    apply_quality(job, scene);
    fill_defaults(job);
    if (job.course) check_course_scene(scene, messages);
    return scene;
}

World build_world(const RenderJob& job, const Scene& scene, const MessageSink& messages, std::optional<FewRays> few_rays) {
    CompileOptions options = compile_options(job, scene);
    options.few_rays = few_rays;
    options.max_nodes = job.parse.max_scene_nodes;
    return within_memory(job, [&] { return compile(scene, options, messages); });
}

RenderOptions render_options(const RenderJob& job, const Scene& scene) {
    const Gamma& gamma = scene.settings.gamma;
    RenderOptions options;
    options.width = job.width;
    options.height = job.height;
    options.region = job.region;
    options.threads = job.threads;
    options.sampling = job.sampling;
    options.scale = job.scale;
    options.alpha = job.output_alpha;
    options.working_gamma = gamma.power;
    options.working_srgb = gamma.kind == Gamma::Kind::srgb;
    options.trace.shading = *job.shading;
    options.trace.distances = *job.distances;
    if (*job.shading == ShadingModel::general) options.trace.lamps = choice_for(scene, {}, job.model).lamps;
    options.trace.max_trace_level = job.max_trace_level;
    options.trace.adc_bailout = job.adc_bailout;
    options.trace.shadows = job.shadows.value_or(ShadowKind::full);
    if (job.specular_aa.value_or(false)) {
        const int n = samples_a_side(job.sampling);
        options.trace.specular_aa = SampleGrid{job.width * n, job.height * n};
    }
    options.trace.course = job.course;
    options.edges = job.edges;
    options.display = encoding_of(job, gamma);
    if (job.povray_quality) options.trace.quality = Quality::povray(*job.povray_quality);
    return options;
}

}  // namespace rt
