#include "commands/model_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands/values.h"
#include "core/source.h"
#include "shading/names.h"

namespace rt {

namespace {

constexpr double any = HUGE_VAL;

template <typename T, std::size_t N>
T named(const std::array<Named<T>, N>& table, std::string_view key, std::string_view name) {
    if (const std::optional<T> value = find_named(table, name)) return *value;
    throw OptionError(
        fmt::format("{}: '{}' is unknown; expected one of {}{}", key, name, key == "shading" ? "povray, " : "", known_names(table)));
}

/// One of two words; true for the second.
bool second_of(std::string_view key, std::string_view value, std::string_view first, std::string_view second) {
    if (value == first || value == second) return value == second;
    throw OptionError(fmt::format("{}: '{}' is unknown; expected {} or {}", key, value, first, second));
}

double number(std::string_view key, std::string_view value, double least, double most) {
    return real_number(std::string(key), std::string(value), least, most);
}

/// An index of refraction, for all channels or each.
Rgb index_of_refraction(std::string_view key, std::string_view value) {
    const Rgb eta = one_or_three(key, value, -any, any);
    for (int channel = 0; channel < 3; ++channel)
        if (!(eta[channel] > 0.0)) throw OptionError(fmt::format("{}: expected an index of refraction above 0, not '{}'", key, value));
    return eta;
}

void choose_model(ModelChoice& choice, Model model) {
    SurfaceModel& m = choice.model;
    m.specular = SurfaceModel::Specular::microfacet;
    m.shares = model == Model::cook_torrance;
    m.lecture = model == Model::lecture;
    switch (model) {
        case Model::cook_torrance:
            m.terms = {};
            break;
        case Model::phong:
            m.specular = SurfaceModel::Specular::phong;
            break;
        case Model::blinn_phong:
            m.specular = SurfaceModel::Specular::blinn_phong;
            break;
        case Model::ct_effects:
        case Model::ct_effects_linear:
            m.terms = effects_terms(1.0, model == Model::ct_effects_linear);
            break;
        case Model::lecture:
            m.terms = lecture_terms();
            break;
        case Model::none:
            m.specular = SurfaceModel::Specular::none;
            break;
    }
}

void choose_all(ModelChoice& choice, std::string_view row) {
    for (const std::string& word : split(std::string(row), ' ')) {
        const std::size_t equals = word.find('=');
        choose(choice, std::string_view(word).substr(0, equals), std::string_view(word).substr(equals + 1));
    }
}

using Chooser = void (*)(ModelChoice&, std::string_view key, std::string_view value);

void choose_alpha(ModelChoice& choice, std::string_view key, std::string_view value) {
    if (value == "roughness2" || value == "povray" || value == "direct") {
        choice.mapping = value == "direct" ? AlphaMapping::direct : value == "povray" ? AlphaMapping::povray : AlphaMapping::roughness2;
        choice.alpha.reset();
    } else {
        if (value.find_first_of("0123456789") == std::string_view::npos)
            throw OptionError(fmt::format("{}: '{}' is unknown; expected roughness2, povray, direct or a number", key, value));
        choice.alpha = number(key, value, 0.0, 1e6);
    }
}

void choose_norm(ModelChoice& choice, std::string_view key, std::string_view value) {
    // ct4m2 is the same function as the normalised form, printed with another outer constant.
    if (value != "normalised" && value != "ct4m2" && value != "ct1982")
        throw OptionError(fmt::format("{}: '{}' is unknown; expected one of normalised, ct4m2, ct1982", key, value));
    choice.norm = value == "ct1982" ? 4.0 : 1.0;
}

struct Key {
    ModelKey text;
    Chooser apply;
};

constexpr std::array keys{
    Key{{"preset", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { choose_all(c, named(preset_names, key, v)); }},
    Key{{"material", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { choose_all(c, named(material_names, key, v)); }},
    Key{{"shading", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { choose_model(c, named(model_names, key, v)); }},
    Key{{"diffuse", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.diffuse = named(diffuse_names, key, v); }},
    Key{{"D", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.D = named(distribution_names, key, v); }},
    Key{{"G", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.G = named(masking_names, key, v); }},
    Key{{"F", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.F = named(fresnel_names, key, v); }},
    Key{{"alpha", "NAME", "roughness2 (default), povray, direct or a number"}, choose_alpha},
    Key{{"alpha-floor", "X", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.alpha_floor = number(key, v, 0.0, 1e6); }},
    Key{{"env", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.env = named(surroundings_names, key, v); }},
    Key{{"env-clamp", "X", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.env_limit = std::min(number(key, v, 0.0, any), largest_lobe);
        }},
    Key{{"s", "X", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.s = number(key, v, 0.0, 1.0); }},
    Key{{"eta", "X|R,G,B", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.eta = index_of_refraction(key, v); }},
    Key{{"k", "X|R,G,B", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.k = one_or_three(key, v, 0.0, any); }},
    Key{{"f0", "X|R,G,B", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.f0 = one_or_three(key, v, 0.0, 1.0); }},
    Key{{"exponent", "P", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.exponent = number(key, v, 0.0, any); }},
    Key{{"sigma", "RADIANS", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.oren_nayar = OrenNayar(number(key, v, 0.0, any)); }},
    Key{{"fresnel-arg", "vh|nv", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.fresnel_at_view = second_of(key, v, "vh", "nv"); }},
    Key{{"half", "lv|nv", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.terms.half_of_normal_and_view = second_of(key, v, "lv", "nv");
        }},
    Key{{"norm", "NAME", ""}, choose_norm},
    Key{{"blinn-power", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            const bool inverse = second_of(key, v, "normalised", "inverse-roughness");
            c.model.terms.D = inverse ? Distribution::blinn_inverse_roughness : Distribution::blinn;
        }},
    Key{{"units", "printed|physical", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.units = second_of(key, v, "printed", "physical") ? pi : 1.0; }},
    Key{{"dw", "X", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.dw = number(key, v, 0.0, any); }},
    Key{{"denominator", "exact|clamped", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.terms.clamped_denominator = second_of(key, v, "exact", "clamped");
        }},
    Key{{"raw", "off|on", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.without_cosine = second_of(key, v, "off", "on"); }},
    Key{{"ambient", "once|per-light", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.ambient_per_light = second_of(key, v, "once", "per-light");
        }},
    Key{{"attenuate-ambient", "off|on", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.attenuate_ambient = second_of(key, v, "off", "on"); }},
    Key{{"clamp", "before|after", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.clamp_after = c.lamps.clamp_after = second_of(key, v, "before", "after");
        }},
    Key{{"phong-gate", "on|off", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.phong_gate = !second_of(key, v, "on", "off"); }},
    Key{{"att", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.lamps.law.kind = named(attenuation_names, key, v); }},
    Key{{"att-coefficients", "C,L,Q", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            const Rgb numbers = one_or_three(key, v, 0.0, any);
            if (numbers == Rgb(0.0)) throw OptionError(fmt::format("{}: not all of them can be 0", key));
            c.lamps.law.kind = Attenuation::polynomial;
            c.lamps.law.constant = numbers[0], c.lamps.law.linear = numbers[1], c.lamps.law.quadratic = numbers[2];
        }},
    Key{{"range", "X", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.lamps.law.range = number(key, v, 0.0, any); }},
    Key{{"spot", "povray|exponent", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.lamps.exponent_spots = second_of(key, v, "povray", "exponent"); }},
    Key{{"gooch", "warm|as-printed", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.gooch.as_printed = second_of(key, v, "warm", "as-printed");
        }},
};

/// Presets before materials before models before single terms, whatever their order in the text.
template <typename Option, typename Apply>
void apply_in_order(std::span<const Option> options, const Apply& apply) {
    for (const std::string_view first : {"preset", "material", "shading"})
        for (const Option& option : options)
            if (option.key == first) apply(option);
    for (const Option& option : options)
        if (option.key != "preset" && option.key != "material" && option.key != "shading") apply(option);
}

void apply_scene(const Scene& scene, ModelChoice& choice, std::span<const SceneOption> options) {
    apply_in_order(options, [&](const SceneOption& option) {
        if (!is_model_key(option.key) || (option.key == "shading" && option.value == "povray")) return;
        try {
            choose(choice, option.key, option.value);
        } catch (const OptionError& error) {
            throw SceneError(scene.sources.describe(option.span, "Parse Error", error.what()));
        }
    });
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

bool is_lamp_key(std::string_view key) { return key == "att" || key == "att-coefficients" || key == "range" || key == "spot"; }

bool is_model_key(std::string_view key) {
    return std::any_of(keys.begin(), keys.end(), [&](const Key& known) { return known.text.key == key; });
}

std::span<const ModelKey> model_keys() {
    static const auto texts = [] {
        std::array<ModelKey, keys.size()> result;
        std::transform(keys.begin(), keys.end(), result.begin(), [](const Key& key) { return key.text; });
        return result;
    }();
    return texts;
}

void choose(ModelChoice& choice, std::string_view key, std::string_view value) {
    for (const Key& known : keys)
        if (known.text.key == key) return known.apply(choice, key, value);
    throw OptionError(fmt::format("'{}' is no choice of shading", key));
}

ModelChoice choice_for(const Scene& scene, const std::vector<SceneOption>& finish, const std::vector<ModelOption>& command_line) {
    ModelChoice choice;
    apply_scene(scene, choice, scene.options);
    apply_scene(scene, choice, finish);
    apply_in_order(std::span<const ModelOption>(command_line),
                   [&](const ModelOption& option) { choose(choice, option.key, option.value); });
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
