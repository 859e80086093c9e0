// pigment { }: colours, and patterns over them.
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "scene/pattern.h"

namespace rt {

/// POV-Ray's five channels. Opacity of the surface terms is 1 - filter - transmit.
struct PigmentColor {
    Rgb rgb{0.0};
    double filter = 0.0;
    double transmit = 0.0;
    bool operator==(const PigmentColor&) const = default;
};

struct PatternPigment;

struct Pigment {
    std::variant<PigmentColor, Shared<PatternPigment>> content;
    std::optional<Transform> transform;  ///< what moved a colour: nothing, until a pattern takes its place
    std::optional<PigmentColor> quick_color;
    bool operator==(const Pigment&) const;
};

/// Entries by ascending value; of cells by number; of `average` with their weights as values.
struct ColorMap {
    std::vector<double> values;
    std::vector<PigmentColor> colors;
    bool operator==(const ColorMap&) const = default;
};

struct PigmentMap {
    std::vector<double> values;
    std::vector<Pigment> pigments;
    bool operator==(const PigmentMap&) const;
};

/// A picture's texels in the working space, the top row first.
struct ColorImage {
    int width = 0;
    int height = 0;
    std::vector<std::array<float, 4>> texels;  ///< red, green, blue, transmit
    bool operator==(const ColorImage&) const = default;
};

struct ImageMap {
    Shared<ColorImage> image;
    ImageMapping mapping;
    double filter = 0.0;    ///< `filter all`
    double transmit = 0.0;  ///< `transmit all`
    bool operator==(const ImageMap&) const = default;
};

struct PatternPigment {
    StatedPattern pattern;  ///< of an image map only the place counts
    /// Without one: the kind's own colours.
    std::variant<std::monostate, Shared<ColorMap>, Shared<PigmentMap>, Shared<ImageMap>> map;
    bool operator==(const PatternPigment&) const = default;
};

}  // namespace rt
