// Editing texture values: which layer a block edits, how layers stack, what a transform moves.
#pragma once

#include "syntax/reader.h"

namespace rt {

/// The layers to edit where none were stated yet: a copy of the default texture.
TextureLayers& layers_or_default(Reader& reader, std::optional<TextureLayers>& layers);
/// The top layer for editing. Fails at the next token if it is patterned.
PlainTexture& edit_top(Reader& reader, TextureLayers& layers);
/// Stacks `upper` on what is there. Fails at `place` if either is patterned.
void stack(Reader& reader, const Span& place, std::optional<TextureLayers>& layers, const TextureLayers& upper);
void transform_layers(TextureLayers& layers, const Transform& t);
bool is_patterned(const TextureLayers& layers);     ///< a checker of textures
bool has_any_pattern(const TextureLayers& layers);  ///< does it look different when it is moved?
Pigment default_pigment(Reader& reader);

/// Nodes of a pigment: itself and those of its cells.
std::size_t count_nodes(const Pigment& pigment);
/// Nodes of the pigments of all layers; a checker of textures has those of its cells.
std::size_t count_nodes(const std::vector<Texture>& layers);
/// Throws LimitError at `place` if a texture put together there from parts of so many `nodes` is too large.
void limit_nodes(Reader& reader, const Span& place, std::size_t nodes);

/// Takes `pigment { }`, `finish { }` or `normal { }` and edits the top layer with it; false if none of them comes next.
bool accept_layer_part(Reader& reader, std::optional<TextureLayers>& layers);

}  // namespace rt
