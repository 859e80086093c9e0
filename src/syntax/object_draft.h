// An object while its modifiers are read.
#pragma once

#include <memory>

#include "syntax/blocks.h"
#include "syntax/parse_shape.h"
#include "syntax/reader.h"

namespace rt {

/// Large: blocks inside each other keep theirs on the heap. Moving a texture that looks the same everywhere would only give every object a
/// texture of its own, so what moves it is gathered and applied when it turns out to matter. What moves the parts of a set is gathered as
/// well.
struct Draft {
    Object object;       ///< a shape, or what is stated of a whole set
    bool exists = true;  ///< false: it can never be hit, only its text has to be read
    std::optional<Transform> texture_motion;
    std::optional<Transform> interior_texture_motion;
    std::optional<Transform> shape_texture_motion;
    std::unique_ptr<SetValue> set;  ///< of a set, or a shape that is clipped; its `whole` is not in use
    std::optional<Transform> set_motion;
    std::optional<Extent> extent;  ///< `ObjectValue::extent`

    bool is_set() const { return set && set->kind != SetValue::Kind::clipped_shape; }
};

std::unique_ptr<Draft> draft_of(ObjectValue value);
/// As a modifier would.
void move(Reader& reader, const Span& place, Draft& draft, const Transform& t);
/// Whether textures of the parts of its shape move with the object: not where they are seen at its surface's own coordinates. Those of a
/// blob do even there, as POV-Ray has it.
bool moves_shape_textures(const Object& object);
/// Reads modifiers and the end of the block; `shape` says which of them the object takes, if its shape is known.
ObjectValue finish_object(Reader& reader, std::unique_ptr<Draft> draft, const ShapeSyntax* shape);
/// Reads the modifiers of something that is no object: what moves it, all others meaning nothing.
std::optional<Transform> parse_motion(Reader& reader);

/// `union`, `merge`, `intersection` or `difference`, whose word is next; empty if none is.
std::optional<ObjectValue> accept_set(Reader& reader);
/// `clipped_by`, `bounded_by`, `cutaway_textures`, `split_union` at the next token; false if none is there.
bool accept_set_modifier(Reader& reader, Draft& draft);
/// As POV-Ray warns of it.
void warn_of_bound(Reader& reader, const Draft& draft);
/// Moves the parts of the set and what clips it, as far as they are read.
void settle_set(Reader& reader, const Span& place, Draft& draft);
/// Adds what an object statement at `place` has read: as it is or, of a difference, inverted.
void add_item(Reader& reader, const Span& place, SetValue& set, Placeable item, bool inverted);
/// Moves all of a set.
void move_set(Reader& reader, const Span& place, SetValue& set, const Transform& t);
/// Throws LimitError at `place` if sets are in sets too often.
void limit_depth(Reader& reader, const Span& place, const ObjectSet& set);

}  // namespace rt
