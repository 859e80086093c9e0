// Scenes in the course's dialect by chance: as many as a test wants, that nobody has looked at.
#pragma once

#include <string>

namespace rt::test {

/// The same text for the same seed: some shapes under one to three lamps, some of them moved, mirrors, or transparent.
std::string random_scene(unsigned seed);

}  // namespace rt::test
