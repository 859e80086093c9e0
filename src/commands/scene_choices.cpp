#include "commands/scene_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>

#include "commands/names.h"
#include "commands/suggest.h"

namespace rt {

namespace {

constexpr std::array<std::string_view, 4> known_keys{"shading", "distances", "precision", "alpha"};
/// Terms of the catalogue of shading that this version does not select.
constexpr std::array<std::string_view, 4> later_keys{"D", "G", "F", "diffuse"};

class Chooser {
public:
    Chooser(const Scene& scene, RenderJob& job, const MessageSink& messages) : scene_(scene), job_(job), messages_(messages) {}

    void file_option(const SceneOption& option) {
        if (option.key == "shading")
            choose(option, shading_names, "shading", shading_);
        else if (option.key == "distances")
            choose(option, distances_names, "rule of distances", distances_);
        else if (option.key == "precision")
            choose(option, precision_names, "precision", precision_);
        else if (option.key == "alpha")
            choose(option, alpha_names, "alpha mapping", alpha_);
        else
            refuse(option, "");
    }

    /// No choice of one finish is available yet.
    void finish_option(const SceneOption& option) { refuse(option, " inside finish"); }

    /// The command line wins.
    void finish() {
        if (!job_.shading) job_.shading = shading_;
        if (!job_.distances) job_.distances = distances_;
        if (!job_.precision) job_.precision = precision_;
        if (!job_.alpha) job_.alpha = alpha_;
    }

private:
    const Scene& scene_;
    RenderJob& job_;
    const MessageSink& messages_;
    std::optional<ShadingModel> shading_;
    std::optional<Distances> distances_;
    std::optional<Precision> precision_;
    std::optional<AlphaMapping> alpha_;

    [[noreturn]] void fail(const SceneOption& option, const std::string& text) {
        throw SceneError(scene_.sources.describe(option.span, "Parse Error", text));
    }

    template <typename T, std::size_t N>
    void choose(const SceneOption& option, const NameTable<T, N>& table, std::string_view what, std::optional<T>& place) {
        const std::optional<T> value = find_name(table, option.value);
        if (!value) fail(option, fmt::format("{}: {}", option.key, unknown_name_text(table, what, option.value)));
        place = value;
    }

    void refuse(const SceneOption& option, std::string_view where) {
        const auto in = [&](const auto& keys) { return std::find(keys.begin(), keys.end(), option.key) != keys.end(); };
        if (!in(known_keys) && !in(later_keys)) {
            const std::vector<std::string> known(known_keys.begin(), known_keys.end());
            fail(option, fmt::format("unknown raytrace option '{}'; expected one of {}{}", option.key, fmt::join(known_keys, ", "),
                                     did_you_mean(option.key, known)));
        }
        const std::string text = fmt::format("raytrace option '{}'{} is not available in this version", option.key, where);
        if (!job_.parse.lenient) fail(option, text);
        messages_(scene_.sources.describe(option.span, "Parse Warning", text));
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

void apply_scene_choices(const Scene& scene, RenderJob& job, const MessageSink& messages) {
    Chooser chooser(scene, job, messages);
    for (const SceneOption& option : scene.options) chooser.file_option(option);
    FinishOptions finishes;
    const auto use = [&](const SceneOption& option) { chooser.finish_option(option); };
    for (const Object& object : scene.objects) {
        if (object.texture) finishes.visit(*object.texture, use);
        if (object.interior_texture) finishes.visit(*object.interior_texture, use);
    }
    chooser.finish();
}

}  // namespace rt
