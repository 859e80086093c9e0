// Curves through points that a scene declares: spline { }.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace rt {

struct Spline {
    enum class Kind : std::uint8_t { linear, quadratic, cubic, natural };
    struct Point {
        double t = 0.0;
        std::array<double, 5> value{};
    };
    Kind kind = Kind::linear;
    int size = 2;               ///< components of the values, 2 to 5
    std::vector<Point> points;  ///< by rising t, no two of them equal

    /// Puts points that were added in any order into theirs; of several with the same t the last one added stays.
    void arrange();
};

/// The value at `t` of a spline with at least one point, drawn as `kind` says:
/// linear: straight from point to point. Quadratic: in (t_i, t_{i+1}] the parabola through the points i - 1, i and i + 1, in the first
/// interval the one through the first three. Natural: the cubic spline whose second derivative is 0 at both ends. Cubic: between two
/// points the cubic that has the mean of the adjacent slopes at each. Before the first and behind the last point their values; cubic: of
/// the second and of the last but one; of two points alone their mean everywhere, as in POV-Ray.
std::array<double, 5> evaluate(const Spline& spline, double t, Spline::Kind kind);

}  // namespace rt
