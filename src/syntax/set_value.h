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

/// What is to be seen of the value, each part with what the whole gives it: texture, interior, flags.
Parts resolved(ObjectValue value);

/// Whether there is something that no body of a clip, a bound or a pattern may have: a texture or a patch.
bool has_texture(const Parts& parts);
/// A light, or a surface without inside; polygons do not count.
bool has_patch(const Parts& parts);
/// Gives parts without a texture that of what they cut, in sets that ask for it. Returns the number of those that cut several textures,
/// which have the first of them.
std::size_t cut_textures(Parts& parts);
/// Sets in sets.
std::size_t depth(const ObjectSet& set);

/// The trees that are left when what needs none is taken out: unions that nothing cuts, single shapes.
std::vector<ObjectSet> separate_sets(const ObjectSet& set);

}  // namespace rt
