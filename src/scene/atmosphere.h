// What fills the space around the objects.
#pragma once

#include <optional>
#include <vector>

#include "scene/pigment.h"

namespace rt {

/// Pigments seen at the unit direction of a ray that meets nothing; the last one lies nearest.
struct SkySphere {
    std::vector<Pigment> pigments;
    Rgb emission{1.0};
    bool operator==(const SkySphere&) const = default;
};

struct Fog {
    enum class Type { constant, ground };
    Type type = Type::constant;
    double distance = 0.0;  ///< 0: no fog
    PigmentColor color;     ///< transmit: the least that is seen through it; filter: how far its colour tints what is
    double offset = 0.0;    ///< ground fog: the height up to which it is full
    double altitude = 0.0;  ///< ground fog: the height above `offset` where half of it is left
    Vec3 up{0.0, 1.0, 0.0};
    std::optional<Turbulence> turbulence;
    float turbulence_depth = 0.5F;
    bool operator==(const Fog&) const = default;
};

struct Rainbow {
    Vec3 direction{0.0};  ///< of the light
    Vec3 up{0.0, 1.0, 0.0};
    double angle = 0.0;  ///< degrees; from the axis to the middle of the arc
    double width = 0.0;  ///< degrees
    double distance = 0.0;
    double jitter = 0.0;
    double arc_angle = 180.0;      ///< degrees, to each side of `up`
    double falloff_angle = 180.0;  ///< degrees, to each side of `up`; from there the arc fades
    Shared<ColorMap> colors;
    bool operator==(const Rainbow&) const = default;
};

}  // namespace rt
