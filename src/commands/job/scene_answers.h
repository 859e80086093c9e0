// What the parser asks of the other rooms: pictures, objects that answer, functions of patterns.
#pragma once

#include "syntax/parser.h"

namespace rt {

/// Gives the options all of it.
void give_answers(ParseOptions& options);

}  // namespace rt
