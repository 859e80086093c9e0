// POV-Ray's camera without an angle, in any precision.
#pragma once

#include "scene/scene.h"
#include "tests/extremes/number.h"

namespace rt::extremes {

template <typename T>
struct Eye {
    explicit Eye(const Camera& camera) : origin(camera.location), direction(camera.direction), right(camera.right), up(camera.up) {
        if (!camera.look_at) return;
        const Vec<T> z = unit(Vec<T>(*camera.look_at) - origin), x = unit(cross(Vec<T>(camera.sky), z)), y = cross(z, x);
        direction = length(direction) * z, right = length(right) * x, up = length(up) * y;
    }

    /// Through the centre of pixel (i, j), unit.
    Vec<T> towards(int i, int j, int width, int height) const {
        const T u = (T(i) + T(0.5)) / T(width) - T(0.5), v = T(0.5) - (T(j) + T(0.5)) / T(height);
        return unit(direction + u * right + v * up);
    }

    Vec<T> origin, direction, right, up;
};

}  // namespace rt::extremes
