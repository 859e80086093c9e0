// What a name can stand for. A new kind of value is a new alternative here, a case in `declare` and one where it is used.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace rt {

/// Result of a numeric expression: a float (size 1), a vector of 2..5 components or a colour (always 5, order r g b filter transmit).
struct Number {
    std::array<double, 5> v{};
    int size = 1;
    bool color = false;
    bool operator==(const Number&) const = default;
};

/// `material { texture interior }`.
struct MaterialValue {
    std::optional<TextureLayers> texture;
    std::optional<TextureLayers> interior_texture;
    std::optional<Shared<Interior>> interior;
    bool operator==(const MaterialValue&) const = default;
};

/// An object that was declared, not yet placed: the texture is unset where the file states none. Without `root` it is one object, or none
/// where it can never be hit; with it, all objects of a set. Indices are those of the lists here.
struct ObjectValue {
    std::vector<Object> objects;
    std::vector<SetNode> sets;
    std::vector<Object> clips;
    std::vector<Light> lights;
    std::optional<SetPart> root;
    std::vector<Object> whole;  ///< one if a set states anything itself, which its parts have if they state none; no shape
    bool operator==(const ObjectValue&) const = default;
};

/// A macro, kept as the place of its body: it is skipped until used.
struct MacroValue {
    std::vector<std::string> parameters;
    Span body;
    bool operator==(const MacroValue&) const = default;
};

using Value = std::variant<Number, std::string, Pigment, Finish, TextureLayers, Shared<Interior>, MaterialValue, ObjectValue, Camera, Light,
                           Transform, MacroValue>;

}  // namespace rt
