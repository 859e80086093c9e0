// What sets of objects are made of.
#pragma once

#include "syntax/value.h"

namespace rt {

/// A set without parts yet.
SetValue empty_set(SetValue::Kind kind);
/// Adds a part: as it is or, of a difference, inverted.
void add_part(SetValue& set, Parts part, bool inverted);
/// Adds a body of which only the inside matters.
void add_body(ObjectSet& bodies, Parts body);
void add_bodies(ObjectSet& bodies, const ObjectSet& further);
/// Turns a set inside out; what it is clipped by stays.
void invert(SetValue& set);

/// Moves the parts' objects and lights on to groups behind `before` others.
void shift_light_groups(Parts& parts, std::uint32_t before);
/// Makes a light group of the parts, of which the lights of these numbers are its own: those in unions shine on the whole scene, as POV-Ray
/// has it.
void enclose_in_light_group(Parts& parts, const std::vector<std::size_t>& own_lights, bool global_lights);

/// What is to be seen of the value, each part with what the whole gives it: texture, interior, flags.
Parts resolved(ObjectValue value);

/// POV-Ray's box of an object that is there.
Extent extent_of(const ObjectValue& value);
/// What answers whether a point is inside, or where a ray meets it, needs of an object.
Bodies bodies_of(Parts parts);

/// Whether there is something that no body of a clip, a bound or a pattern may have: a texture or a patch.
bool has_texture(const Parts& parts);
/// A light, or a surface without inside; polygons do not count.
bool has_patch(const Parts& parts);
/// Gives parts without a texture those of what they cut, in sets that ask for it. Parts that have none then, which may be cut as well, are
/// to have `other`.
void cut_textures(Parts& parts, const TextureLayers& other);
/// How many bodies there are in it, lights and what they are projected through included.
std::size_t size_of(const Parts& parts);
Mask mask_of(Parts parts);
/// Sets in sets.
std::size_t depth(const ObjectSet& set);

/// The trees that are left when what needs none is taken out: unions that nothing cuts, single shapes.
std::vector<ObjectSet> separate_sets(const ObjectSet& set);

}  // namespace rt
