// Where a picture lies in pattern space, and which of its texels a point sees: for image_map, image_pattern and bump_map alike.
#pragma once

#include <array>
#include <optional>

#include "core/vec.h"

namespace rt {

/// How a picture is laid around a point.
struct ImageMapping {
    int type = 0;         ///< 0 plane, 1 sphere, 2 cylinder, 5 torus of major radius 1
    int interpolate = 0;  ///< 0 none, 2 bilinear, 3 bicubic, 4 normalised distance
    bool once = false;    ///< the picture does not repeat
    Vec2 offset{0.0};     ///< in pictures
    Vec2 repeat{1.0};
    bool operator==(const ImageMapping&) const = default;
};

/// The texels that take part in a value, with weights whose sum is 1, some of them negative for bicubic: a sum below 0 counts as 0. Rows
/// count from the top.
struct ImageTaps {
    struct Tap {
        int x;
        int y;
        double weight;
    };
    int count = 0;
    std::array<Tap, 16> tap;
    const Tap* begin() const { return tap.data(); }
    const Tap* end() const { return tap.data() + count; }
};

/// The place on a picture of `width` x `height` texels, x from the left and y from the top; nothing beside a picture that lies there once.
std::optional<Vec2> image_place(const ImageMapping& mapping, int width, int height, const Vec3& p);
/// The texels around a place.
ImageTaps image_taps(const ImageMapping& mapping, int width, int height, const Vec2& place);

}  // namespace rt
