// Plane curves of straight, quadratic and cubic pieces, and the areas that closed ones bound.
#pragma once

#include <array>
#include <vector>

#include "geometry/hit_sink.h"

namespace rt {

/// A cubic piece by its Bezier points; straight and quadratic ones are raised to it.
struct CurvePiece {
    std::array<Vec2, 4> points{};

    static CurvePiece line(const Vec2& a, const Vec2& b);
    static CurvePiece quadratic(const Vec2& a, const Vec2& b, const Vec2& c);
    Vec2 at(double u) const;
    /// The derivative; where it vanishes at an end, the direction in which the curve leaves.
    Vec2 tangent(double u) const;
    bool operator==(const CurvePiece&) const = default;
};

/// Parameters in [0, 1] in increasing order.
struct Crossings {
    std::array<double, 5> u{};
    std::size_t count = 0;
};
/// Where a piece crosses the line normal . p = distance. Of two pieces that meet on the line exactly one has that crossing if the curve
/// goes from one side to the other there; both or none if it only touches.
Crossings crossings(const CurvePiece& piece, const Vec2& normal, double distance);

/// How points make curves: as `prism` and `lathe` read them.
enum class SplineKind { linear, quadratic, cubic, bezier };

/// The pieces of POV-Ray's splines through `points`: linear from each to the next; quadratic from the second on, each piece bent by the
/// point before it; cubic (Catmull and Rom's) from the second to the last but one; bezier of four points each. Two pieces that meet share
/// their point to the last bit.
std::vector<CurvePiece> spline_pieces(SplineKind kind, const std::vector<Vec2>& points);

/// Closed loops: each piece begins exactly where another one of the outline ends. Even-odd.
struct Outline {
    std::vector<CurvePiece> pieces;
    Vec2 min{infinity}, max{-infinity};  ///< of the Bezier points, so of the curves as well

    void add(const CurvePiece& piece);
    bool contains(const Vec2& p) const;
    bool operator==(const Outline&) const = default;
};

/// Turns each loop so that the outside is on its right, judged beside the middle of one of its pieces: where that is so for all of them,
/// the normals of what is made of the outline point outwards. Of more loops than anybody draws some are left as they are.
void turn_outwards(Outline& outline);

/// An area moved along an axis across its plane between two heights: what prisms and letters are.
struct Sweep {
    const Outline& outline;
    double low, high;
    bool open = false;              ///< without the two flat ends
    std::uint32_t first_piece = 0;  ///< the number of its first piece
};

/// Coordinates of a ray as a sweep sees it.
struct SweepRay {
    Vec2 origin, direction;  ///< in the plane of the outline
    double height, climb;    ///< along the axis
};

/// Part 0 is the lower end, 1 the upper, 2 + i the wall over the piece of number i, met at its parameter u.
void find_hits(const Sweep& sweep, const SweepRay& ray, HitSink& sink);

}  // namespace rt
