#include "syntax/light_objects.h"

#include "syntax/object_draft.h"
#include "syntax/parameters.h"
#include "syntax/set_value.h"

namespace rt {

namespace {

/// `projected_through { }` after its word. A light has no surface that another one could shine through.
[[gnu::noinline]] Mask parse_mask(Reader& reader, const Span& place) {
    Placeable held = parse_object_block(reader, "projected_through");
    auto* const value = std::get_if<ObjectValue>(&held);
    if (!value || !value->exists()) return {};
    const Object& stated = value->set ? (*value->set)->whole : value->objects.front();
    if (stated.texture) reader.warn(place, "Projected through objects can not have texture, texture removed.");
    if (stated.interior) reader.warn(place, "Projected through objects can not have interior, interior removed.");
    Parts parts = resolved(std::move(*value));
    reader.count_parts(place, size_of(parts));
    return mask_of(std::move(parts));
}

/// Of what shows a light the light is the last one.
bool is_light(const Placeable& item) {
    const auto* const value = std::get_if<ObjectValue>(&item);
    return !value || (value->set && (*value->set)->kind == SetValue::Kind::light);
}

}  // namespace

/// It stands where the light is, but for its modifiers, and lets all light through.
LightLook::LightLook(Reader& reader, const Light& light) : parts_(std::make_unique<SetValue>(empty_set(SetValue::Kind::light))) {
    const Span place = reader.last_place();
    add_item(reader, place, *parts_, parse_object_block(reader, "looks_like", light.location), false);
    for (Object& object : parts_->parts.objects) {
        object.no_shadow = true;
        object.shows_light = true;
    }
    limit_depth(reader, place, parts_->parts.set);
}

void LightLook::move(Reader& reader, const Span& place, const Transform& t) { move_set(reader, place, *parts_, t); }

ObjectValue LightLook::with(Reader& reader, Light light) {
    parts_->whole.span = light.span;
    add_item(reader, light.span, *parts_, std::move(light), false);
    ObjectValue value;
    value.set = std::move(*parts_);
    value.extent = Extent{};  // a light has no end
    return value;
}

bool accept_light_object(Reader& reader, Light& light, std::optional<LightLook>& look) {
    const Span place = reader.peek().span;
    if (reader.accept(Word::looks_like)) {
        if (look) reader.fail(place, "Only one looks_like allowed per light_source.");
        look.emplace(reader, light);
    } else if (reader.accept(Word::projected_through)) {
        if (light.mask) reader.fail(place, "Only one projected through allowed per light_source.");
        light.mask = parse_mask(reader, place);
    } else {
        return false;
    }
    return true;
}

void move_mask(Reader& reader, const Span& place, Mask& mask, const Transform& t) {
    const auto move = [&](std::vector<Solid>& solids) {
        for (Solid& solid : solids) {
            append(solid.transform, t);
            require_finite(reader, place, *solid.transform);
        }
    };
    move(mask.surfaces);
    for (ObjectSet& set : mask.sets) move(set.solids);
}

[[gnu::noinline]] ObjectValue parse_light_group(Reader& reader) {
    auto group = std::make_unique<SetValue>(empty_set(SetValue::Kind::union_));
    group->whole.span = reader.last_place();
    reader.begin_block("light_group");
    std::vector<std::size_t> own_lights;
    for (;;) {
        const Span place = reader.peek().span;
        std::optional<Placeable> held = accept_object(reader);
        if (!held) break;
        const bool light = is_light(*held);
        add_item(reader, place, *group, std::move(*held), false);
        if (light) own_lights.push_back(group->parts.lights.size() - 1);
    }
    limit_depth(reader, reader.last_place(), group->parts.set);
    bool global_lights = false;
    for (;;) {
        const Span place = reader.peek().span;
        if (const std::optional<Transform> t = accept_transform(reader))
            move_set(reader, place, *group, *t);
        else if (reader.accept(Word::global_lights))
            global_lights = reader.parse_bool_or(true);
        else
            break;
    }
    reader.end_block();
    enclose_in_light_group(group->parts, own_lights, global_lights);
    ObjectValue value;
    value.set = std::move(*group);
    value.extent = Extent{};
    return value;
}

}  // namespace rt
