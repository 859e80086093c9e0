// The pixels between those that are known.
#pragma once

#include <cstdint>
#include <span>

#include "film/film.h"

namespace rt {

/// Of a film whose pixels in every `spacing`-th column of every `spacing`-th row are known, and maybe others: makes up the rest from them.
/// `spacing` is a power of two; `known` has a byte for each pixel, row by row, 0 for those that are made up. Halves the spacing again and
/// again; a pixel in the middle of two known or made-up ones is (-a + 9 b + 9 c - d) / 16 of the four nearest on its line, the cubic
/// through them (G. Deslauriers and S. Dubuc, Symmetric iterative interpolation processes, 1989; Catmull-Rom's weights there), and not
/// below 0. What is not finite counts as 0; beyond an edge the last one is repeated.
void fill_between(Film& film, int spacing, std::span<const std::uint8_t> known);

}  // namespace rt
