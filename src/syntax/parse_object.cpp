// Objects: shapes, sets of objects, object { }, declared objects.
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/object_draft.h"
#include "syntax/set_value.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

ObjectValue parse_shape_block(Reader& reader, const ShapeSyntax& shape) {
    auto draft = std::make_unique<ObjectDraft>();
    const Span place = reader.take().span;
    reader.begin_block(text(shape.word));
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) {
        draft->value = *declared;
    } else if (ParsedShape parsed = shape.parse(reader)) {
        Object object;
        object.shape = std::move(*parsed);
        object.span = place;
        draft->value.objects.push_back(std::move(object));
    }
    return finish_object(reader, std::move(draft), {.shape = &shape});
}

constexpr std::uint32_t most_nested_sets = 1000;

bool is_set(Word w) { return w == Word::union_ || w == Word::intersection || w == Word::difference || w == Word::merge; }

/// A set in one of its own kind is only more parts, so that loops which add to a set do not nest it.
void join_part(Reader& reader, const Span& place, ObjectValue& value, SetNode& node, const SetPart& part) {
    const bool is_last = part.what == SetPart::What::set && part.index + 1 == value.sets.size() && !part.complement;
    if (is_last && value.sets.back().kind == node.kind && value.sets.back().clips.empty()) {
        const std::vector<SetPart> inner = std::move(value.sets.back().parts);
        value.sets.pop_back();
        node.parts.insert(node.parts.end(), inner.begin(), inner.end());
        return;
    }
    node.parts.push_back(part);
    if (part.what == SetPart::What::set) node.depth = std::max(node.depth, value.sets[part.index].depth + 1);
    if (node.depth > most_nested_sets)
        throw LimitError(
            reader.scene().sources.describe(place, "Parse Error", fmt::format("Sets are nested more than {} deep.", most_nested_sets)));
}

/// The parts between a set's '{' and its modifiers. The first is all there is of a difference, of which the others are taken away.
void parse_parts(Reader& reader, Word set, ObjectValue& value) {
    const bool restricts = set == Word::intersection || set == Word::difference;
    SetNode node;
    node.kind = set == Word::union_ ? SetKind::together : set == Word::merge ? SetKind::merge : SetKind::intersection;
    std::size_t count = 0;
    for (;; ++count) {
        const Span place = reader.peek().span;
        std::optional<Placeable> object = accept_object(reader);
        if (!object) break;
        auto* light = std::get_if<Light>(&*object);
        if (restricts && (light || has_patch(std::get<ObjectValue>(*object))))
            reader.warn(place, "Patch objects not allowed in intersection.");
        if (light) {
            value.lights.push_back(std::move(*light));
        } else if (std::optional<SetPart> part = add_part(value, std::get<ObjectValue>(std::move(*object)))) {
            if (set == Word::difference && count > 0) part->complement = !part->complement;
            join_part(reader, place, value, node, *part);
        }
    }
    if (count < 2) reader.warn(reader.peek().span, "Should have at least 2 objects in csg.");
    value.sets.push_back(std::move(node));
    value.root = SetPart{SetPart::What::set, false, static_cast<std::uint32_t>(value.sets.size() - 1)};
}

/// `union { ... }` and its like. A declared object that comes first is all there is, as POV-Ray has it: only modifiers may follow.
[[gnu::noinline]] ObjectValue parse_set_block(Reader& reader) {
    const Token word = reader.take();
    reader.begin_block(text(word.word));
    auto draft = std::make_unique<ObjectDraft>();
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>())
        draft->value = *declared;
    else
        parse_parts(reader, word.word, draft->value);
    return finish_object(reader, std::move(draft), {.set = word.word});
}

/// `object { ... }` after its word.
[[gnu::noinline]] Placeable parse_object_block(Reader& reader) {
    const Span place = reader.peek().span;
    reader.begin_block("object");
    std::optional<Placeable> inner = accept_object(reader);
    if (!inner) reader.fail_expected("object");
    if (Light* light = std::get_if<Light>(&*inner)) {
        modify_light(reader, place, *light);
        reader.end_block();
        return std::move(*light);
    }
    auto draft = std::make_unique<ObjectDraft>();
    draft->value = std::get<ObjectValue>(std::move(*inner));
    return finish_object(reader, std::move(draft), {});
}

}  // namespace

void modify_light(Reader& reader, const Span& place, Light& light) {
    if (const std::optional<Transform> motion = parse_motion(reader)) transform_light(reader, place, light, *motion);
}

std::optional<Placeable> accept_object(Reader& reader) {
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) return *declared;
    if (const Light* declared = reader.accept_declared<Light>()) return *declared;
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return std::nullopt;
    if (const ShapeSyntax* shape = find_shape(next.word)) return parse_shape_block(reader, *shape);
    if (is_set(next.word)) return parse_set_block(reader);
    if (reader.accept(Word::object)) return parse_object_block(reader);
    if (reader.accept(Word::light_source)) return parse_light(reader);
    if (!is_unmodelled_shape(next.word)) return std::nullopt;
    reader.take();
    skip_unmodelled_block(reader, next);
    return ObjectValue{};
}

}  // namespace rt
