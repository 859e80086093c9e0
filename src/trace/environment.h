// Surroundings as a picture, seen by rays that leave the scene.
#pragma once

#include <array>

#include "core/vec.h"
#include "film/film.h"

namespace rt {

class Environment {
public:
    /// One picture of all directions: columns are longitude, the middle one towards +z and +x to its right; rows are latitude, +y at the
    /// top. At least one pixel.
    static Environment latitude_longitude(Film picture);
    /// Six square pictures of one size, for +x -x +y -y +z -z, each as seen from the middle with +y upwards; +y and -y have +x to the
    /// right. Throws OptionError for pictures that are not square or not of one size.
    static Environment cube(std::array<Film, 6> faces);

    /// Radiance from `direction`, between the four nearest pixels; nothing is filtered further. Black for what is no direction.
    Rgb at(const Vec3& direction) const;

private:
    bool cube_ = false;
    std::array<Film, 6> faces_;
};

}  // namespace rt
