// blob { }
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// The commas and the word that may come before a strength.
double parse_strength(Reader& reader) {
    reader.accept_comma();
    reader.accept(Word::strength);
    return reader.parse_float();
}

/// Transforms move one component alone.
void parse_component_modifiers(Reader& reader, BlobComponent& component) {
    std::optional<Transform> moved;
    for (;;) {
        if (const std::optional<Transform> next = accept_transforms(reader)) {
            append(moved, *next);
            continue;
        }
        const Token word = reader.peek();
        if (!word.is(Word::texture) && !word.is(Word::pigment) && !word.is(Word::normal) && !word.is(Word::finish)) break;
        reader.take();
        reader.unmodelled(word.span, "texture of a blob component");
        skip_inner_block(reader);
    }
    if (!moved) return;
    component.moved = true;
    component.to_own = moved->inverse_linear;
    component.own_offset = moved->inverse_offset;
    component.box = moved->bounds(component.box);
}

void add_component(std::vector<BlobComponent>& components, BlobComponent component) {
    component.radius = std::fabs(component.radius);
    if (component.radius > 0.0 && component.strength != 0.0) components.push_back(component);
}

Bounds around(const BlobComponent& component) {
    const Vec3 r(std::fabs(component.radius));
    return rounded_outward({glm::min(component.base, component.cap) - r, glm::max(component.base, component.cap) + r});
}

BlobComponent parse_block(Reader& reader, bool cylinder) {
    BlobComponent component;
    reader.begin_block(cylinder ? "cylinder" : "sphere");
    component.base = component.cap = reader.parse_vector();
    if (cylinder) {
        reader.accept_comma();
        component.cap = reader.parse_vector();
        if (length(component.cap - component.base) < 1e-10) reader.fail(reader.peek().span, "Degenerate cylindrical component in blob.");
    }
    reader.accept_comma();
    component.radius = reader.parse_float();
    component.strength = parse_strength(reader);
    component.box = around(component);
    parse_component_modifiers(reader, component);
    reader.end_block();
    return component;
}

/// The old form: strength, radius, centre.
BlobComponent parse_old_component(Reader& reader) {
    BlobComponent component;
    component.strength = reader.parse_float();
    reader.accept_comma();
    component.radius = reader.parse_float();
    reader.accept_comma();
    component.base = component.cap = reader.parse_vector();
    component.box = around(component);
    return component;
}

}  // namespace

ParsedShape parse_blob(Reader& reader) {
    BlobData blob;
    bool any = false;
    for (;;) {
        if (reader.accept(Word::threshold)) {
            blob.threshold = reader.parse_float();
            continue;
        }
        if (reader.accept(Word::sphere))
            add_component(blob.components, parse_block(reader, false));
        else if (reader.accept(Word::cylinder))
            add_component(blob.components, parse_block(reader, true));
        else if (reader.accept(Word::component))
            add_component(blob.components, parse_old_component(reader));
        else
            break;
        any = true;
    }
    if (!any) reader.fail(reader.peek().span, "Need at least one component in a blob.");
    if (blob.components.empty()) return std::nullopt;
    return Blob{std::move(blob)};
}

}  // namespace rt
