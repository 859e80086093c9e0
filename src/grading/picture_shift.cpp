// Pictures whose every point has moved by the same small way.
#include <fmt/format.h>

#include <optional>

#include "grading/picture_causes.h"

namespace rt {

namespace {

constexpr int farthest = 12;  ///< pixels
constexpr int stride = 4;     ///< of the search, both ways

/// actual(x, y) = expected(x - dx, y - dy)?
Misfit misfit_of(int dx, int dy, int step, const ColorPicture& expected, const ColorPicture& actual) {
    Misfit left;
    for (int y = 0; y < actual.height; y += step)
        for (int x = 0; x < actual.width; x += step) left.add(apart(expected.nearest(x - dx, y - dy), actual.at(x, y)));
    return left;
}

std::string way(double dx, double dy) {
    std::string text;
    if (dx != 0.0) text = fmt::format("{:.2g} to the {}", std::fabs(dx), dx > 0.0 ? "right" : "left");
    if (dy != 0.0) text += fmt::format("{}{:.2g} {}", text.empty() ? "" : " and ", std::fabs(dy), dy > 0.0 ? "down" : "up");
    return text;
}

Finding whole_pixels(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    int best_x = 0, best_y = 0;
    double least = misfit_of(0, 0, stride, expected, actual).squares;
    for (int dy = -farthest; dy <= farthest; ++dy)
        for (int dx = -farthest; dx <= farthest; ++dx) {
            const double squares = misfit_of(dx, dy, stride, expected, actual).squares;
            if (squares < least) least = squares, best_x = dx, best_y = dy;
        }
    const Misfit left = misfit_of(best_x, best_y, 1, expected, actual);
    return {"shifted",
            fmt::format("the picture is the expected one moved by {} pixels: {}", way(best_x, best_y), pixels_left(left, whole, actual)),
            best_x == 0 && best_y == 0 ? 1.0 : share_left(left, whole), 0.02};
}

/// The way (dx, dy) that explains the difference best where the picture is a plane: the least squares of
/// actual - expected = -(dx, dy) . gradient (Lucas and Kanade 1981). Jagged edges average out.
std::optional<std::array<double, 2>> small_way(const ColorPicture& expected, const ColorPicture& actual) {
    double xx = 0.0, xy = 0.0, yy = 0.0, xd = 0.0, yd = 0.0;
    for (int y = 0; y < actual.height; ++y)
        for (int x = 0; x < actual.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                // Gradients of the mean of both pictures: what moves is between them.
                const auto both = [&](int i, int j) { return static_cast<double>(expected.nearest(i, j)[c] + actual.nearest(i, j)[c]); };
                const double gx = 0.25 * (both(x + 1, y) - both(x - 1, y)), gy = 0.25 * (both(x, y + 1) - both(x, y - 1));
                const double d = static_cast<double>(actual.at(x, y)[c] - expected.at(x, y)[c]);
                xx += gx * gx, xy += gx * gy, yy += gy * gy, xd -= gx * d, yd -= gy * d;
            }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-6 * xx * yy)) return std::nullopt;
    return std::array{(yy * xd - xy * yd) / determinant, (xx * yd - xy * xd) / determinant};
}

/// How far each pixel is from what lies between it and its neighbour in the direction (sx, sy), each -1, 0 or 1: what it can have
/// become by a move of less than a pixel, whether edges are smooth or jagged.
Misfit misfit_between(int sx, int sy, const ColorPicture& expected, const ColorPicture& actual) {
    Misfit left;
    for (int y = 0; y < actual.height; ++y)
        for (int x = 0; x < actual.width; ++x) {
            const Color* near[] = {&expected.at(x, y), &expected.nearest(x - sx, y), &expected.nearest(x, y - sy),
                                   &expected.nearest(x - sx, y - sy)};
            float beyond = 0.0f;
            for (std::size_t c = 0; c < 3; ++c) {
                const auto [low, high] = std::minmax({(*near[0])[c], (*near[1])[c], (*near[2])[c], (*near[3])[c]});
                const float v = actual.at(x, y)[c];
                beyond = std::max({beyond, low - v, v - high});
            }
            left.add(beyond);
        }
    return left;
}

std::optional<Finding> part_of_a_pixel(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    const std::optional<std::array<double, 2>> found = small_way(expected, actual);
    if (!found) return std::nullopt;
    const auto step = [](double d) { return std::fabs(d) < 0.2 ? 0 : d > 0.0 ? 1 : -1; };
    const auto [dx, dy] = *found;
    const int sx = step(dx), sy = step(dy);
    if ((sx == 0 && sy == 0) || std::fabs(dx) > 0.8 || std::fabs(dy) > 0.8) return std::nullopt;
    const Misfit left = misfit_between(sx, sy, expected, actual), other = misfit_between(-sx, -sy, expected, actual);
    // A move has a direction; what fits the opposite one nearly as well is none.
    const double opposite = share_left(other, whole);
    if (!(opposite > 2.0 * share_left(left, whole) + 0.1)) return std::nullopt;
    return Finding{
        "half-pixel shift",
        fmt::format("the picture is the expected one moved by about {} pixels: {:.0f} pixels are not between their neighbours on "
                    "that side, {:.0f} as it is differ",
                    way(sx == 0 ? 0.0 : dx, sy == 0 ? 0.0 : dy), left.differing, whole.differing),
        share_left(left, whole), 0.05};
}

}  // namespace

std::vector<Finding> shift_findings(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    std::vector<Finding> findings{whole_pixels(expected, actual, whole)};
    if (std::optional<Finding> part = part_of_a_pixel(expected, actual, whole)) findings.push_back(std::move(*part));
    return findings;
}

}  // namespace rt
