// light_source { }
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "syntax/blocks.h"
#include "syntax/light_objects.h"
#include "syntax/object_draft.h"
#include "syntax/parameters.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

constexpr int max_samples_per_axis = 4096;

/// spotlight and cylinder reset their three numbers, whatever was stated before.
void set_cone(Light& light, Light::Type type, double radius, double falloff) {
    light.type = type;
    light.radius = radius;
    light.falloff = falloff;
    light.tightness = 0.0;
}

int parse_size(Reader& reader) {
    const Span begin = reader.peek().span;
    const int size = std::abs(parse_int(reader));
    if (size == 0) reader.fail(reader.peek().span, "Area size must be greater than zero.");
    if (size > max_samples_per_axis) reader.fail(begin, fmt::format("Area size must be at most {}.", max_samples_per_axis));
    return size;
}

void parse_area(Reader& reader, AreaLight& area) {
    area.axis1 = reader.parse_vector();
    reader.accept_comma();
    area.axis2 = reader.parse_vector();
    reader.accept_comma();
    area.size1 = parse_size(reader);
    reader.accept_comma();
    area.size2 = parse_size(reader);
}

/// The keywords of spotlights, cylinders and (point_at) parallel lights.
bool accept_cone_item(Reader& reader, Light& light) {
    const Token next = reader.peek();
    double* value = nullptr;
    if (next.is(Word::radius)) value = &light.radius;
    if (next.is(Word::falloff)) value = &light.falloff;
    if (next.is(Word::tightness)) value = &light.tightness;
    if (!value && !next.is(Word::point_at)) return false;
    const bool known = light.type != Light::Type::point || (light.parallel && !value);
    if (!known) reader.fail(next.span, fmt::format("Keyword '{}' cannot be used with standard light source.", text(next.word)));
    reader.take();
    if (value)
        *value = reader.parse_float();
    else
        light.point_at = reader.parse_vector();
    return true;
}

/// `area` is kept apart until the block ends: its keywords may come before `area_light`.
bool accept_area_item(Reader& reader, AreaLight& area, bool& is_area) {
    const Token next = reader.peek();
    if (reader.accept(Word::area_light)) {
        is_area = true;
        parse_area(reader, area);
    } else if (reader.accept(Word::adaptive)) {
        area.adaptive = std::clamp(parse_int(reader), 0, 100);
    } else if (reader.accept(Word::jitter)) {
        reader.warn(next.span, "Jitter of area lights is not modelled and is ignored.");
    } else if (reader.accept(Word::circular)) {
        area.circular = true;
    } else if (reader.accept(Word::orient)) {
        area.orient = true;
    } else if (reader.accept(Word::area_illumination)) {
        area.area_illumination = reader.parse_bool_or(true);
    } else {
        return false;
    }
    return true;
}

/// To POV-Ray `spotlight`, `cylinder` and `shadowless` are kinds of light: the last one stated holds. That a cylinder light is parallel
/// outlives it.
bool accept_general_item(Reader& reader, Light& light) {
    if (reader.accept(Word::spotlight)) {
        set_cone(light, Light::Type::spotlight, 30.0, 45.0);
        light.shadowless = false;
    } else if (reader.accept(Word::cylinder)) {
        set_cone(light, Light::Type::cylinder, 0.75, 1.0);
        light.shadowless = false;
        light.parallel = true;
    } else if (reader.accept(Word::parallel)) {
        light.parallel = true;
    } else if (reader.accept(Word::shadowless)) {
        light.type = Light::Type::point;
        light.shadowless = true;
    } else if (reader.accept(Word::fade_distance)) {
        light.fade_distance = reader.parse_float();
    } else if (reader.accept(Word::media_attenuation)) {
        light.media_attenuation = reader.parse_bool_or(true);
    } else if (reader.accept(Word::fade_power)) {
        light.fade_power = reader.parse_float();
    } else {
        return false;
    }
    return true;
}

/// Keywords about media and photons say nothing where there are none: both are reported where they are asked for.
bool accept_unmodelled_light_item(Reader& reader) {
    if (reader.accept(Word::media_interaction)) {
        reader.parse_bool_or(true);
    } else if (reader.accept(Word::photons)) {
        skip_inner_block(reader);
    } else {
        return false;
    }
    return true;
}

void move(Reader& reader, const Span& place, Light& light, AreaLight& area, const Transform& t) {
    light.location = t.point(light.location);
    light.point_at = t.point(light.point_at);
    area.axis1 = t.direction(area.axis1);
    area.axis2 = t.direction(area.axis2);
    for (const Vec3& v : {light.location, light.point_at, area.axis1, area.axis2}) require_finite(reader, place, v);
    if (light.mask) move_mask(reader, place, light.mask->edit(), t);
}

/// POV-Ray's checks at the end of the block.
void check_area(Reader& reader, const Span& place, AreaLight& area, bool is_area) {
    if (!is_area && area.circular) reader.warn(place, "Circular only affects area_light");
    if (!is_area && area.orient) reader.warn(place, "Orient only affects area_light");
    if (!is_area && area.area_illumination) reader.warn(place, "Area_illumination only affects area_light");
    const bool thin = area.size1 < 2 || area.size2 < 2;
    if (area.circular && thin) reader.fail(place, "Circular area light must have more than 1 point per axis");
    if (!area.orient) return;
    if (!area.circular) {
        reader.warn(place, "Orient can only be used with circular area lights. This area light is now circular.");
        area.circular = true;
    }
    if (std::fabs(length(area.axis1) - length(area.axis2)) > 1e-10)
        reader.warn(
            place,
            "When using orient, the two axes of the area light must be of equal length. Only the length of the first axis will be used.");
    if (area.size1 != area.size2) reader.warn(place, "When using orient, the two sample sizes for the area light should be equal.");
    if (thin) {
        reader.warn(place, "Circular area lights must have more than one sample along each axis.");
        area.circular = false;  // the disc's formula divides by the size less one
    }
}

}  // namespace

void transform_light(Reader& reader, const Span& place, Light& light, const Transform& t) {
    AreaLight none;
    move(reader, place, light, light.area ? *light.area : none, t);
}

[[gnu::noinline]] Placeable parse_light(Reader& reader) {
    const Span begin = reader.peek().span;
    reader.begin_block("light_source");
    if (const Light* declared = reader.accept_declared<Light>()) {
        Light copy = *declared;
        modify_light(reader, begin, copy);
        reader.end_block();
        return copy;
    }
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) return finish_object(reader, draft_of(*declared), nullptr);
    Light light;
    light.span = begin;
    light.location = reader.parse_vector();
    reader.accept_comma();
    light.color = parse_rgb(reader);
    AreaLight area;
    bool is_area = false;
    std::optional<LightLook> look;
    for (;;) {
        const Span place = reader.peek().span;
        if (const std::optional<Transform> t = accept_transform(reader)) {
            move(reader, place, light, area, *t);
            if (look) look->move(reader, place, *t);
        } else if (!accept_general_item(reader, light) && !accept_cone_item(reader, light) && !accept_area_item(reader, area, is_area) &&
                   !accept_unmodelled_light_item(reader) && !accept_light_object(reader, light, look)) {
            break;
        }
    }
    const Span end = reader.peek().span;
    reader.end_block();
    check_area(reader, end, area, is_area);
    if (is_area) light.area = area;
    if (!look) return light;
    return look->with(reader, std::move(light));
}

}  // namespace rt
