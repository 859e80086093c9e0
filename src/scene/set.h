// Sets of objects: of which surfaces a scene shows only what lies inside or outside of other bodies, or to rays that meet others.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/transform.h"
#include "geometry/shape.h"

namespace rt {

/// A body that is not seen, as `clipped_by` and `bounded_by` state it.
struct Solid {
    Shape shape;
    std::optional<Transform> transform;
    bool inverse = false;
    bool operator==(const Solid&) const = default;
};

/// A body: a shape, or all or any of some bodies. Of a difference the bodies taken away are stated inverted.
struct SetNode {
    enum class Kind : std::uint8_t {
        surface,  ///< the shape of an object, which is seen
        solid,    ///< a body that is not
        all,      ///< inside of all its parts: intersection, difference; a surface of a part counts inside of all the others
        any,      ///< inside of any of its parts: union
        merged,   ///< the same, and a surface of a part counts outside of all the others: merge
        bounded,  ///< its first part; a ray sees of it what there is if it meets each of the others, however they stand around it
    };
    Kind kind = Kind::surface;
    /// An `all` of an object, first, and what it is clipped by: its inverse is the inverse of the object, clipped by the same.
    bool clips = false;
    bool inverse = false;     ///< of a `bounded` one: turned inside out, which its bounds do not feel
    bool cutaway = false;     ///< an `all`: parts without a texture show those of the parts that they cut
    bool taken = false;       ///< taken away by a difference, or in what is: its texture shows on no part that cuts
    bool cuts = false;        ///< a surface that shows at each point those of its object's textures whose parts contain the point
    std::uint32_t index = 0;  ///< of the object, counted from the set's first one, or of the solid
    std::uint32_t size = 1;   ///< nodes from this one to the end of its parts
    /// `Object::medium` of the interior of the set as a whole; 0: a shape that is no set.
    std::uint32_t medium = 0;
    /// Of a surface whose texture shows where its set is cut: its number among the textures of the objects that cut.
    std::uint32_t texture = TextureWeight::of_object;
    bool operator==(const SetNode&) const = default;
};

/// One tree of nodes, each followed by its parts.
struct ObjectSet {
    std::uint32_t first_object = 0;  ///< in the scene, or among a mask's surfaces; its surfaces are the objects from there on, in order
    std::vector<SetNode> nodes;
    std::vector<Solid> solids;
    bool operator==(const ObjectSet&) const = default;
};

/// What a light is projected through: laid out like a scene's objects and sets, and met by rays towards that light alone.
struct Mask {
    std::vector<Solid> surfaces;
    std::vector<ObjectSet> sets;
    bool operator==(const Mask&) const = default;
};

}  // namespace rt
