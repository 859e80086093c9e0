// What a name can stand for. A new kind of value is a new alternative here, a case in `declare` and one where it is used.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/object_probe.h"
#include "syntax/extent.h"
#include "syntax/words.h"

namespace rt {

/// What POV-Ray takes for zero or for equal in expressions, lengths and steps of loops.
inline constexpr double epsilon = 1e-10;

/// Result of a numeric expression: a float (size 1), a vector of 2..5 components or a colour (always 5, order r g b filter transmit).
struct Number {
    std::array<double, 5> v{};
    int size = 1;
    bool color = false;
    bool operator==(const Number&) const = default;
};

inline Number vector_of(const Vec3& p) { return {{p.x, p.y, p.z}, 3, false}; }

/// `material { texture interior }`.
struct MaterialValue {
    std::optional<TextureLayers> texture;
    std::optional<TextureLayers> interior_texture;
    std::optional<Shared<Interior>> interior;
    bool operator==(const MaterialValue&) const = default;
};

/// The parts of a set.
struct Parts {
    std::vector<Object> objects;
    ObjectSet set;
    std::vector<Light> lights;
    std::uint32_t media = 0;         ///< the largest `Object::medium`
    std::uint32_t light_groups = 0;  ///< as in Scene
    bool operator==(const Parts&) const = default;
};

/// A set, or a shape that is clipped.
struct SetValue {
    /// `light`: the union of a light and what shows it.
    enum class Kind : std::uint8_t { clipped_shape, union_, merge, intersection, difference, light };
    Kind kind = Kind::clipped_shape;
    bool split = true;    ///< the parts of a union are tested one by one
    Object whole;         ///< what the parts of a set are given if they lack it; of a clipped shape the shape
    Parts parts;          ///< of a set
    ObjectSet clip;       ///< bodies that clip the whole, one tree after the other
    ObjectSet bound;      ///< bodies of `bounded_by`, likewise
    bool linked = false;  ///< one of the two named the other
    bool operator==(const SetValue&) const = default;
};

/// What answers for an object, made when it is first asked; copies of the object share it.
struct ProbeSlot {
    std::shared_ptr<const ObjectProbe> probe;
    bool solid = true;  ///< no part is a light or a surface without inside
    bool operator==(const ProbeSlot&) const { return true; }
};

/// An object that was declared, not yet placed: the texture is unset where the file states none.
struct ObjectValue {
    std::vector<Object> objects;          ///< a shape; none if it can never be hit
    std::optional<Shared<SetValue>> set;  ///< instead of it
    std::optional<Extent> extent;         ///< of a set, a clipped shape and those that `keeps_its_extent` names
    mutable ProbeSlot asked;
    bool exists() const { return !objects.empty() || set; }
    bool operator==(const ObjectValue&) const = default;
};

/// A macro, kept as the place of its body: it is skipped until used.
struct MacroValue {
    std::vector<std::string> parameters;
    Span body;
    bool operator==(const MacroValue&) const = default;
};

using SlopeMap = std::vector<SlopeEntry>;

struct Variable;
/// Where a value is kept. A macro's parameter is the caller's variable itself.
using VariablePtr = std::shared_ptr<Variable>;

/// One to five dimensions; the last index runs fastest. Elements that were never set are null.
struct ArrayValue {
    std::vector<std::size_t> sizes;
    std::vector<VariablePtr> elements;
    std::string_view kind;  ///< of all elements, as `kind_of` names it; empty until one is set
};

struct Function;
class FunctionSource;
struct Spline;
struct OpenFile;
/// A file that `#fopen` opened.
struct FileValue {
    std::shared_ptr<OpenFile> file;
};

/// function { pigment { } }: a function of a point whose value is a colour.
struct PigmentFunction {
    std::shared_ptr<const FunctionSource> source;
    std::size_t nodes = 0, depth = 0;  ///< of the pigment
};

/// function { } of floats, of a transform or of a pigment; spline { }, which is called like one.
using FunctionValue = std::variant<std::shared_ptr<const Function>, Transform, std::shared_ptr<const Spline>, PigmentFunction>;

/// What can be declared and is not modelled: only its use says so.
struct UnmodelledValue {
    Word word = Word::none;
};

using Value = std::variant<Number, std::string, Pigment, Finish, TextureLayers, Shared<Interior>, MaterialValue, ObjectValue, Camera, Light,
                           Transform, MacroValue, Normal, Shared<ColorMap>, Shared<PigmentMap>, Shared<NormalMap>, Shared<TextureMap>,
                           Shared<SlopeMap>, SkySphere, Fog, Rainbow, ArrayValue, FunctionValue, FileValue, UnmodelledValue>;

struct Variable {
    Value value;
    std::vector<Unmodelled> missing;  ///< what its value would need; reported where it is used
};

inline VariablePtr make_variable(Value value) {
    const auto variable = std::make_shared<Variable>();
    variable->value = std::move(value);
    return variable;
}

/// How messages name kinds of values: "float identifier". An array's elements are all of one kind.
std::string_view kind_of(const Value& value);

/// Gives an array that was copied elements of its own; of other values nothing is shared.
void own_elements(Value& value);
/// How large an array is.
struct ArrayExtent {
    std::size_t elements = 0;  ///< places for one, those of arrays inside it included
    std::size_t depth = 1;     ///< of arrays inside arrays
};

}  // namespace rt
