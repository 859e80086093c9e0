#include "commands/job/text.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/base/names.h"
#include "commands/base/program.h"
#include "commands/job/stats.h"

namespace rt {

namespace {

std::string sampling_text(const Sampling& s) {
    switch (s.method) {
        case Sampling::Method::none:
            return "none";
        case Sampling::Method::grid:
            return fmt::format("grid,{}", s.depth);
        case Sampling::Method::povray1:
            return fmt::format("1,{},{}", s.threshold, s.depth);
        case Sampling::Method::povray2:
            return fmt::format("2,{},{}", s.threshold, s.depth);
        case Sampling::Method::adaptive:
            return fmt::format("adaptive,{}", s.max_error);
    }
    return "?";
}

}  // namespace

std::string shading_text(const RenderJob& job) {
    if (!job.course) return std::string(name_of(shading_names, *job.shading));
    const CourseRules& rules = *job.course;
    std::string text = "csc473";
    if (rules.show != CourseShow::shaded) text += rules.show == CourseShow::pigment ? ",raycast" : ",normals";
    if (rules.fresnel) text += ",fresnel";
    if (rules.cook_torrance) text += ",altbrdf";
    if (rules.beers) text += ",beers";
    if (!rules.indirect_samples.empty()) text += fmt::format(",gi:{}", fmt::join(rules.indirect_samples, ":"));
    return text;
}

ImageMetadata picture_metadata(const RenderJob& job, const Scene& scene) {
    std::string options =
        fmt::format("size={}x{} profile={} shading={} distances={} precision={} aa={} gamma={}", job.width, job.height,
                    name_of(profile_names, job.profile), shading_text(job), name_of(distances_names, *job.distances),
                    name_of(precision_names, *job.precision), sampling_text(job.sampling), gamma_text(scene.settings.gamma));
    if (job.scale > 1) options += fmt::format(" scale={}", job.scale);
    for (const ModelOption& option : job.model) options += fmt::format(" {}={}", option.key, option.value);
    if (job.max_trace_level) options += fmt::format(" max-trace-level={}", *job.max_trace_level);
    if (job.adc_bailout) options += fmt::format(" adc-bailout={}", *job.adc_bailout);
    if (job.shadows) options += fmt::format(" shadows={}", name_of(shadow_names, *job.shadows));
    if (job.light_samples) options += fmt::format(" light-samples={}", *job.light_samples);
    if (job.specular_aa) options += fmt::format(" specular-aa={}", *job.specular_aa ? "on" : "off");
    if (job.povray_quality) options += fmt::format(" quality={}", *job.povray_quality);
    if (job.region) options += fmt::format(" crop={},{},{},{}", job.region->x0, job.region->x1, job.region->y0, job.region->y1);
    if (job.parse.frame.clock_on) options += fmt::format(" clock={}", job.parse.clock);
    for (const auto& [name, value] : job.parse.declares) options += fmt::format(" {}={}", name, value);
    return {{{"Software", fmt::format("raytrace {}", program_version())}, {"Scene", job.scene}, {"Options", options}}};
}

}  // namespace rt
