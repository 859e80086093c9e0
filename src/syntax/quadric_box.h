// How far quadrics reach along the axes of space.
#pragma once

#include "core/transform.h"
#include "geometry/quadric.h"

namespace rt {

Quadric moved(const Quadric& q, const Transform& t);
/// What is left of a box in which a quadric lies, if its axes are those of space: along each of them what the others let it reach. All of
/// the box if they are turned, and of those in two sheets, as POV-Ray has it.
Bounds cut_to(Quadric q, const Bounds& box);

}  // namespace rt
