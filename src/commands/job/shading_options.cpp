#include "commands/job/render_draft.h"

#include <fmt/format.h>

#include "commands/base/names.h"
#include "commands/base/values.h"
#include "commands/job/edge_choices.h"
#include "core/source.h"

namespace rt {

void define_shading(CommandLine& line, RenderJob& job) {
    for (const ModelKey& key : model_keys()) {
        const std::string name(key.key);
        const std::string help = name == "shading" ? "general (default), povray, phong ...: help shading" : std::string(key.help);
        line.value("--" + name, std::string(key.values), help, [&job, name](const std::string& v) {
            const bool povray = name == "shading" && v == "povray";
            if (name == "shading") job.shading = povray ? ShadingModel::povray : ShadingModel::general;
            // A preset is a shading, too; a scene's own does not undo it.
            if (name == "preset" && !job.shading) job.shading = ShadingModel::general;
            if (povray) return;
            ModelChoice scratch;
            choose(scratch, name, v);
            job.model.push_back({name, v});
        });
    }
    for (const EdgeKey& key : edge_keys) {
        const std::string name(key.key);
        line.value("--" + name, std::string(key.values), "", [&job, name](const std::string& v) {
            EdgeOptions scratch;
            choose_edges(scratch, name, v);
            job.edge_options.push_back({name, v});
        });
    }
    line.value("--environment", "FILE", "", [&](const std::string& v) {
        job.environment = split(v, ',');
        if (job.environment.size() != 1 && job.environment.size() != 6)
            throw OptionError(fmt::format("environment: expected one picture or six separated by commas, not {}", job.environment.size()));
    });
    line.value("--distances", "NAME", "scaled (default) or povray",
               [&](const std::string& v) { job.distances = value_of_name(distances_names, "rule of distances", v); });
    line.value("--precision", "NAME", "", [&](const std::string& v) { job.precision = value_of_name(precision_names, "precision", v); });
    line.value("--index", "NAME", "", [&](const std::string& v) { job.index = value_of_name(index_names, "index", v); });
    line.value("--profile", "NAME", "povray (default) or csc473, the course's camera",
               [&](const std::string& v) { job.profile = value_of_name(profile_names, "profile", v); });
}

}  // namespace rt
