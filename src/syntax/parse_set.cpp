// Sets of objects: union, merge, intersection, difference; and what clips an object.
#include <fmt/format.h>

#include <array>
#include <unordered_map>

#include "syntax/blocks.h"
#include "syntax/object_draft.h"
#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"
#include "syntax/set_value.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

using Kind = SetValue::Kind;

/// Sets in sets: whoever asks a body about a point goes down so far.
constexpr std::size_t most_depth = 1000;

constexpr ShapeSyntax set_syntax{};  // takes none of what only some shapes take

std::optional<Kind> set_kind(const Token& token) {
    if (token.kind != Token::Kind::word) return std::nullopt;
    switch (token.word) {
        case Word::union_:
            return Kind::union_;
        case Word::merge:
            return Kind::merge;
        case Word::intersection:
            return Kind::intersection;
        case Word::difference:
            return Kind::difference;
        default:
            return std::nullopt;
    }
}

/// Moves textures that do not look the same everywhere. What shared one before shares one then.
class MovedTextures {
public:
    MovedTextures(Reader& reader, const Transform& t) : reader_(reader), t_(t) {}

    void move(std::optional<TextureLayers>& layers) {
        if (layers && has_any_pattern(*layers)) move(*layers, moved_);
    }
    void move(std::optional<Shared<std::vector<TextureLayers>>>& textures) {
        if (textures) move(*textures, moved_lists_);
    }

private:
    template <typename T>
    using Moved = std::unordered_map<const void*, std::pair<T, T>>;  ///< as it was, which keeps the address, and as it is

    template <typename T>
    void move(T& textures, Moved<T>& moved) {
        const auto [known, is_new] = moved.try_emplace(textures.identity(), textures, textures);
        if (is_new) move_layers(reader_, known->second.second, t_);
        textures = known->second.second;
    }

    Reader& reader_;
    const Transform& t_;
    Moved<TextureLayers> moved_;
    Moved<Shared<std::vector<TextureLayers>>> moved_lists_;
};

void move(Reader& reader, const Span& place, std::optional<Transform>& transform, const Transform& t) {
    append(transform, t);
    require_finite(reader, place, *transform);
}

void move(Reader& reader, const Span& place, ObjectSet& bodies, const Transform& t) {
    for (Solid& solid : bodies.solids) move(reader, place, solid.transform, t);
}

Parts parts_of(Placeable item) {
    if (Light* light = std::get_if<Light>(&item)) {
        Parts parts;
        parts.lights.push_back(std::move(*light));
        return parts;
    }
    return resolved(std::get<ObjectValue>(std::move(item)));
}

bool exists(const Placeable& item) {
    const auto* object = std::get_if<ObjectValue>(&item);
    return !object || object->exists();
}

/// A light has no end.
void extend(SetExtent& extent, const Placeable& item, bool inverted) {
    const auto* object = std::get_if<ObjectValue>(&item);
    if (!object)
        extent.add(Extent{}, inverted);
    else if (object->set)
        extent.add(extent_of(*object), inverted);
    else
        extent.add(object->objects.front().shape, object->objects.front().transform, object->extent,
                   object->objects.front().inverse != inverted);
}

/// Of an intersection nothing is left where a part is missing, of a difference where the first one is.
void parse_parts(Reader& reader, Draft& draft) {
    const Kind kind = draft.set->kind;
    SetExtent extent(kind == Kind::intersection || kind == Kind::difference);
    int count = 0;
    for (;; ++count) {
        const Span place = reader.peek().span;
        std::optional<Placeable> item = accept_object(reader);
        if (!item) break;
        if (count == 0 && kind == Kind::difference && !exists(*item)) draft.exists = false;
        const bool inverted = kind == Kind::difference && count > 0;
        if (exists(*item)) extend(extent, *item, inverted);
        add_item(reader, place, *draft.set, std::move(*item), inverted);
    }
    limit_depth(reader, reader.last_place(), draft.set->parts.set);
    draft.extent = extent.extent();
    if (count < 2) reader.warn(reader.peek().span, "Should have at least 2 objects in csg.");
}

/// The bodies in the braces after `clipped_by` or `bounded_by`, and what moves them all.
ObjectSet parse_bodies(Reader& reader) {
    ObjectSet bodies;
    const Span first = reader.peek().span;
    std::optional<Placeable> item = accept_object(reader);
    if (!item) reader.fail_expected("object");
    for (Span place = first; item; place = reader.peek().span, item = accept_object(reader)) {
        Parts body = exists(*item) ? parts_of(std::move(*item)) : Parts{};
        if (has_texture(body) || has_patch(body))
            reader.fail(reader.peek().span, "Illegal texture or patch in clip, bound or object pattern.");
        reader.count_parts(place, body.objects.size() + body.set.solids.size());
        if (!body.set.nodes.empty()) add_body(bodies, std::move(body));
    }
    if (const std::optional<Transform> t = accept_transforms(reader)) move(reader, first, bodies, *t);
    return bodies;
}

SetValue& set_of(Draft& draft) {
    if (!draft.set) draft.set = std::make_unique<SetValue>();
    return *draft.set;
}

/// In the braces of one the other's name stands for its bodies.
void link_clip_and_bound(Reader& reader, const Span& place, Draft& draft, ObjectSet SetValue::*own, ObjectSet SetValue::*other) {
    if (!draft.set) return;
    SetValue& set = *draft.set;
    if (!(set.*own).nodes.empty())
        reader.fail(place, own == &SetValue::clip ? "Cannot link bounds with previous clips." : "Cannot link clips with previous bounds.");
    set.*own = set.*other;
    set.linked = !(set.*own).nodes.empty();
}

/// `clipped_by { ... }` or `bounded_by { ... }`.
void parse_clip_or_bound(Reader& reader, Draft& draft, ObjectSet SetValue::*own, ObjectSet SetValue::*other) {
    const Token word = reader.take();
    if (draft.set && draft.set->linked)
        reader.fail(word.span, fmt::format("Cannot add {} after linking bounds and clips.", own == &SetValue::clip ? "clips" : "bounds"));
    const std::string_view name = text(word.word);
    settle_set(reader, word.span, draft);
    reader.begin_block(name);
    const Span first = reader.peek().span;
    if (reader.accept(own == &SetValue::clip ? Word::bounded_by : Word::clipped_by)) {
        link_clip_and_bound(reader, first, draft, own, other);
    } else {
        const ObjectSet bodies = parse_bodies(reader);
        if (!bodies.nodes.empty()) add_bodies(set_of(draft).*own, bodies);
    }
    reader.end_block();
}

/// A bound makes one body of a union, whose parts are not tested one by one.
void parse_bound(Reader& reader, Draft& draft) {
    parse_clip_or_bound(reader, draft, &SetValue::bound, &SetValue::clip);
    if (draft.is_set()) draft.set->split = false;
}

}  // namespace

void move_set(Reader& reader, const Span& place, SetValue& set, const Transform& t) {
    MovedTextures textures(reader, t);
    for (Object& object : set.parts.objects) {
        move(reader, place, object.transform, t);
        if (moves_shape_textures(object)) textures.move(object.shape_textures);
        if (object.uv_mapping) continue;  // its surface takes its coordinates along
        textures.move(object.texture);
        textures.move(object.interior_texture);
    }
    for (ObjectSet* bodies : {&set.parts.set, &set.clip, &set.bound}) move(reader, place, *bodies, t);
    for (Light& light : set.parts.lights) transform_light(reader, place, light, t);
}

void limit_depth(Reader& reader, const Span& place, const ObjectSet& set) {
    if (depth(set) <= most_depth) return;
    reader.fail_limit(place, fmt::format("Sets of objects are nested more than {} deep.", most_depth), "");
}

void add_item(Reader& reader, const Span& place, SetValue& set, Placeable item, bool inverted) {
    const bool cuts = set.kind == Kind::intersection || set.kind == Kind::difference;
    if (!exists(item)) return;
    Parts part = parts_of(std::move(item));
    reader.count_parts(place, size_of(part));
    if (cuts && has_patch(part)) reader.warn(reader.peek().span, "Patch objects not allowed in intersection.");
    if (part.set.nodes.empty())
        std::move(part.lights.begin(), part.lights.end(), std::back_inserter(set.parts.lights));
    else
        add_part(set, std::move(part), inverted);
}

Bodies parse_bodies_of_pattern(Reader& reader) {
    reader.begin_block("object");
    const Span place = reader.peek().span;
    std::optional<Placeable> item = accept_object(reader);
    if (!item) reader.fail_expected("object");
    Parts parts = exists(*item) ? parts_of(std::move(*item)) : Parts{};
    reader.count_parts(place, parts.objects.size() + parts.set.solids.size());
    if (const std::optional<Transform> t = accept_transforms(reader)) {
        for (Object& object : parts.objects) move(reader, place, object.transform, *t);
        move(reader, place, parts.set, *t);
    }
    return bodies_of(std::move(parts));
}

void settle_set(Reader& reader, const Span& place, Draft& draft) {
    if (draft.set && draft.set_motion) move_set(reader, place, *draft.set, *draft.set_motion);
    draft.set_motion.reset();
}

void warn_of_bound(Reader& reader, const Draft& draft) {
    if (!draft.set || draft.set->bound.nodes.empty()) return;
    const auto* further = std::get_if<FurtherShape>(&draft.object.shape);
    if (!draft.is_set() && !(further && keeps_bounds(*further))) reader.warn(reader.peek().span, "Unnecessary bounding object removed.");
    if (draft.set->kind == Kind::union_) reader.warn(reader.peek().span, "CSG union unnecessarily bounded.");
}

[[gnu::noinline]] bool accept_set_modifier(Reader& reader, Draft& draft) {
    const Token next = reader.peek();
    const Kind kind = draft.set ? draft.set->kind : Kind::clipped_shape;
    if (next.is(Word::clipped_by)) {
        parse_clip_or_bound(reader, draft, &SetValue::clip, &SetValue::bound);
    } else if (next.is(Word::bounded_by)) {
        parse_bound(reader, draft);
    } else if (next.is(Word::cutaway_textures)) {
        if (kind != Kind::intersection && kind != Kind::difference)
            reader.fail(next.span, "cutaway_textures can only be used with intersection and difference.");
        reader.take();
        draft.set->parts.set.nodes.front().cutaway = true;
    } else if (next.is(Word::split_union)) {
        if (kind != Kind::union_ && kind != Kind::merge) reader.fail(next.span, "split_union found in non-union object.");
        reader.take();
        draft.set->split = reader.parse_bool_or(true);
    } else {
        return false;
    }
    return true;
}

[[gnu::noinline]] std::optional<ObjectValue> accept_set(Reader& reader) {
    const Token next = reader.peek();
    const std::optional<Kind> kind = set_kind(next);
    if (!kind) return std::nullopt;
    reader.take();
    reader.begin_block(text(next.word));
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) return finish_object(reader, draft_of(*declared), &set_syntax);
    auto draft = std::make_unique<Draft>();
    draft->object.span = next.span;
    draft->set = std::make_unique<SetValue>(empty_set(*kind));
    parse_parts(reader, *draft);
    return finish_object(reader, std::move(draft), &set_syntax);
}

}  // namespace rt
