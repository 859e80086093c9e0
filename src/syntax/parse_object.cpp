// Objects: shapes, object { }, declared objects.
#include "syntax/blocks.h"
#include "syntax/object_draft.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

ObjectValue parse_shape_block(Reader& reader, const ShapeSyntax& shape) {
    auto draft = std::make_unique<Draft>();
    draft->object.span = reader.take().span;
    reader.begin_block(text(shape.word));
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) {
        draft = draft_of(*declared);
    } else {
        ParsedShape parsed = shape.parse(reader);
        draft->exists = parsed.shape.has_value();
        if (parsed.shape) draft->object.shape = std::move(*parsed.shape);
        if (!parsed.textures.empty()) draft->object.shape_textures = std::move(parsed.textures);
        if (draft->exists && keeps_its_extent(draft->object.shape)) draft->extent = extent_of(draft->object.shape, std::nullopt);
    }
    return finish_object(reader, std::move(draft), &shape);
}

}  // namespace

[[gnu::noinline]] Placeable parse_object_block(Reader& reader, std::string_view word, const Vec3& location) {
    const Span place = reader.peek().span;
    reader.begin_block(word);
    std::optional<Placeable> inner = accept_object(reader);
    if (!inner) reader.fail_expected("object");
    if (Light* light = std::get_if<Light>(&*inner)) {
        transform_light(reader, place, *light, Transform::translate(location));
        modify_light(reader, place, *light);
        reader.end_block();
        return std::move(*light);
    }
    std::unique_ptr<Draft> draft = draft_of(std::get<ObjectValue>(std::move(*inner)));
    if (location != Vec3(0.0)) move(reader, place, *draft, Transform::translate(location));
    return finish_object(reader, std::move(draft), nullptr);
}

void modify_light(Reader& reader, const Span& place, Light& light) {
    if (const std::optional<Transform> motion = parse_motion(reader)) transform_light(reader, place, light, *motion);
}

std::optional<Placeable> accept_object(Reader& reader) {
    if (const ObjectValue* declared = reader.accept_declared<ObjectValue>()) return *declared;
    if (const Light* declared = reader.accept_declared<Light>()) return *declared;
    const Token next = reader.peek();
    if (next.kind != Token::Kind::word) return std::nullopt;
    if (const ShapeSyntax* shape = find_shape(next.word)) return parse_shape_block(reader, *shape);
    if (std::optional<ObjectValue> set = accept_set(reader)) return std::move(*set);
    if (reader.accept(Word::object)) return parse_object_block(reader, "object");
    if (reader.accept(Word::light_source)) return parse_light(reader);
    if (reader.accept(Word::light_group)) return parse_light_group(reader);
    if (!is_unmodelled_shape(next.word)) return std::nullopt;
    reader.take();
    skip_unmodelled_block(reader, next);
    return ObjectValue{};
}

}  // namespace rt
