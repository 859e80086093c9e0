// Directive comments: `//! raytrace: key=value key=value`.
#pragma once

#include "syntax/reader.h"

namespace rt {

/// Takes a directive comment that comes next and adds its choices to `options`; false if none comes next.
/// Fails at the first word that is no key=value or has an unknown key; values are checked by whoever uses them.
bool accept_choices(Reader& reader, std::vector<SceneOption>& options);

}  // namespace rt
