#include "commands/base/values.h"
#include "commands/job/render_draft.h"

namespace rt {

void define_knobs(CommandLine& line, RenderJob& job) {
    line.value("--max-trace-level", "N", "", [&](const std::string& v) {
        job.max_trace_level = whole_number("max-trace-level", v, 1, GlobalSettings::highest_trace_level);
    });
    line.value("--adc-bailout", "X", "", [&](const std::string& v) { job.adc_bailout = real_number("adc-bailout", v, 0.0, unbounded); });
}

}  // namespace rt
