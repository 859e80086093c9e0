#include "syntax/object_draft.h"

#include <fmt/format.h>

#include <utility>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/set_value.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

void settle(Reader& reader, std::optional<TextureLayers>& layers, std::optional<Transform>& motion, bool always) {
    if (layers && motion && (always || has_any_pattern(*layers))) move_layers(reader, *layers, *motion);
    motion.reset();
}

void settle(Reader& reader, ObjectDraft& draft, bool always) {
    settle(reader, draft.object().texture, draft.texture_motion, always);
    settle(reader, draft.object().interior_texture, draft.interior_texture_motion, always);
}

/// Moves what the object is made of by what was gathered: before anything is added that only later transforms move.
void move_parts(Reader& reader, const Span& place, ObjectDraft& draft) {
    if (draft.motion && draft.value.root) transform_parts(reader, place, draft.value, *draft.motion);
    draft.motion.reset();
}

void move(Reader& reader, const Span& place, ObjectDraft& draft, const Transform& t) {
    Object& object = draft.object();
    append(draft.motion, t);
    if (draft.value.root) {
        require_finite(reader, place, *draft.motion);
    } else {
        append(object.transform, t);
        require_finite(reader, place, *object.transform);
    }
    if (object.uv_mapping) return;  // its surface takes its coordinates along
    if (object.texture) append(draft.texture_motion, t);
    if (object.interior_texture) append(draft.interior_texture_motion, t);
}

// What follows is asked for in turn, each with a frame of its own: blocks stand inside blocks, and what one of these needs for its values
// would be on the stack of each.

[[gnu::noinline]] bool accept_material(Reader& reader, ObjectDraft& draft) {
    const Token next = reader.peek();
    if (!next.is(Word::texture) && !next.is(Word::interior_texture) && !next.is(Word::material) && !next.is(Word::pigment) &&
        !next.is(Word::finish) && !next.is(Word::normal))
        return false;
    settle(reader, draft, true);
    Object& object = draft.object();
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

/// Of a set it is all of it that is turned inside out.
void invert(ObjectDraft& draft) {
    if (draft.value.root)
        draft.value.root->complement = !draft.value.root->complement;
    else
        draft.object().inverse = !draft.object().inverse;
}

[[gnu::noinline]] bool accept_flag(Reader& reader, ObjectDraft& draft) {
    Object& object = draft.object();
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
        invert(draft);
    } else if (reader.accept(Word::no_radiosity)) {
        reader.parse_bool_or(true);  // says nothing without radiosity, which is reported where it is asked for
    } else {
        return false;
    }
    return true;
}

/// A set of one object states what the object did.
void state_as_whole(ObjectValue& value) {
    Object& object = value.objects.front();
    Object& whole = value.whole.emplace_back();
    whole.texture = std::exchange(object.texture, std::nullopt);
    whole.interior_texture = std::exchange(object.interior_texture, std::nullopt);
    whole.interior = std::exchange(object.interior, std::nullopt);
}

/// Makes a set of a single object, so that something can clip it.
SetNode& node_that_clips(ObjectValue& value) {
    if (!value.root) state_as_whole(value);
    if (!value.root || value.root->what != SetPart::What::set || value.root->complement) {
        value.sets.push_back({SetKind::together, {root_of(value)}, {}});
        value.root = SetPart{SetPart::What::set, false, static_cast<std::uint32_t>(value.sets.size() - 1)};
    }
    return value.sets[value.root->index];
}

/// `clipped_by { ... }` after its word.
[[gnu::noinline]] void parse_clips(Reader& reader, const Span& place, ObjectDraft& draft) {
    reader.begin_block("clipped_by");
    if (reader.peek().is(Word::bounded_by)) {
        reader.unmodelled(place, "clipped_by { bounded_by }");
        reader.take();
        return reader.end_block();
    }
    ObjectValue clips;
    std::vector<SetPart> parts;
    do {
        const Span at = reader.peek().span;
        std::optional<Placeable> object = accept_object(reader);
        if (!object) {
            if (parts.empty()) reader.fail_expected("object");
            break;
        }
        auto* value = std::get_if<ObjectValue>(&*object);
        if (!value || states_texture(*value) || has_patch(*value) || !value->lights.empty())
            reader.fail(at, "Illegal texture or patch in clip, bound or object pattern.");
        if (const std::optional<SetPart> part = add_clip(clips, std::move(*value))) parts.push_back(*part);
    } while (!reader.at_block_end());
    if (const std::optional<Transform> t = accept_transforms(reader)) transform_parts(reader, place, clips, *t);
    reader.end_block();
    if (parts.empty() || (!draft.value.root && draft.value.objects.empty())) return;

    move_parts(reader, place, draft);
    clips.sets.push_back({SetKind::together, {}, std::move(parts)});
    clips.root = SetPart{SetPart::What::set, false, static_cast<std::uint32_t>(clips.sets.size() - 1)};
    add_part(draft.value, std::move(clips));
    const std::vector<SetPart> moved = std::move(draft.value.sets.back().clips);
    draft.value.sets.pop_back();
    SetNode& node = node_that_clips(draft.value);
    node.clips.insert(node.clips.end(), moved.begin(), moved.end());
}

[[gnu::noinline]] bool accept_other(Reader& reader, ObjectDraft& draft, const ObjectSyntax& syntax) {
    const Token next = reader.peek();
    if (reader.accept(Word::clipped_by)) {
        parse_clips(reader, next.span, draft);
    } else if (next.is(Word::bounded_by) || next.is(Word::photons) || next.is(Word::radiosity)) {
        reader.take();  // a hint for speed; settings of what is reported where it is asked for
        reader.skip_block();
    } else if (next.is(Word::uv_mapping)) {
        reader.take();
        draft.object().uv_mapping = reader.parse_bool_or(true);
    } else if (next.is(Word::sturm) || next.is(Word::hierarchy)) {
        const bool takes = syntax.shape && (next.is(Word::sturm) ? syntax.shape->takes_sturm : syntax.shape->takes_hierarchy);
        const bool known = takes || (!syntax.shape && syntax.set == Word::none);
        if (!known) reader.fail(next.span, fmt::format("Keyword '{}' cannot be used with this object.", text(next.word)));
        reader.take();
        reader.parse_bool_or(true);
    } else if (next.is(Word::cutaway_textures)) {
        if (syntax.set != Word::intersection && syntax.set != Word::difference)
            reader.fail(next.span, "cutaway_textures can only be used with intersection and difference.");
        reader.take();
        reader.unmodelled(next.span, "cutaway_textures");
    } else if (next.is(Word::split_union)) {
        if (syntax.set != Word::union_) reader.fail(next.span, "split_union found in non-union object.");
        reader.take();
        reader.parse_bool_or(true);  // about speed alone
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

void parse_modifiers(Reader& reader, ObjectDraft& draft, const ObjectSyntax& syntax) {
    for (;;) {
        const Span place = reader.peek().span;
        if (const std::optional<Transform> t = accept_transform(reader)) {
            move(reader, place, draft, *t);
        } else if (reader.accept(Word::interior)) {
            draft.object().interior = parse_interior(reader, draft.object().interior.value_or(Shared<Interior>()));
        } else if (!accept_material(reader, draft) && !accept_flag(reader, draft) && !accept_other(reader, draft, syntax)) {
            break;
        }
    }
    settle(reader, draft, false);
    if (draft.object().interior_texture && !draft.object().texture && reader.at_block_end())
        reader.fail(reader.peek().span, "Interior texture requires an exterior texture.");
}

}  // namespace

ObjectValue finish_object(Reader& reader, std::unique_ptr<ObjectDraft> draft, const ObjectSyntax& syntax) {
    parse_modifiers(reader, *draft, syntax);
    move_parts(reader, reader.last_place(), *draft);
    reader.end_block();
    return std::move(draft->value);
}

std::optional<Transform> parse_motion(Reader& reader) {
    const auto unused = std::make_unique<ObjectDraft>();
    parse_modifiers(reader, *unused, {});
    return unused->motion;
}

}  // namespace rt
