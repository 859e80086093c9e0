#include "commands/scene_choices.h"

#include <fmt/format.h>

#include <set>
#include <unordered_set>
#include <utility>

#include "commands/names.h"

namespace rt {

namespace {

class Chooser {
public:
    explicit Chooser(const Scene& scene) : scene_(scene) {}
    SceneChoices choices;

    void file_option(const SceneOption& option) {
        if (option.key == "shading")
            choose(option, shading_names, "shading", choices.shading);
        else if (option.key == "distances")
            choose(option, distances_names, "rule of distances", choices.distances);
        else if (option.key == "precision")
            choose(option, precision_names, "precision", choices.precision);
        else if (option.key == "alpha")
            choose(option, alpha_names, "alpha mapping", choices.alpha);
        else
            unavailable(option, "");  // the parser lets no unknown key pass
    }

    /// No choice of one finish is available yet.
    void finish_option(const SceneOption& option) { unavailable(option, " inside finish"); }

private:
    const Scene& scene_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> places_;  ///< a finish may be used, and a line read, many times

    template <typename T, std::size_t N>
    void choose(const SceneOption& option, const NameTable<T, N>& table, std::string_view what, std::optional<T>& chosen) {
        const std::optional<T> value = find_name(table, option.value);
        if (!value) {
            const std::string text = fmt::format("{}: {}", option.key, unknown_name_text(table, what, option.value));
            throw SceneError(scene_.sources.describe(option.span, "Parse Error", text));
        }
        chosen = value;
    }

    void unavailable(const SceneOption& option, std::string_view where) {
        if (places_.insert({option.span.file, option.span.begin}).second)
            choices.unavailable.push_back({fmt::format("raytrace option '{}'{}", option.key, where), option.span});
    }
};

/// Every option of every finish in `layers`, each texture once.
class FinishOptions {
public:
    template <typename Use>
    void visit(const TextureLayers& layers, const Use& use) {
        if (!seen_.insert(layers.identity()).second) return;
        for (const Texture& texture : *layers) visit(texture, use);
    }

private:
    std::unordered_set<const void*> seen_;

    template <typename Use>
    void visit(const Texture& texture, const Use& use) {
        if (const auto* plain = std::get_if<PlainTexture>(&texture.content)) {
            for (const SceneOption& option : plain->finish.options) use(option);
            return;
        }
        for (const std::vector<Texture>& cell : std::get<CheckerTexture>(texture.content).cells)
            for (const Texture& inner : cell) visit(inner, use);
    }
};

}  // namespace

SceneChoices choices_of(const Scene& scene) {
    Chooser chooser(scene);
    for (const SceneOption& option : scene.options) chooser.file_option(option);
    FinishOptions finishes;
    const auto use = [&](const SceneOption& option) { chooser.finish_option(option); };
    for (const Object& object : scene.objects) {
        if (object.texture) finishes.visit(*object.texture, use);
        if (object.interior_texture) finishes.visit(*object.interior_texture, use);
    }
    return std::move(chooser.choices);
}

void apply_scene_choices(const Scene& scene, RenderJob& job, const MessageSink& messages) {
    const SceneChoices choices = choices_of(scene);
    for (const Unmodelled& option : choices.unavailable) {
        const std::string text = option.feature + " is not available in this version";
        if (!job.parse.lenient) throw SceneError(scene.sources.describe(option.span, "Parse Error", text));
        messages(scene.sources.describe(option.span, "Parse Warning", text));
    }
    // The command line wins.
    if (!job.shading) job.shading = choices.shading;
    if (!job.distances) job.distances = choices.distances;
    if (!job.precision) job.precision = choices.precision;
    if (!job.alpha) job.alpha = choices.alpha;
}

}  // namespace rt
