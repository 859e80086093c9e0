// Records of a pixel's rays from files: the course's printrays and pixeltrace texts, and our own JSON.
#pragma once

#include <string>

#include "core/source.h"
#include "grading/told_pixel.h"

namespace rt {

/// The record in a file, JSON if it begins with '{'. Throws OptionError if there is no such file, LimitError beyond 1 GB, and SceneError
/// with line, column and what was expected where it is no record.
ToldPixel read_told_pixel(const std::string& path);

/// The text that `printrays` (rays one below the other) or `pixeltrace` (as a tree) prints. Lines may be missing, but a ray must say its
/// iteration type, its ray, and whether it meets something. In a list, what caused a ray is the last one before it, among its possible
/// parents, whose end is nearest to where it begins. `sources` holds the text as its file 0.
ToldPixel told_pixel_of_text(const Sources& sources);

/// What ray_tree_json() writes; members that no comparison needs may be missing.
ToldPixel told_pixel_of_json(const Sources& sources);

}  // namespace rt
