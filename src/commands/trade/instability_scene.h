// A scene with its coordinates multiplied by a number near 1: the same picture, but for what hangs by the last bits.
#pragma once

#include "scene/scene.h"

namespace rt {

/// Everything that is a length or a place in the scene times `factor`, about the origin: objects with their patterns and the distances of
/// their interiors, lamps with their areas, cylinders and fading, the camera. Lengths that no scene states stay: the distances of a law of
/// lamps (`--att`, `--range`), POV-Ray's absolute 1e-4, 1e-3 and 1e7, the course's 1e-3.
Scene scaled(Scene scene, double factor);

}  // namespace rt
