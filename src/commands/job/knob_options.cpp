#include "commands/base/names.h"
#include "commands/base/values.h"
#include "commands/job/render_draft.h"

namespace rt {

void define_knobs(CommandLine& line, RenderJob& job) {
    line.value("--scale", "N", "", [&](const std::string& v) { job.scale = whole_number("scale", v, 1, 64); });
    line.value("--max-trace-level", "N", "", [&](const std::string& v) {
        job.max_trace_level = whole_number("max-trace-level", v, 1, GlobalSettings::highest_trace_level);
    });
    line.value("--adc-bailout", "X", "", [&](const std::string& v) { job.adc_bailout = real_number("adc-bailout", v, 0.0, unbounded); });
    line.value("--shadows", "NAME", "", [&](const std::string& v) { job.shadows = value_of_name(shadow_names, "kind of shadows", v); });
    line.value("--specular-aa", "ON", "", [&](const std::string& v) { job.specular_aa = on_or_off("specular-aa", v); });
    line.value("--light-samples", "N", "", [&](const std::string& v) {
        job.light_samples.reset();
        if (v != "all") job.light_samples = whole_number("light-samples", v, 1, largest_side);
    });
}

}  // namespace rt
