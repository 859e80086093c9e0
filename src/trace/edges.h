// Lines over the picture where what is seen changes: the outlines of objects and the creases of their surfaces. They ask only what rays
// meet around a point of the picture, so they go with every shading and every sampling, and a point has the same answer in any tile.
#pragma once

#include <array>

#include "trace/camera.h"
#include "trace/distances.h"

namespace rt {

/// One worker's: counts its rays.
class EdgeLines {
public:
    /// For a picture of width x height pixels; `options.kind` is not off.
    EdgeLines(const World& world, const EdgeOptions& options, Distances distances, int width, int height);

    /// Whether a line covers the point (in pixels of a picture `scale` times as wide and high): some two opposite points of the circle
    /// around it, as wide as the line, see different objects (or one sees none; all loose triangles are one object), two surfaces of one
    /// object with a step between them that is more than the line is wide (outlines, all of these), or one surface that turns abruptly (a
    /// crease). What only bends or recedes quickly is neither: between two rays a step or crease stays when they are moved together, and a
    /// bend does not.
    bool covers(const Vec2& point, int scale);

    std::uint64_t rays = 0;  ///< cast so far

private:
    /// What one ray sees. Directions of `normal` and `side` are turned against the ray.
    struct Seen {
        Vec2 place{0.0};  ///< in pixels of the picture itself
        Ray ray;
        bool hit = false;
        std::uint32_t object = 0;
        double t = 0.0;
        Vec3 point{0.0}, normal{0.0}, side{0.0};
    };
    Seen seen(const Vec2& place, const Ray& ray, const Hit* hit) const;
    Seen look(const Vec2& place);
    bool line_between(const Seen& a, const Seen& b);
    bool is_step(const Seen& a, const Seen& b, double limit) const;
    bool is_turn(const Seen& a, const Seen& b) const { return dot(a.normal, b.normal) < cos_crease_; }
    template <typename Test>
    bool remains(Seen a, Seen b, bool if_parted, const Test& test);

    const World& world_;
    EdgeOptions options_;
    Interval range_;
    int width_, height_;
    double cos_crease_;
};

}  // namespace rt
