// function { pigment { } } and function { pattern { } }.
#pragma once

#include "core/function.h"
#include "syntax/reader.h"

namespace rt {

/// `pigment { }` or `pattern { }` after that word: a function of a point whose value is a colour, or a number.
FunctionValue function_of_source(Reader& reader, Word word);

}  // namespace rt
