#include "trace/environment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/source.h"

namespace rt {

namespace {

Rgb color_of(const Pixel& p) { return {p.r, p.g, p.b}; }

/// The picture at (x, y) in pixels, whose centres lie at halves, and black where that is no place; `around` joins the left edge to the
/// right one.
Rgb between_pixels(const Film& picture, double x, double y, bool around) {
    if (!std::isfinite(x) || !std::isfinite(y)) return Rgb(0.0);
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double fx = x - 0.5 - left, fy = y - 0.5 - top;
    const auto pixel = [&](int i, int j) {
        const int column = around ? (i + picture.width) % picture.width : std::clamp(i, 0, picture.width - 1);
        return color_of(picture.at(column, std::clamp(j, 0, picture.height - 1)));
    };
    const int i = static_cast<int>(left), j = static_cast<int>(top);
    return (1.0 - fy) * ((1.0 - fx) * pixel(i, j) + fx * pixel(i + 1, j)) + fy * ((1.0 - fx) * pixel(i, j + 1) + fx * pixel(i + 1, j + 1));
}

/// Where a direction leaves the cube: the face, and the tangents to its right and upwards.
struct CubePoint {
    std::size_t face;
    double right, up;
};

CubePoint cube_point(const Vec3& d) {
    const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    if (z >= x && z >= y) return {d.z >= 0.0 ? std::size_t{4} : std::size_t{5}, (d.z >= 0.0 ? d.x : -d.x) / z, d.y / z};
    if (x >= y) return {d.x >= 0.0 ? std::size_t{0} : std::size_t{1}, (d.x >= 0.0 ? -d.z : d.z) / x, d.y / x};
    return {d.y >= 0.0 ? std::size_t{2} : std::size_t{3}, d.x / y, (d.y >= 0.0 ? -d.z : d.z) / y};
}

}  // namespace

Environment Environment::latitude_longitude(Film picture) {
    if (picture.pixels.empty()) throw OptionError("environment: the picture has no pixels");
    Environment result;
    result.faces_[0] = std::move(picture);
    return result;
}

Environment Environment::cube(std::array<Film, 6> faces) {
    for (const Film& face : faces)
        if (face.pixels.empty() || face.width != face.height || face.width != faces[0].width)
            throw OptionError("environment: the six pictures of a cube must be square and of one size");
    Environment result;
    result.cube_ = true;
    result.faces_ = std::move(faces);
    return result;
}

Rgb Environment::at(const Vec3& direction) const {
    if (cube_) {
        const CubePoint p = cube_point(direction);
        const Film& face = faces_[p.face];
        return between_pixels(face, 0.5 * (1.0 + p.right) * face.width, 0.5 * (1.0 - p.up) * face.height, false);
    }
    const Film& picture = faces_[0];
    const double longitude = std::atan2(direction.x, direction.z);
    const double from_top = std::atan2(std::hypot(direction.x, direction.z), direction.y);
    return between_pixels(picture, (0.5 + longitude / (2.0 * pi)) * picture.width, from_top / pi * picture.height, true);
}

}  // namespace rt
