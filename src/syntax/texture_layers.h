// Editing texture values: which layer a block edits, how layers stack, what a transform moves.
#pragma once

#include "syntax/reader.h"

namespace rt {

/// The layers to edit where none were stated yet: a copy of the default texture.
TextureLayers& layers_or_default(Reader& reader, std::optional<TextureLayers>& layers);
/// The top layer for editing. Fails at the next token if it is patterned.
PlainTexture& edit_top(Reader& reader, TextureLayers& layers);
/// The layers for editing; what has to be copied for it counts. The only way to edit them: what was counted before is forgotten.
std::vector<Texture>& edit_all(Reader& reader, TextureLayers& layers);
/// Stacks `upper` on what is there. Fails at `place` if either is patterned.
void stack(Reader& reader, const Span& place, std::optional<TextureLayers>& layers, const TextureLayers& upper);
void transform_layers(Reader& reader, TextureLayers& layers, const Transform& t);
/// What moves their object: surfaces take their own coordinates along.
void move_layers(Reader& reader, TextureLayers& layers, const Transform& t);
/// The same for several textures, of which those that look the same everywhere stay as they are.
void move_layers(Reader& reader, Shared<std::vector<TextureLayers>>& textures, const Transform& t);
/// Moves a texture by what has gathered in `motion`, if there is any: `always`, or where it would look different.
void settle_motion(Reader& reader, std::optional<TextureLayers>& layers, std::optional<Transform>& motion, bool always);
bool is_patterned(const TextureLayers& layers);     ///< a pattern of textures
bool has_any_pattern(const TextureLayers& layers);  ///< does it look different when it is moved?
Pigment default_pigment(Reader& reader);

/// How large a tree of pigments, normals or textures is. A pattern of pigments or normals is a node besides those of its entries, one of
/// textures is none.
struct TreeSize {
    std::size_t nodes = 0;
    std::size_t depth = 0;  ///< patterns inside patterns
};
TreeSize tree_size(const Pigment& pigment);
TreeSize tree_size(const PigmentMap& map);
TreeSize tree_size(const Normal& normal);
TreeSize tree_size(const NormalMap& map);
TreeSize tree_size(const TextureMap& map);
TreeSize tree_size(const std::vector<Texture>& layers);
/// Throws LimitError at `place` if what was put together there is too large.
void limit_size(Reader& reader, const Span& place, const TreeSize& size);

/// Takes `pigment { }`, `finish { }` or `normal { }` and edits the top layer with it; false if none of them comes next.
bool accept_layer_part(Reader& reader, std::optional<TextureLayers>& layers);

}  // namespace rt
