// Objects: shapes with their modifiers, object { }, declared objects.
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// An object while its modifiers are read. Moving a texture that looks the same everywhere would only give every object a texture of its
/// own, so what moves it is gathered and applied when it turns out to matter.
struct Draft {
    Object object;
    bool exists = true;  ///< false: it can never be hit, only its text has to be read
    std::optional<Transform> texture_motion;
    std::optional<Transform> interior_texture_motion;
};

void settle(Reader& reader, std::optional<TextureLayers>& layers, std::optional<Transform>& motion, bool always) {
    if (layers && motion && (always || has_any_pattern(*layers))) transform_layers(reader, *layers, *motion);
    motion.reset();
}

void settle(Reader& reader, Draft& draft, bool always) {
    settle(reader, draft.object.texture, draft.texture_motion, always);
    settle(reader, draft.object.interior_texture, draft.interior_texture_motion, always);
}

void move(Reader& reader, const Span& place, Draft& draft, const Transform& t) {
    append(draft.object.transform, t);
    require_finite(reader, place, *draft.object.transform);
    if (draft.object.texture) append(draft.texture_motion, t);
    if (draft.object.interior_texture) append(draft.interior_texture_motion, t);
}

bool accept_material(Reader& reader, Draft& draft) {
    Object& object = draft.object;
    const Token next = reader.peek();
    if (!next.is(Word::texture) && !next.is(Word::interior_texture) && !next.is(Word::material) && !next.is(Word::pigment) &&
        !next.is(Word::finish) && !next.is(Word::normal))
        return false;
    settle(reader, draft, true);
    if (accept_layer_part(reader, object.texture)) return true;
    reader.take();
    if (next.is(Word::texture)) {
        parse_texture(reader, object.texture);
    } else if (next.is(Word::interior_texture)) {
        parse_texture(reader, object.interior_texture);
    } else {
        MaterialValue material =
            parse_material(reader, {std::move(object.texture), std::move(object.interior_texture), std::move(object.interior)});
        object.texture = std::move(material.texture);
        object.interior_texture = std::move(material.interior_texture);
        object.interior = std::move(material.interior);
    }
    return true;
}

bool accept_flag(Reader& reader, Object& object) {
    if (reader.accept(Word::no_shadow)) {
        object.no_shadow = true;
    } else if (reader.accept(Word::no_image)) {
        object.no_image = reader.parse_bool_or(true);
    } else if (reader.accept(Word::no_reflection)) {
        object.no_reflection = reader.parse_bool_or(true);
    } else if (reader.accept(Word::double_illuminate)) {
        object.double_illuminate = reader.parse_bool_or(true);
    } else if (reader.accept(Word::hollow)) {
        object.hollow = reader.parse_bool_or(true);
    } else if (reader.accept(Word::inverse)) {
        object.inverse = !object.inverse;
    } else if (reader.accept(Word::no_radiosity)) {
        reader.parse_bool_or(true);  // says nothing without radiosity, which is reported where it is asked for
    } else {
        return false;
    }
    return true;
}

bool accept_other(Reader& reader, const ShapeSyntax* shape) {
    const Token next = reader.peek();
    if (next.is(Word::clipped_by)) {
        reader.take();
        skip_unmodelled_block(reader, next);
    } else if (next.is(Word::bounded_by) || next.is(Word::photons) || next.is(Word::radiosity)) {
        reader.take();  // a hint for speed; settings of what is reported where it is asked for
        reader.skip_block();
    } else if (next.is(Word::uv_mapping)) {
        reader.take();
        if (reader.parse_bool_or(true)) reader.unmodelled(next.span, "uv_mapping");
    } else if (next.is(Word::sturm) || next.is(Word::hierarchy)) {
        const bool known = !shape || (next.is(Word::sturm) ? shape->takes_sturm : shape->takes_hierarchy);
        if (!known) reader.fail(next.span, fmt::format("Keyword '{}' cannot be used with this object.", text(next.word)));
        reader.take();
        reader.parse_bool_or(true);
    } else if (next.is(Word::cutaway_textures)) {
        reader.fail(next.span, "cutaway_textures can only be used with intersection and difference.");
    } else if (next.is(Word::split_union)) {
        reader.fail(next.span, "split_union found in non-union object.");
    } else if (next.is(Word::light_source)) {
        reader.fail(next.span, "Light source must be defined using new syntax.");
    } else if (at_color(reader)) {
        parse_color(reader);
        reader.warn(reader.peek().span, "Quick color belongs in texture. Color ignored.");
    } else {
        return false;
    }
    return true;
}

void parse_modifiers(Reader& reader, Draft& draft, const ShapeSyntax* shape) {
    for (;;) {
        const Span place = reader.peek().span;
        if (const std::optional<Transform> t = accept_transform(reader)) {
            move(reader, place, draft, *t);
        } else if (reader.accept(Word::interior)) {
            draft.object.interior = parse_interior(reader, draft.object.interior.value_or(Shared<Interior>()));
        } else if (!accept_material(reader, draft) && !accept_flag(reader, draft.object) && !accept_other(reader, shape)) {
            break;
        }
    }
    settle(reader, draft, false);
    if (draft.object.interior_texture && !draft.object.texture && reader.at_block_end())
        reader.fail(reader.peek().span, "Interior texture requires an exterior texture.");
}

ObjectValue finish_object(Reader& reader, Draft draft, const ShapeSyntax* shape) {
    parse_modifiers(reader, draft, shape);
    reader.end_block();
    ObjectValue value;
    if (draft.exists) value.objects.push_back(std::move(draft.object));
    return value;
}

Draft draft_of(ObjectValue value) {
    Draft draft;
    draft.exists = !value.objects.empty();
    if (draft.exists) draft.object = std::move(value.objects.front());
    return draft;
}

ObjectValue parse_shape_block(Reader& reader, const ShapeSyntax& shape) {
    Draft draft;
    draft.object.span = reader.take().span;
    reader.begin_block(text(shape.word));
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) {
        draft = draft_of(*declared);
    } else {
        ParsedShape parsed = shape.parse(reader);
        draft.exists = parsed.has_value();
        if (parsed) draft.object.shape = std::move(*parsed);
    }
    return finish_object(reader, std::move(draft), &shape);
}

/// `object { ... }` after its word.
Placeable parse_object_block(Reader& reader) {
    const Span place = reader.peek().span;
    reader.begin_block("object");
    std::optional<Placeable> inner = accept_object(reader);
    if (!inner) reader.fail_expected("object");
    if (Light* light = std::get_if<Light>(&*inner)) {
        modify_light(reader, place, *light);
        reader.end_block();
        return std::move(*light);
    }
    return finish_object(reader, draft_of(std::get<ObjectValue>(std::move(*inner))), nullptr);
}

}  // namespace

void modify_light(Reader& reader, const Span& place, Light& light) {
    Draft unused;
    parse_modifiers(reader, unused, nullptr);
    if (unused.object.transform) transform_light(reader, place, light, *unused.object.transform);
}

std::optional<Placeable> accept_object(Reader& reader) {
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) return *declared;
    if (const Light* declared = reader.accept_declared<Light>()) return *declared;
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return std::nullopt;
    if (const ShapeSyntax* shape = find_shape(next.word)) return parse_shape_block(reader, *shape);
    if (reader.accept(Word::object)) return parse_object_block(reader);
    if (reader.accept(Word::light_source)) return parse_light(reader);
    if (!is_unmodelled_shape(next.word)) return std::nullopt;
    reader.take();
    skip_unmodelled_block(reader, next);
    return ObjectValue{};
}

}  // namespace rt
