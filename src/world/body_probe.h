// Bodies -> what can be asked of them.
#pragma once

#include "scene/object_probe.h"

namespace rt {

/// What answers for the bodies, with the tests that rays of a picture meet. Throws LimitError where they are too many.
std::shared_ptr<const ObjectProbe> make_body_probe(const Bodies& bodies);

}  // namespace rt
