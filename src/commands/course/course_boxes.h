// `printbvh`: a tree of boxes over a scene's objects as the course builds one. Rays do not use it: the world has an index of its own.
#pragma once

#include <string>

#include "scene/scene.h"
#include "world/world.h"

namespace rt {

/// The objects sorted by the centres of their boxes along x, y and z in turn and halved until one is left; planes have no box and are
/// listed apart.
std::string printbvh_text(const Scene& scene, const World& world);

}  // namespace rt
