#include "syntax/object_draft.h"

#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/set_value.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

void settle(Reader& reader, Draft& draft, bool always) {
    settle_motion(reader, draft.object.texture, draft.texture_motion, always);
    settle_motion(reader, draft.object.interior_texture, draft.interior_texture_motion, always);
}

// What follows is asked for in turn, each with a frame of its own: blocks stand inside blocks, and what one of these needs for its values
// would be on the stack of each.

[[gnu::noinline]] bool accept_material(Reader& reader, Draft& draft) {
    const Token next = reader.peek();
    if (!next.is(Word::texture) && !next.is(Word::interior_texture) && !next.is(Word::material) && !next.is(Word::pigment) &&
        !next.is(Word::finish) && !next.is(Word::normal))
        return false;
    settle(reader, draft, true);
    Object& object = draft.object;
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

[[gnu::noinline]] bool accept_flag(Reader& reader, Draft& draft) {
    Object& object = draft.object;
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
        if (draft.is_set()) invert(*draft.set);
    } else if (reader.accept(Word::no_radiosity)) {
        reader.parse_bool_or(true);  // says nothing without radiosity, which is reported where it is asked for
    } else {
        return false;
    }
    return true;
}

[[gnu::noinline]] bool accept_other(Reader& reader, Draft& draft, const ShapeSyntax* shape) {
    const Token next = reader.peek();
    if (next.is(Word::photons) || next.is(Word::radiosity)) {
        reader.take();  // settings of what is reported where it is asked for
        reader.skip_block();
    } else if (next.is(Word::uv_mapping)) {
        if (draft.object.texture) reader.fail(next.span, "uv_mapping must be specified before texture.");
        reader.take();
        draft.object.uv_mapping = reader.parse_bool_or(true);
    } else if (next.is(Word::sturm) || next.is(Word::hierarchy)) {
        const bool known = !shape || (next.is(Word::sturm) ? shape->takes_sturm : shape->takes_hierarchy);
        if (!known) reader.fail(next.span, fmt::format("Keyword '{}' cannot be used with this object.", text(next.word)));
        reader.take();
        reader.parse_bool_or(true);
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
        } else if (!accept_material(reader, draft) && !accept_flag(reader, draft) && !accept_set_modifier(reader, draft) &&
                   !accept_other(reader, draft, shape)) {
            break;
        }
    }
    settle(reader, draft, false);
    if (draft.shape_texture_motion) move_layers(reader, *draft.object.shape_textures, *draft.shape_texture_motion);
    settle_set(reader, reader.peek().span, draft);
    warn_of_bound(reader, draft);
    if (draft.object.interior_texture && !draft.object.texture && reader.at_block_end())
        reader.fail(reader.peek().span, "Interior texture requires an exterior texture.");
}

/// With what clips and bounds it: the smaller box counts.
std::optional<Extent> cut_extent(const Draft& draft) {
    const SetValue& set = *draft.set;
    std::optional<Extent> kept = draft.extent;
    const Object& object = draft.object;
    const auto cut = [&](const ObjectSet& bodies, bool clips) {
        if (bodies.nodes.empty()) return;
        const Extent own = kept ? *kept : extent_of(object.shape, object.transform);
        const Bounds box = box_around(bodies);
        const bool open = clips && !draft.is_set() && !own.is_finite();
        const Extent less = smaller(own, open ? clipped_extent(object.shape, object.transform, box) : extent_around(box));
        if (less != own) kept = less;
    };
    cut(set.clip, true);
    cut(set.bound, false);
    return kept;
}

}  // namespace

void move(Reader& reader, const Span& place, Draft& draft, const Transform& t) {
    if (!draft.is_set()) {
        append(draft.object.transform, t);
        require_finite(reader, place, *draft.object.transform);
    }
    if (draft.set) {
        append(draft.set_motion, t);
        require_finite(reader, place, *draft.set_motion);
    }
    if (draft.extent) draft.extent = moved(*draft.extent, t);
    if (draft.object.shape_textures && moves_shape_textures(draft.object)) append(draft.shape_texture_motion, t);
    if (draft.object.uv_mapping) return;  // its surface takes its coordinates along
    if (draft.object.texture) append(draft.texture_motion, t);
    if (draft.object.interior_texture) append(draft.interior_texture_motion, t);
}

bool moves_shape_textures(const Object& object) {
    const auto* further = std::get_if<FurtherShape>(&object.shape);
    return !object.uv_mapping || (further && std::holds_alternative<Blob>(*further));
}

ObjectValue finish_object(Reader& reader, std::unique_ptr<Draft> draft, const ShapeSyntax* shape) {
    parse_modifiers(reader, *draft, shape);
    reader.end_block();
    ObjectValue value;
    if (!draft->exists) return value;
    value.extent = draft->set ? cut_extent(*draft) : draft->extent;
    if (draft->set) {
        draft->set->whole = std::move(draft->object);
        value.set = std::move(*draft->set);
    } else {
        value.objects.push_back(std::move(draft->object));
    }
    return value;
}

std::unique_ptr<Draft> draft_of(ObjectValue value) {
    auto draft = std::make_unique<Draft>();
    draft->exists = value.exists();
    draft->extent = value.extent;
    if (value.set) {
        draft->set = std::make_unique<SetValue>(std::move(value.set->edit()));
        draft->object = std::move(draft->set->whole);
    } else if (draft->exists) {
        draft->object = std::move(value.objects.front());
    }
    return draft;
}

std::optional<Transform> parse_motion(Reader& reader) {
    const auto unused = std::make_unique<Draft>();
    parse_modifiers(reader, *unused, nullptr);
    return unused->object.transform;
}

}  // namespace rt
