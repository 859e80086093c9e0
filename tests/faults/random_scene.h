// Scenes that nobody has looked at: lamps, a floor and transformed solids with every kind of finish, drawn with a seed.
#pragma once

#include <string>

namespace rt::test {

/// The text of a scene by the rules of the course or of POV-Ray. The same seed gives the same text.
std::string random_scene_text(bool course, unsigned seed);

}  // namespace rt::test
