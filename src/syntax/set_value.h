// Putting object values together: parts into sets, what a whole hands down to its parts.
#pragma once

#include "syntax/reader.h"

namespace rt {

/// Moves everything in `part` into the lists of `whole`, its own texture and flags handed down before. Empty if there is nothing in it.
std::optional<SetPart> add_part(ObjectValue& whole, ObjectValue part);
/// Takes it as something that clips: its objects have no surface any more. Empty if there is nothing in it.
std::optional<SetPart> add_clip(ObjectValue& whole, ObjectValue clip);

/// Makes its indices those of lists that have so many entries before its own.
void renumber(ObjectValue& value, std::size_t objects, std::size_t sets, std::size_t clips);
/// What the value is as one part; of a set without parts, a set without parts.
SetPart root_of(const ObjectValue& value);
/// Moves all objects, clips and lights, with the textures that the objects state themselves.
void transform_parts(Reader& reader, const Span& place, ObjectValue& value, const Transform& t);
/// Gives every part what `value.whole` states and the part lacks, and the flags.
void hand_down(ObjectValue& value);
/// Has any part, or the whole, a texture of its own?
bool states_texture(const ObjectValue& value);
/// Shapes without an inside: triangles and meshes.
bool has_patch(const ObjectValue& value);
/// Whether the sets take away any surface: not so for unions alone.
bool restricts(const ObjectValue& value);

}  // namespace rt
