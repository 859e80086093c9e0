// finish { }
#include "syntax/blocks.h"
#include "syntax/choices.h"
#include "syntax/legacy_keywords.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// Which coefficients were stated as albedos in this block; they are scaled when it ends, by the exponents then in force.
struct Albedos {
    bool diffuse = false;
    bool phong = false;
    bool specular = false;
};

/// Normalisations that make the stated number the part of the light that is reflected, as POV-Ray defines them.
void scale_albedos(Finish& finish, const Albedos& albedos) {
    if (albedos.diffuse) {
        finish.diffuse *= (finish.brilliance + 1.0) / 2.0;
        finish.diffuse_back *= (finish.brilliance + 1.0) / 2.0;
    }
    if (albedos.phong) finish.phong *= (finish.phong_size + 1.0) / 2.0;
    if (albedos.specular) {
        const double exponent = 1.0 / finish.roughness.value_or(0.05);
        finish.specular *= (exponent + 2.0) / (4.0 * (2.0 - std::pow(2.0, -exponent / 2.0)));
    }
}

double parse_optional(Reader& reader, double when_absent) { return reader.at_expression() ? reader.parse_float() : when_absent; }

void parse_diffuse(Reader& reader, Finish& finish, Albedos& albedos) {
    albedos.diffuse = reader.accept(Word::albedo);
    finish.diffuse = reader.parse_float();
    reader.accept_comma();
    finish.diffuse_back = parse_optional(reader, 0.0);
}

void parse_roughness(Reader& reader, Finish& finish) {
    finish.roughness = reader.parse_float();
    if (*finish.roughness == 0.0) reader.warn(reader.peek().span, "Zero roughness used.");
}

bool at_any_color(Reader& reader) { return at_color(reader) || reader.at_expression(); }

void parse_reflection_items(Reader& reader, Reflection& reflection) {
    for (;;) {
        if (reader.accept(Word::fresnel)) {
            reflection.fresnel = reader.parse_bool_or(true);
        } else if (reader.accept(Word::falloff)) {
            reflection.falloff = reader.parse_float();
        } else if (reader.accept(Word::exponent)) {
            reflection.exponent = reader.parse_float();
        } else if (reader.accept(Word::metallic)) {
            reflection.metallic = parse_optional(reader, 1.0);
        } else {
            return;
        }
    }
}

/// One colour, or a block with one or two and its own items. With one colour `fresnel` starts from none.
void parse_reflection(Reader& reader, Reflection& reflection) {
    if (!reader.peek().is('{')) {
        if (at_any_color(reader)) reflection.min = reflection.max = parse_rgb(reader);
        return;
    }
    reader.begin_block("{");
    reflection.fresnel = false;
    if (at_any_color(reader)) reflection.min = reflection.max = parse_rgb(reader);
    reader.accept_comma();
    const bool range = at_any_color(reader);
    if (range) reflection.max = parse_rgb(reader);
    parse_reflection_items(reader, reflection);
    if (reflection.fresnel && !range) reflection.min = Rgb(0.0);
    reader.end_block();
}

/// The amount, then further items.
Irid parse_irid(Reader& reader, Irid irid) {
    reader.begin_block("irid");
    irid.amount = reader.parse_float();
    for (;;) {
        if (reader.accept(Word::thickness))
            irid.thickness = reader.parse_float();
        else if (reader.accept(Word::turbulence))
            irid.turbulence = reader.parse_float();
        else
            break;
    }
    reader.end_block();
    return irid;
}

bool accept_light_item(Reader& reader, Finish& finish, Albedos& albedos) {
    if (reader.accept(Word::ambient)) {
        finish.ambient = parse_rgb(reader);
    } else if (reader.accept(Word::emission)) {
        finish.emission = parse_rgb(reader);
    } else if (reader.accept(Word::diffuse)) {
        parse_diffuse(reader, finish, albedos);
    } else if (reader.accept(Word::brilliance)) {
        finish.brilliance = reader.parse_float();
    } else if (reader.accept(Word::phong)) {
        albedos.phong = reader.accept(Word::albedo);
        finish.phong = reader.parse_float();
    } else if (reader.accept(Word::phong_size)) {
        finish.phong_size = reader.parse_float();
    } else if (reader.accept(Word::specular)) {
        albedos.specular = reader.accept(Word::albedo);
        finish.specular = reader.parse_float();
    } else if (reader.accept(Word::roughness)) {
        parse_roughness(reader, finish);
    } else if (reader.accept(Word::metallic)) {
        finish.metallic = parse_optional(reader, 1.0);
    } else if (reader.accept(Word::reflection)) {
        parse_reflection(reader, finish.reflection);
    } else if (reader.accept(Word::reflection_exponent)) {
        finish.reflection.exponent = reader.parse_float();
    } else if (reader.accept(Word::conserve_energy)) {
        finish.conserve_energy = true;
    } else if (reader.accept(Word::crand)) {
        finish.crand = reader.parse_float();
    } else if (reader.accept(Word::irid)) {
        finish.irid = parse_irid(reader, finish.irid.value_or(Irid{}));
    } else {
        return false;
    }
    return true;
}

/// What has moved to `interior`: obeyed, with POV-Ray's warning.
bool accept_legacy_item(Reader& reader, Finish& finish) {
    std::optional<double>* value = nullptr;
    std::string_view warning;
    if (reader.accept(Word::ior)) {
        value = &finish.ior;
        warning = ior_moved;
    } else if (reader.accept(Word::refraction)) {
        value = &finish.refraction;
        warning = refraction_unnecessary;
    } else if (reader.accept(Word::caustics)) {
        value = &finish.caustics;
        warning = caustics_moved;
    } else {
        return false;
    }
    *value = reader.parse_float();
    reader.warn(reader.peek().span, warning);
    return true;
}

bool accept_unmodelled_finish_item(Reader& reader) {
    const Token next = reader.peek();
    if (reader.accept(Word::subsurface)) {
        skip_unmodelled_block(reader, next);
    } else {
        return false;
    }
    return true;
}

}  // namespace

Finish parse_finish(Reader& reader, Finish base) {
    reader.begin_block("finish");
    if (const Finish* declared = reader.accept_declared<Finish>()) base = *declared;
    const std::size_t inherited = base.options.size();
    const int level = inherited == 0 ? 0 : base.options.back().level + 1;
    Albedos albedos;
    while (accept_choices(reader, base.options) || accept_light_item(reader, base, albedos) || accept_legacy_item(reader, base) ||
           accept_unmodelled_finish_item(reader))
        continue;
    reader.end_block();
    scale_albedos(base, albedos);
    for (std::size_t i = inherited; i < base.options.size(); ++i) base.options[i].level = level;
    if (base.options.size() > inherited) reader.scene().finish_options.push_back(base.options);
    return base;
}

}  // namespace rt
