#include "commands/job/without_effect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands/job/edge_choices.h"

namespace rt {

namespace {

/// What stands in the file or on the command line.
struct Statement {
    std::string key, text;
    bool in_file = false;
};

void state(std::vector<Statement>& statements, Statement statement) {
    // The last statement of a key counts.
    std::erase_if(statements, [&](const Statement& other) { return other.key == statement.key; });
    statements.push_back(std::move(statement));
}

std::vector<Statement> statements_of(const RenderJob& job, const Scene& scene) {
    std::vector<Statement> in_file, options;
    for (const SceneOption& option : scene.options) state(in_file, {option.key, fmt::format("{}={}", option.key, option.value), true});
    for (const std::vector<ModelOption>* stated : {&job.model, &job.edge_options})
        for (const ModelOption& option : *stated)
            if (!option.implied) state(options, {option.key, "--" + option.key, false});
    options.insert(options.end(), in_file.begin(), in_file.end());
    return options;
}

bool is_read(std::string_view key, const std::vector<LayerNode>& layers, const LampRules& lamps, std::span<const Light> lights) {
    bool read = false;
    for_each_layer(layers, [&](const LayerNode& layer) { read |= is_read(key, Shading{layer.finish.model, lamps, lights}); });
    return read;
}

bool is_read_by_edges(std::string_view key, const EdgeOptions& edges) {
    if (key == "edge-angle") return edges.kind == EdgeOptions::Kind::crease || edges.kind == EdgeOptions::Kind::all;
    return key == "edges" || edges.kind != EdgeOptions::Kind::off;
}

/// The lines as the file has them.
EdgeOptions edges_of(const Scene& scene) {
    EdgeOptions edges;
    for (const SceneOption& option : scene.options)
        if (is_edge_key(option.key)) choose_edges(edges, option.key, option.value);
    return edges;
}

}  // namespace

bool picture_reads(std::string_view key, const RenderJob& job, const Scene& scene, const World& world) {
    if (*job.shading == ShadingModel::povray) return false;
    const LampRules lamps = choice_for(scene, {}, job.model).lamps;
    return std::any_of(world.materials.begin(), world.materials.end(), [&](const Material& material) {
        return is_read(key, material.layers, lamps, world.lights) || is_read(key, material.interior_layers, lamps, world.lights);
    });
}

std::string note_on_choices_without_effect(const RenderJob& job, const Scene& scene, const World& world) {
    const auto has_effect = [&](const Statement& statement) {
        const std::string& key = statement.key;
        // Whoever turns a file's lines off knows that their width goes with them.
        if (is_edge_key(key)) return is_read_by_edges(key, statement.in_file ? edges_of(scene) : job.edges);
        // The shading was chosen between all of them; the other keys are of the whole picture.
        return !is_model_key(key) || key == "shading" || picture_reads(key, job, scene, world);
    };
    std::vector<std::string> idle;
    for (const Statement& statement : statements_of(job, scene))
        if (!has_effect(statement)) idle.push_back(statement.text);
    if (idle.empty()) return "";
    return fmt::format("no effect here: {} (nothing in the picture depends on {})", fmt::join(idle, ", "),
                       idle.size() == 1 ? "it" : "them");
}

}  // namespace rt
