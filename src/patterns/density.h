// density_file: a block of numbers as a pattern.
#pragma once

#include <optional>
#include <string_view>

#include "core/vec.h"
#include "patterns/pattern.h"

namespace rt {

/// The contents of a .df3 file: three sizes of two bytes, then the numbers, x fastest, of one, two or four bytes each; highest byte first.
/// Nothing if the file's length fits none of the three (POV-Ray: "Invalid density file size").
std::optional<ValueGrid> read_df3(std::string_view bytes);

/// The grid stretched over the unit cube, its numbers at the cells' low corners; 0 outside. Cubics may exceed 1 between numbers.
double density(const DensityNumbers& numbers, const Vec3& p);

}  // namespace rt
