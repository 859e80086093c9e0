// blob { }
#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"
#include "syntax/texture_layers.h"
#include "syntax/texture_numbers.h"

namespace rt {

namespace {

/// A component while it is read.
struct ComponentDraft {
    BlobComponent component;
    std::optional<TextureLayers> texture;
    std::optional<Transform> texture_motion;
};

/// The commas and the word that may come before a strength.
double parse_strength(Reader& reader) {
    reader.accept_comma();
    reader.accept(Word::strength);
    return reader.parse_float();
}

bool accept_texture(Reader& reader, ComponentDraft& draft) {
    const Token next = reader.peek();
    if (!next.is(Word::texture) && !next.is(Word::pigment) && !next.is(Word::normal) && !next.is(Word::finish)) return false;
    settle_motion(reader, draft.texture, draft.texture_motion, true);
    if (reader.accept(Word::texture))
        parse_texture(reader, draft.texture);
    else
        accept_layer_part(reader, draft.texture);
    return true;
}

/// Transforms move one component alone, and what it has of a texture by then.
void parse_component_modifiers(Reader& reader, ComponentDraft& draft) {
    std::optional<Transform> moved;
    for (;;) {
        if (const std::optional<Transform> next = accept_transforms(reader)) {
            append(moved, *next);
            if (draft.texture) append(draft.texture_motion, *next);
        } else if (!accept_texture(reader, draft)) {
            break;
        }
    }
    settle_motion(reader, draft.texture, draft.texture_motion, false);
    if (!moved) return;
    BlobComponent& component = draft.component;
    component.moved = true;
    component.to_own = moved->inverse_linear;
    component.own_offset = moved->inverse_offset;
    component.box = moved->bounds(component.box);
}

void add_component(std::vector<BlobComponent>& components, TextureNumbers& textures, ComponentDraft draft) {
    BlobComponent& component = draft.component;
    component.radius = std::fabs(component.radius);
    if (!(component.radius > 0.0) || component.strength == 0.0) return;
    if (draft.texture) component.texture = textures.number_of(*draft.texture);
    components.push_back(component);
}

Bounds around(const BlobComponent& component) {
    const Vec3 r(std::fabs(component.radius));
    return rounded_outward({glm::min(component.base, component.cap) - r, glm::max(component.base, component.cap) + r});
}

ComponentDraft parse_block(Reader& reader, bool cylinder) {
    ComponentDraft draft;
    BlobComponent& component = draft.component;
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
    parse_component_modifiers(reader, draft);
    reader.end_block();
    return draft;
}

/// The old form: strength, radius, centre.
ComponentDraft parse_old_component(Reader& reader) {
    ComponentDraft draft;
    BlobComponent& component = draft.component;
    component.strength = reader.parse_float();
    reader.accept_comma();
    component.radius = reader.parse_float();
    reader.accept_comma();
    component.base = component.cap = reader.parse_vector();
    component.box = around(component);
    return draft;
}

}  // namespace

ParsedShape parse_blob(Reader& reader) {
    BlobData blob;
    TextureNumbers textures;
    bool any = false;
    for (;;) {
        if (reader.accept(Word::threshold)) {
            blob.threshold = reader.parse_float();
            continue;
        }
        if (reader.accept(Word::sphere))
            add_component(blob.components, textures, parse_block(reader, false));
        else if (reader.accept(Word::cylinder))
            add_component(blob.components, textures, parse_block(reader, true));
        else if (reader.accept(Word::component))
            add_component(blob.components, textures, parse_old_component(reader));
        else
            break;
        any = true;
    }
    if (!any) reader.fail(reader.peek().span, "Need at least one component in a blob.");
    if (blob.components.empty()) return std::nullopt;
    return {Blob{std::move(blob)}, textures.take()};
}

}  // namespace rt
