// Set operations: how objects of a list belong together. Every part is an object of the list in its own right; what is said here only
// takes away pieces of its surface.
#pragma once

#include <cstdint>
#include <vector>

namespace rt {

enum class SetKind : std::uint8_t {
    together,      ///< union: all surfaces of all parts
    intersection,  ///< what of each part's surface is inside all others; a difference is one with complements
    merge,         ///< what of each part's surface is outside all others
};

/// A part of a set or what clips one. What clips has no surface and stands in a list of its own.
struct SetPart {
    enum class What : std::uint8_t { object, clip, set };
    What what = What::object;
    bool complement = false;  ///< everything but it
    std::uint32_t index = 0;
    bool operator==(const SetPart&) const = default;
};

struct SetNode {
    SetKind kind = SetKind::together;
    std::vector<SetPart> parts;
    std::vector<SetPart> clips;  ///< all surfaces count only inside all of these
    std::uint32_t depth = 1;     ///< of sets in sets
    bool operator==(const SetNode&) const = default;
};

}  // namespace rt
