// Where a picture that is wrong as a whole has its pixels from. A picture has a width and a height; places are column and row from the top
// left.
#pragma once

#include <algorithm>
#include <array>

namespace rt {

/// The place of the right picture that its mirror image has at (x, y).
template <typename Picture>
std::array<int, 2> mirrored_place(const Picture& picture, int x, int y) {
    return {picture.width - 1 - x, y};
}

/// (x, y), or the place of the border that is nearest to it.
template <typename Picture>
std::array<int, 2> nearest_place(const Picture& picture, int x, int y) {
    return {std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1)};
}

}  // namespace rt
