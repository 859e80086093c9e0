// sky_sphere { }, fog { } and rainbow { }.
#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

void move(Reader& reader, const Span& place, Pigment& pigment, const Transform& t) {
    if (auto* pattern = std::get_if<Shared<PatternPigment>>(&pigment.content)) {
        append(pattern->edit().pattern.pattern, t);
        require_finite(reader, place, std::get<Transform>(pattern->edit().pattern.pattern.warps.back()));
    }
}

void parse_fog_type(Reader& reader, Fog& fog) {
    const int type = parse_int(reader);
    if (type != 1 && type != 2) reader.warn(reader.peek().span, "Unknown fog type.");
    fog.type = type == 2 ? Fog::Type::ground : Fog::Type::constant;
}

bool accept_fog_item(Reader& reader, Fog& fog) {
    if (at_color(reader)) {
        fog.color = parse_color(reader);
    } else if (reader.accept(Word::distance)) {
        fog.distance = reader.parse_float();
    } else if (reader.accept(Word::fog_type)) {
        parse_fog_type(reader, fog);
    } else if (reader.accept(Word::fog_alt)) {
        fog.altitude = reader.parse_float();
    } else if (reader.accept(Word::fog_offset)) {
        fog.offset = reader.parse_float();
    } else if (reader.accept(Word::up)) {
        fog.up = reader.parse_vector();
    } else if (reader.accept(Word::turb_depth)) {
        fog.turbulence_depth = static_cast<float>(reader.parse_float());
    } else if (accept_turbulence_item(reader, fog.turbulence)) {
        return true;
    } else if (const std::optional<Transform> t = accept_transform(reader)) {
        fog.up = t->direction(fog.up);
    } else if (reader.at_expression() && !reader.peek().is('<')) {
        fog.distance = reader.parse_float();
        reader.warn(reader.peek().span, "Should use distance keyword.");
    } else {
        return false;
    }
    return true;
}

bool accept_rainbow_item(Reader& reader, Rainbow& bow, std::optional<double>& falloff) {
    if (reader.accept(Word::direction)) {
        bow.direction = reader.parse_vector();
    } else if (reader.accept(Word::angle)) {
        bow.angle = reader.parse_float();
    } else if (reader.accept(Word::width)) {
        bow.width = reader.parse_float();
    } else if (reader.accept(Word::distance)) {
        bow.distance = reader.parse_float();
    } else if (reader.accept(Word::jitter)) {
        bow.jitter = reader.parse_float();
    } else if (reader.accept(Word::up)) {
        bow.up = reader.parse_vector();
    } else if (reader.accept(Word::arc_angle)) {
        bow.arc_angle = 0.5 * reader.parse_float();
    } else if (reader.accept(Word::falloff_angle)) {
        falloff = 0.5 * reader.parse_float();
    } else if (reader.accept(Word::color_map) || reader.accept(Word::colour_map)) {
        bow.colors = parse_color_map(reader);
    } else {
        return false;
    }
    return true;
}

}  // namespace

SkySphere parse_sky_sphere(Reader& reader) {
    reader.begin_block("sky_sphere");
    SkySphere sky;
    if (const SkySphere* declared = reader.accept_declared<SkySphere>()) sky = *declared;
    for (;;) {
        const Token next = reader.peek();
        if (reader.accept(Word::pigment)) {
            sky.pigments.push_back(parse_pigment(reader, default_pigment(reader)));
            limit_size(reader, next.span, tree_size(sky.pigments.back()));
            reader.count_scene_nodes(next.span, tree_size(sky.pigments.back()).nodes);
        } else if (reader.accept(Word::emission)) {
            sky.emission = parse_rgb(reader);
        } else if (const std::optional<Transform> t = accept_transform(reader)) {
            for (Pigment& pigment : sky.pigments) move(reader, next.span, pigment, *t);
        } else {
            break;
        }
    }
    if (sky.pigments.empty() && reader.at_block_end()) reader.fail(reader.peek().span, "Empty sky_sphere statement.");
    reader.end_block();
    return sky;
}

Fog parse_fog(Reader& reader) {
    reader.begin_block("fog");
    Fog fog;
    if (const Fog* declared = reader.accept_declared<Fog>()) fog = *declared;
    while (accept_fog_item(reader, fog)) reader.accept_comma();
    if (length(fog.up) > 0.0) fog.up = unit(fog.up);
    reader.end_block();
    return fog;
}

Rainbow parse_rainbow(Reader& reader) {
    reader.begin_block("rainbow");
    Rainbow bow;
    std::optional<double> falloff;
    if (const Rainbow* declared = reader.accept_declared<Rainbow>()) bow = *declared;
    const Rainbow before = bow;
    while (accept_rainbow_item(reader, bow, falloff)) continue;
    bow.falloff_angle = falloff.value_or(bow == before ? bow.falloff_angle : std::fmin(bow.falloff_angle, bow.arc_angle));
    const Span place = reader.peek().span;
    if (reader.at_block_end()) {
        if (bow.direction == Vec3(0.0)) reader.fail(place, "Rainbow's direction vector is zero.");
        if (length(cross(bow.direction, bow.up)) < 1e-10) reader.fail(place, "Rainbow's up and direction vector are co-linear.");
        if (bow.falloff_angle > bow.arc_angle) reader.fail(place, "Arc angle is smaller than falloff angle in rainbow.");
    }
    reader.end_block();
    return bow;
}

}  // namespace rt
