// What moves a point before a pattern sees it: transforms, turbulence and the other warps, as values and as pure functions. What POV-Ray
// keeps in single precision is `float` here.
#pragma once

#include <variant>

#include "core/transform.h"
#include "core/vec.h"

namespace rt {

/// `turbulence V octaves n omega o lambda l`, as keywords of a pattern or inside a warp.
struct Turbulence {
    Vec3 amount{0.0};
    int octaves = 6;  ///< 1 to 10
    float omega = 0.5F;
    float lambda = 2.0F;
    bool operator==(const Turbulence&) const = default;
};

/// `repeat V offset O flip F`: blocks of width V along one axis.
struct RepeatWarp {
    int axis = 0;
    float width = 1.0F;  ///< not 0
    Vec3 offset{0.0};
    Vec3 flip{0.0};
    bool operator==(const RepeatWarp&) const = default;
};

struct BlackHoleWarp {
    Vec3 center{0.0};
    double radius = 1.0;
    double strength = 1.0;
    double falloff = 2.0;
    bool inverse = false;
    Vec3 repeat{0.0};      ///< 0: no repetition on that axis
    Vec3 turbulence{0.0};  ///< acts with `repeat` alone
    bool operator==(const BlackHoleWarp&) const = default;
};

/// Raises centre and repeat of a repeated black hole to what POV-Ray demands, so that no hole leaves its block; true if it changed any.
bool fit_repeat(BlackHoleWarp& hole);

/// Wraps the plane z = 0 (or that of another orientation) around a body.
struct MappingWarp {
    enum class Kind { spherical, cylindrical, toroidal, planar };
    Kind kind = Kind::spherical;
    Vec3 orientation{0.0, 0.0, 1.0};  ///< of planar: the normal
    double distance_exponent = 0.0;   ///< `dist_exp`
    double major_radius = 1.0;        ///< of toroidal
    double distance = 0.0;            ///< of planar
    bool operator==(const MappingWarp&) const = default;
};

/// The unfolded cube.
struct CubicWarp {
    bool operator==(const CubicWarp&) const = default;
};

using Warp = std::variant<Transform, Turbulence, RepeatWarp, BlackHoleWarp, MappingWarp, CubicWarp>;

/// The point that a pattern sees which was written before this step: the transform undone, the warp applied.
Vec3 warped(const Warp& warp, const Vec3& p);

/// Angle of (x, z) from +x towards +z in turns, 0..1; 0 on the axis.
double turn_about_y(const Vec3& p);

}  // namespace rt
