// function { pigment { } } and function { pattern { } }.
#pragma once

#include "core/function.h"
#include "syntax/reader.h"

namespace rt {

/// `pigment { }` or `pattern { }` after that word: a function of a point whose value is a colour, or a number.
FunctionValue function_of_source(Reader& reader, Word word);

/// A point moved by `transform`: its coordinates are the first three values.
PigmentFunction moved_point(const Transform& transform);

/// POV-Ray's noise at (x, y, z), by the scene's generator: what `f_noise3d` is.
std::shared_ptr<const Function> noise_function(Reader& reader, const Span& place);

/// The grey of a pigment at (x, y, z), as height fields take it.
std::shared_ptr<const Function> grey_of(const PigmentFunction& pigment);

}  // namespace rt
