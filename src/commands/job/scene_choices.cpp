#include "commands/job/scene_choices.h"

#include <fmt/format.h>

#include "commands/base/names.h"
#include "commands/job/edge_choices.h"

namespace rt {

namespace {

[[noreturn]] void fail(const Scene& scene, const SceneOption& option, std::string_view text) {
    throw SceneError(scene.sources.describe(option.span, "Parse Error", text));
}

template <typename T, std::size_t N>
T value_of(const Scene& scene, const SceneOption& option, const NameTable<T, N>& table, std::string_view what) {
    const std::optional<T> value = find_name(table, option.value);
    if (!value) fail(scene, option, fmt::format("{}: {}", option.key, unknown_name_text(table, what, option.value)));
    return *value;
}

void choose_lines(const Scene& scene, const SceneOption& option, EdgeOptions& edges) {
    try {
        choose_edges(edges, option.key, option.value);
    } catch (const OptionError& error) {
        fail(scene, option, error.what());
    }
}

void check_finish(const Scene& scene, const std::vector<SceneOption>& options) {
    for (const SceneOption& option : options) {
        if (!is_model_key(option.key) || is_lamp_key(option.key))
            fail(scene, option, fmt::format("'{}' is for the whole picture, not for one finish", option.key));
        if (option.key == "shading" && option.value == "povray")
            fail(scene, option, "shading: 'povray' is for the whole picture, not for one finish");
        if (const std::string lamps = option.key == "preset" ? lamp_choices_of_preset(option.value) : ""; !lamps.empty())
            fail(scene, option,
                 fmt::format("preset: '{}' is for the whole picture, not for one finish: {} is about all lamps", option.value, lamps));
    }
    choice_for(scene, options, {});
}

}  // namespace

SceneChoices choices_of(const Scene& scene) {
    SceneChoices choices;
    for (const SceneOption& option : scene.options) {
        if (option.key == "distances") choices.distances = value_of(scene, option, distances_names, "rule of distances");
        if (option.key == "precision") choices.precision = value_of(scene, option, precision_names, "precision");
        if (is_edge_key(option.key)) choose_lines(scene, option, choices.edges);
        if (option.key == "shading") choices.shading = option.value == "povray" ? ShadingModel::povray : ShadingModel::general;
    }
    choice_for(scene, {}, {});
    for (const std::vector<SceneOption>& options : scene.finish_options) check_finish(scene, options);
    return choices;
}

void apply_scene_choices(const Scene& scene, RenderJob& job) {
    const SceneChoices choices = choices_of(scene);
    // The command line wins.
    if (!job.shading) job.shading = choices.shading;
    if (!job.distances) job.distances = choices.distances;
    if (!job.precision) job.precision = choices.precision;
    job.edges = choices.edges;
    for (const ModelOption& option : job.edge_options) choose_edges(job.edges, option.key, option.value);
}

}  // namespace rt
