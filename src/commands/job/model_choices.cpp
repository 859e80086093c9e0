#include "commands/job/model_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/source.h"
#include "shading/names.h"

namespace rt {

namespace {

/// The last statement of `key`, which counts; null without one.
template <typename Option>
const Option* stated(std::span<const Option> options, std::string_view key) {
    const Option* last = nullptr;
    for (const Option& option : options)
        if (option.key == key) last = &option;
    return last;
}

/// Calls refuse(option, text) for an option of a level that another one there contradicts.
template <typename Option, typename Refuse>
void refuse_contradictions(std::span<const Option> level, const Refuse& refuse) {
    for (const std::string_view index : {"eta", "k"})
        if (const Option* f0 = stated(level, "f0"); f0 && stated(level, index))
            refuse(*f0, fmt::format("f0: '{}' is stated as well, and each says what the surface reflects; expected one of them", index));
    const Option *coefficients = stated(level, "att-coefficients"), *law = stated(level, "att");
    if (coefficients && law && law->value != "polynomial")
        refuse(*coefficients,
               fmt::format("att-coefficients: 'att={}' is stated as well, and they are the numbers of att=polynomial", law->value));
}

/// Presets before materials before models before single terms, whatever their order in the text.
template <typename Option, typename Apply>
void apply_in_order(std::span<const Option> level, const Apply& apply) {
    for (const std::string_view first : {"preset", "material", "shading"})
        for (const Option& option : level)
            if (option.key == first) apply(option);
    for (const Option& option : level)
        if (option.key != "preset" && option.key != "material" && option.key != "shading") apply(option);
}

void apply_level(const Scene& scene, ModelChoice& choice, std::span<const SceneOption> level) {
    const auto refuse = [&](const SceneOption& option, std::string_view text) {
        throw SceneError(scene.sources.describe(option.span, "Parse Error", text));
    };
    apply_in_order(level, [&](const SceneOption& option) {
        if (!is_model_key(option.key) || (option.key == "shading" && option.value == "povray")) return;
        try {
            choose(choice, option.key, option.value);
        } catch (const OptionError& error) {
            refuse(option, error.what());
        }
    });
    refuse_contradictions(level, refuse);
}

/// What a finish states is a level above what it inherited from a declared one.
void apply_scene(const Scene& scene, ModelChoice& choice, std::span<const SceneOption> options) {
    while (!options.empty()) {
        const auto next = std::find_if(options.begin(), options.end(), [&](const SceneOption& o) { return o.level != options[0].level; });
        const auto count = static_cast<std::size_t>(next - options.begin());
        apply_level(scene, choice, options.first(count));
        options = options.subspan(count);
    }
}

/// "D  ggx (S1), beckmann (S0 S1 S4), ..." on lines of at most 79 columns.
template <typename T, std::size_t N>
void list(std::string& text, std::string_view key, const std::array<Named<T>, N>& table) {
    std::string line = fmt::format("{:<9}", key);
    for (std::size_t i = 0; i < N; ++i) {
        const std::string entry = fmt::format(" {} ({}){}", table[i].name, table[i].origin, i + 1 < N ? "," : "");
        if (line.size() + entry.size() > 79) {
            text += line + '\n';
            line = std::string(9, ' ');
        }
        line += entry;
    }
    text += line + '\n';
}

}  // namespace

void check_together(std::span<const ModelOption> command_line) {
    refuse_contradictions(command_line, [](const ModelOption&, const std::string& text) { throw OptionError(text); });
}

ModelChoice choice_for(const Scene& scene, const std::vector<SceneOption>& finish, const std::vector<ModelOption>& command_line) {
    ModelChoice choice;
    const auto apply_options = [&](bool implied) {
        apply_in_order(std::span<const ModelOption>(command_line), [&](const ModelOption& option) {
            if (option.implied == implied) choose(choice, option.key, option.value);
        });
    };
    apply_options(true);
    apply_scene(scene, choice, scene.options);
    apply_scene(scene, choice, finish);
    apply_options(false);
    check_together(command_line);
    return choice;
}

std::string catalogue_text() {
    std::string text;
    list(text, "shading", model_names);
    list(text, "diffuse", diffuse_names);
    list(text, "D", distribution_names);
    list(text, "G", masking_names);
    list(text, "F", fresnel_names);
    list(text, "env", surroundings_names);
    list(text, "att", attenuation_names);
    list(text, "preset", preset_names);
    list(text, "material", material_names);
    return text;
}

}  // namespace rt
