// An object between its parameters and its '}': its modifiers.
#pragma once

#include <memory>

#include "syntax/parse_shape.h"
#include "syntax/reader.h"

namespace rt {

/// Which object it is whose modifiers are read: a shape's, a set's, or neither where `object { }` names it.
struct ObjectSyntax {
    const ShapeSyntax* shape = nullptr;
    Word set = Word::none;
};

/// A single object is `value.objects.front()`; what a set states of itself is `value.whole`. Large: blocks inside each other keep theirs on
/// the heap. Moving a texture that looks the same
/// everywhere would only give every object a texture of its own, so what moves it is gathered and applied when it turns out to matter.
struct ObjectDraft {
    ObjectValue value;
    std::vector<Object> nothing;  ///< one takes the modifiers of what can never be hit
    std::optional<Transform> motion;
    std::optional<Transform> texture_motion;
    std::optional<Transform> interior_texture_motion;

    Object& object() {
        std::vector<Object>& list = value.root ? value.whole : value.objects.empty() ? nothing : value.objects;
        if (list.empty()) list.emplace_back();
        return list.front();
    }
};

/// Reads every modifier up to the '}' and that, and applies them.
ObjectValue finish_object(Reader& reader, std::unique_ptr<ObjectDraft> draft, const ObjectSyntax& syntax);
/// Reads the modifiers of something that is no object: what moves it, all others meaning nothing.
std::optional<Transform> parse_motion(Reader& reader);

}  // namespace rt
