// What POV-Ray knows and this program does not model: named once, then skipped, so that one pass lists everything.
#pragma once

#include "syntax/reader.h"

namespace rt {

bool is_unmodelled_shape(Word w);    ///< union, blob, height_field ...: blocks that stand where an object may
bool is_unmodelled_pattern(Word w);  ///< gradient, bozo, image_map ...: what may begin a pigment besides a colour and checker
bool is_unmodelled_item(Word w);     ///< fog, sky_sphere ...: top-level blocks that are no objects

/// Reports `word` (its token was just taken), then skips its block; features inside are reported too.
void skip_unmodelled_block(Reader& reader, const Token& word);
/// Skips a block without reporting its own word, but reporting what is inside.
void skip_inner_block(Reader& reader);
/// Skips to the '}' that ends the block being read, which stays; features on the way are reported.
void skip_to_block_end(Reader& reader);
/// Takes everything up to the ')' that belongs to a '(' that was taken.
void skip_arguments(Reader& reader);

}  // namespace rt
