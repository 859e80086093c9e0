// What POV-Ray knows and this program does not model: named once, then skipped, so that one pass lists everything.
#pragma once

#include "syntax/reader.h"

namespace rt {

bool is_unmodelled_shape(Word w);    ///< julia_fractal ...: blocks that stand where an object may
bool is_unmodelled_pattern(Word w);  ///< pavement, tiling: what may begin a pigment besides what is modelled
bool is_unmodelled_item(Word w);     ///< media: top-level blocks that are no objects

/// Reports `word` (its token was just taken), then skips its block; features inside are reported too.
void skip_unmodelled_block(Reader& reader, const Token& word);
/// Skips a block without reporting its own word, but reporting what is inside.
void skip_inner_block(Reader& reader);
/// Skips to the '}' that ends the block being read, which stays; features on the way are reported.
void skip_to_block_end(Reader& reader);
/// Takes everything up to the ')' that belongs to a '(' that was taken.
void skip_arguments(Reader& reader);

}  // namespace rt
