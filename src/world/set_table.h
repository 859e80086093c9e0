// Set operations, compiled: whether a point of an object's surface is left over.
//
// A surface is where the inside of its set begins or ends. Of an object L in an intersection that is where all other parts contain the
// point just inside L, of one in a merge where none contains the point just outside. "Just" is a step along the normal that is larger than
// the errors of all surfaces and smaller than what anybody states, so that where surfaces coincide the answer hangs by the sides on which
// they are solid, and not by the rounding of either.
#pragma once

#include <cstdint>
#include <vector>

#include "core/ray.h"
#include "scene/set.h"

namespace rt {

/// Both sides of a point of a surface.
struct SurfaceSides {
    Vec3 inside, outside;
};

/// Knows which body contains a point; `What::set` is never asked.
class Bodies {
public:
    virtual bool contains(SetPart::What what, std::uint32_t index, const Vec3& point) const = 0;
    /// Of the inside, which is half of space for a disc.
    virtual Bounds bounds(SetPart::What what, std::uint32_t index) const = 0;

protected:
    ~Bodies() = default;
};

class SetTable {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    SetTable() = default;
    /// Parts and clips are those of the scene's lists, `objects` many objects; `inverse` says of each object whether it is stated so.
    SetTable(const std::vector<SetNode>& sets, const std::vector<bool>& object_inverse, const std::vector<bool>& clip_inverse);

    bool empty() const { return nodes_.empty(); }
    /// The set that the object is part of, or none.
    std::uint32_t node_of(std::uint32_t object) const { return empty() ? none : object_node_[object]; }
    /// Whether everything but the object is meant, all complements above it counted.
    bool is_complement(std::uint32_t object) const { return !empty() && object_complement_[object]; }

    /// Is this point of the object's surface left over?
    bool keeps(std::uint32_t object, const SurfaceSides& point, const Bodies& bodies) const;
    /// Does everything that the object is in contain the point? Itself it is not asked.
    bool surrounds(std::uint32_t object, const Vec3& point, const Bodies& bodies) const;

    /// Finds where each set can have surfaces at all.
    void find_bounds(const Bodies& bodies);
    const Bounds& visible_bounds(std::uint32_t node) const { return nodes_[node].visible; }

private:
    enum class Rule : std::uint8_t { any, merge, all };
    struct Node {
        Rule rule = Rule::any;
        bool complement = false;  ///< only while it is made
        std::uint32_t parent = none;
        std::vector<SetPart> parts, clips;
        Bounds visible = Bounds::everything();
    };

    void adopt(std::uint32_t node, bool flip);
    bool contains(const SetPart& part, const Vec3& point, const Bodies& bodies) const;
    Bounds inside_bounds(const SetPart& part, const Bodies& bodies) const;
    void narrow(std::uint32_t node, const Bounds& above, const Bodies& bodies);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> roots_;
    std::vector<std::uint32_t> object_node_;
    std::vector<bool> object_complement_, clip_inverse_;
};

}  // namespace rt
