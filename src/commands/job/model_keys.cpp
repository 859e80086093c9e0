#include "commands/job/model_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands/base/values.h"
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
            // What was chosen for this model stays; what another brought of its own goes with that one.
            if (choice.brought_terms) m.terms = {};
            choice.brought_terms = false;
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
            choice.brought_terms = true;
            break;
        case Model::lecture:
            m.terms = lecture_terms();
            choice.brought_terms = true;
            break;
        case Model::none:
            m.specular = SurfaceModel::Specular::none;
            break;
    }
}

/// The choices of a row of the presets or materials.
void choose_all(ModelChoice& choice, std::string_view row) {
    for (const std::string& word : split(std::string(row), ' ')) {
        const std::size_t equals = word.find('=');
        choose(choice, std::string_view(word).substr(0, equals), std::string_view(word).substr(equals + 1));
    }
}

/// Nothing of an earlier preset stays: everything that some preset sets starts anew.
void choose_preset(ModelChoice& choice, std::string_view key, std::string_view value) {
    const std::string_view row = named(preset_names, key, value);
    const SurfaceModel unchosen;
    choice.model.terms = unchosen.terms;
    choice.brought_terms = false;
    choice.model.diffuse = unchosen.diffuse;
    choice.model.env = unchosen.env;
    choice.dw = 1.0;
    choice.lamps.law.kind = Attenuation::none;
    choose_all(choice, row);
}

/// Nothing of an earlier material stays either.
void choose_material(ModelChoice& choice, std::string_view key, std::string_view value) {
    const std::string_view row = named(material_names, key, value);
    for (std::optional<Rgb>* color : {&choice.eta, &choice.k, &choice.f0}) color->reset();
    choice.alpha.reset();
    choice.s.reset();
    choice.model.env = Surroundings::finish;
    choose_all(choice, row);
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

// What reads a choice: the surfaces whose result depends on it.
using Reader = bool (*)(const Shading&);

using Specular = SurfaceModel::Specular;
bool always(const Shading&) { return true; }
bool has_lobe(const Shading& x, Specular kind) { return x.model.s > 0.0 && x.model.specular == kind; }
bool is_microfacet(const Shading& x) { return has_lobe(x, Specular::microfacet); }
bool is_phong(const Shading& x) { return has_lobe(x, Specular::phong); }
bool has_exponent(const Shading& x) { return is_phong(x) || has_lobe(x, Specular::blinn_phong); }
bool has_env(const Shading& x) { return x.model.s > 0.0 && x.model.env != Surroundings::finish; }
bool has_env(const Shading& x, Surroundings kind) { return x.model.s > 0.0 && x.model.env == kind; }
/// Not by s itself: that is among what it answers for.
bool reflects(const Shading& x) { return x.model.specular != Specular::none || x.model.env != Surroundings::finish; }
bool reads_lobe(const Shading& x) { return is_microfacet(x) || has_env(x, Surroundings::albedo); }
bool reads_fresnel(const Shading& x) { return reads_lobe(x) || has_env(x, Surroundings::fresnel); }
bool reads_interface(const Shading& x) {
    return (reads_fresnel(x) && x.model.terms.F != Fresnel::one) || has_env(x, Surroundings::ct_effects);
}
bool reads_width(const Shading& x) { return reads_lobe(x) || has_env(x, Surroundings::ct_effects); }
/// An exponent that nobody states follows from a stated alpha, whatever the least width.
bool reads_alpha(const Shading& x) { return reads_width(x) || has_exponent(x); }
bool reads_dw(const Shading& x) { return is_microfacet(x) || has_env(x, Surroundings::ct_effects); }
bool reads_blinn_power(const Shading& x) {
    return reads_lobe(x) && (x.model.terms.D == Distribution::blinn || x.model.terms.D == Distribution::blinn_inverse_roughness);
}
bool has_distances(const Shading& x) {
    return std::any_of(x.lights.begin(), x.lights.end(), [](const Light& light) { return !light.parallel; });
}
bool has_spots(const Shading& x) {
    return std::any_of(x.lights.begin(), x.lights.end(), [](const Light& light) { return light.type == Light::Type::spotlight; });
}
bool reads_clamp(const Shading& x) { return is_phong(x) || (x.lamps.exponent_spots && has_spots(x)); }

struct Key {
    ModelKey text;
    Chooser apply;
    Reader read;
};

constexpr std::array keys{
    Key{{"preset", "NAME", ""}, choose_preset, always},
    Key{{"material", "NAME", ""}, choose_material, reflects},
    Key{{"shading", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { choose_model(c, named(model_names, key, v)); },
        always},
    Key{{"diffuse", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.diffuse = named(diffuse_names, key, v); },
        always},
    Key{{"D", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.D = named(distribution_names, key, v); },
        reads_lobe},
    Key{{"G", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.G = named(masking_names, key, v); },
        reads_lobe},
    Key{{"F", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.F = named(fresnel_names, key, v); },
        reads_fresnel},
    Key{{"alpha", "NAME", "roughness2 (default), povray, direct or a number"}, choose_alpha, reads_alpha},
    Key{{"alpha-floor", "X", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.alpha_floor = number(key, v, 0.0, 1e6); },
        reads_width},
    Key{{"env", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.env = named(surroundings_names, key, v); },
        always},
    Key{{"env-clamp", "X", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.env_limit = std::min(number(key, v, 0.0, any), largest_lobe);
        },
        has_env},
    Key{{"s", "X", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.s = number(key, v, 0.0, 1.0); }, reflects},
    Key{{"eta", "X|R,G,B", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.f0.reset(), c.eta = index_of_refraction(key, v); },
        reads_interface},
    Key{{"k", "X|R,G,B", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.f0.reset(), c.k = one_or_three(key, v, 0.0, any); },
        reads_interface},
    Key{{"f0", "X|R,G,B", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.eta.reset(), c.k.reset(), c.f0 = one_or_three(key, v, 0.0, 1.0); },
        reads_interface},
    Key{{"exponent", "P", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.exponent = number(key, v, 0.0, any); },
        has_exponent},
    Key{{"sigma", "RADIANS", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.oren_nayar = OrenNayar(number(key, v, 0.0, any)); },
        [](const Shading& x) { return x.model.diffuse == Diffuse::oren_nayar; }},
    Key{{"fresnel-arg", "vh|nv", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.fresnel_at_view = second_of(key, v, "vh", "nv"); },
        is_microfacet},
    Key{{"half", "lv|nv", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.terms.half_of_normal_and_view = second_of(key, v, "lv", "nv");
        },
        is_microfacet},
    Key{{"norm", "NAME", ""}, choose_norm, is_microfacet},
    Key{{"blinn-power", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.blinn_inverse_roughness = second_of(key, v, "normalised", "inverse-roughness");
        },
        reads_blinn_power},
    Key{{"units", "printed|physical", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.units = second_of(key, v, "printed", "physical") ? pi : 1.0; },
        is_microfacet},
    Key{{"dw", "X", ""}, [](ModelChoice& c, std::string_view key, std::string_view v) { c.dw = number(key, v, 0.0, any); }, reads_dw},
    Key{{"denominator", "exact|clamped", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.terms.clamped_denominator = second_of(key, v, "exact", "clamped");
        },
        is_microfacet},
    Key{{"raw", "off|on", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.terms.without_cosine = second_of(key, v, "off", "on"); },
        is_microfacet},
    Key{{"ambient", "once|per-light", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.ambient_per_light = second_of(key, v, "once", "per-light");
        },
        always},
    Key{{"attenuate-ambient", "off|on", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.attenuate_ambient = second_of(key, v, "off", "on"); },
        [](const Shading& x) { return x.model.ambient_per_light; }},
    Key{{"clamp", "before|after", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            // Of a finish only its own half counts, about Phong's highlight: the lamps obey the file and the command line.
            c.model.clamp_after = c.lamps.clamp_after = second_of(key, v, "before", "after");
        },
        reads_clamp},
    Key{{"phong-gate", "on|off", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.model.phong_gate = !second_of(key, v, "on", "off"); },
        is_phong},
    Key{{"att", "NAME", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.lamps.law.kind = named(attenuation_names, key, v); },
        has_distances},
    Key{{"att-coefficients", "C,L,Q", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            const Rgb numbers = one_or_three(key, v, 0.0, any);
            if (numbers == Rgb(0.0)) throw OptionError(fmt::format("{}: not all of them can be 0", key));
            c.lamps.law.kind = Attenuation::polynomial;
            c.lamps.law.constant = numbers[0], c.lamps.law.linear = numbers[1], c.lamps.law.quadratic = numbers[2];
        },
        [](const Shading& x) { return x.lamps.law.kind == Attenuation::polynomial && has_distances(x); }},
    Key{{"range", "X", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.lamps.law.range = number(key, v, 0.0, any); },
        has_distances},
    Key{{"spot", "povray|exponent", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) { c.lamps.exponent_spots = second_of(key, v, "povray", "exponent"); },
        has_spots},
    Key{{"gooch", "warm|as-printed", ""},
        [](ModelChoice& c, std::string_view key, std::string_view v) {
            c.model.gooch.as_printed = second_of(key, v, "warm", "as-printed");
        },
        [](const Shading& x) { return x.model.diffuse == Diffuse::gooch; }},
};

/// Null for a key that is none of the catalogue's.
const Key* find_key(std::string_view key) {
    const auto known = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.text.key == key; });
    return known == keys.end() ? nullptr : &*known;
}

}  // namespace

bool is_lamp_key(std::string_view key) { return key == "att" || key == "att-coefficients" || key == "range" || key == "spot"; }

std::string lamp_choices_of_preset(std::string_view name) {
    std::string choices;
    for (const std::string& word : split(find_named(preset_names, name).value_or(""), ' '))
        if (is_lamp_key(std::string_view(word).substr(0, word.find('=')))) choices += (choices.empty() ? "" : " ") + word;
    return choices;
}

bool is_model_key(std::string_view key) { return find_key(key) != nullptr; }

std::span<const ModelKey> model_keys() {
    static const auto texts = [] {
        std::array<ModelKey, keys.size()> result;
        std::transform(keys.begin(), keys.end(), result.begin(), [](const Key& key) { return key.text; });
        return result;
    }();
    return texts;
}

void choose(ModelChoice& choice, std::string_view key, std::string_view value) {
    const Key* known = find_key(key);
    if (known == nullptr) throw OptionError(fmt::format("'{}' is no choice of shading", key));
    known->apply(choice, key, value);
}

bool is_read(std::string_view key, const Shading& shading) {
    const Key* known = find_key(key);
    return known != nullptr && known->read(shading);
}

}  // namespace rt
