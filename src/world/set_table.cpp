#include "world/set_table.h"

#include <algorithm>
#include <utility>

namespace rt {

SetTable::SetTable(const std::vector<SetNode>& sets, const std::vector<bool>& object_inverse, const std::vector<bool>& clip_inverse)
    : nodes_(sets.size()), object_node_(object_inverse.size(), none), object_complement_(object_inverse), clip_inverse_(clip_inverse) {
    std::vector<bool> is_part(sets.size());
    for (std::size_t i = 0; i < sets.size(); ++i) {
        Node& node = nodes_[i];
        node.rule = sets[i].kind == SetKind::intersection ? Rule::all : sets[i].kind == SetKind::merge ? Rule::merge : Rule::any;
        node.parts = sets[i].parts;
        node.clips = sets[i].clips;
        for (const std::vector<SetPart>* list : {&node.parts, &node.clips})
            for (const SetPart& part : *list)
                if (part.what == SetPart::What::set) is_part[part.index] = true;
    }
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        if (is_part[i]) continue;
        roots_.push_back(i);
        adopt(i, false);
    }
}

/// De Morgan's laws: everything but an intersection is the union of the complements, and the other way round. Afterwards only objects and
/// clips are complements.
void SetTable::adopt(std::uint32_t index, bool flip) {
    Node& node = nodes_[index];
    if (flip) node.rule = node.rule == Rule::all ? Rule::any : Rule::all;
    const auto adopt_part = [&](SetPart& part, bool turned) {
        part.complement ^= turned;
        if (part.what == SetPart::What::set) {
            nodes_[part.index].parent = index;
            adopt(part.index, std::exchange(part.complement, false));
        } else if (part.what == SetPart::What::clip) {
            part.complement ^= clip_inverse_[part.index];
        } else {
            part.complement ^= object_complement_[part.index];
            object_complement_[part.index] = part.complement;
            object_node_[part.index] = index;
        }
    };
    for (SetPart& part : node.parts) adopt_part(part, flip);
    for (SetPart& clip : node.clips) {
        adopt_part(clip, false);
        if (clip.what == SetPart::What::set) nodes_[clip.index].parent = none;
    }
}

bool SetTable::contains(const SetPart& part, const Vec3& point, const Bodies& bodies) const {
    if (part.what != SetPart::What::set) return bodies.contains(part.what, part.index, point) != part.complement;
    const Node& node = nodes_[part.index];
    const auto holds = [&](const SetPart& inner) { return contains(inner, point, bodies); };
    if (!std::all_of(node.clips.begin(), node.clips.end(), holds)) return false;
    return node.rule == Rule::all ? std::all_of(node.parts.begin(), node.parts.end(), holds)
                                  : std::any_of(node.parts.begin(), node.parts.end(), holds);
}

bool SetTable::keeps(std::uint32_t object, const SurfaceSides& point, const Bodies& bodies) const {
    SetPart own{SetPart::What::object, false, object};
    for (std::uint32_t at = object_node_[object]; at != none; at = nodes_[at].parent) {
        const Node& node = nodes_[at];
        for (const SetPart& clip : node.clips)
            if (!contains(clip, point.inside, bodies)) return false;
        for (const SetPart& part : node.parts) {
            if (node.rule == Rule::any) break;
            if (part.what == own.what && part.index == own.index) continue;
            if (node.rule == Rule::all ? !contains(part, point.inside, bodies) : contains(part, point.outside, bodies)) return false;
        }
        own = {SetPart::What::set, false, at};
    }
    return true;
}

bool SetTable::surrounds(std::uint32_t object, const Vec3& point, const Bodies& bodies) const {
    SetPart own{SetPart::What::object, false, object};
    for (std::uint32_t at = object_node_[object]; at != none; at = nodes_[at].parent) {
        const Node& node = nodes_[at];
        const auto holds = [&](const SetPart& part) {
            return (part.what == own.what && part.index == own.index) || contains(part, point, bodies);
        };
        if (!std::all_of(node.clips.begin(), node.clips.end(), holds)) return false;
        if (node.rule == Rule::all && !std::all_of(node.parts.begin(), node.parts.end(), holds)) return false;
        own = {SetPart::What::set, false, at};
    }
    return true;
}

Bounds SetTable::inside_bounds(const SetPart& part, const Bodies& bodies) const {
    if (part.what != SetPart::What::set) return part.complement ? Bounds::everything() : bodies.bounds(part.what, part.index);
    const Node& node = nodes_[part.index];
    Bounds box = node.rule == Rule::all ? Bounds::everything() : Bounds();
    for (const SetPart& inner : node.parts) {
        const Bounds one = inside_bounds(inner, bodies);
        if (node.rule == Rule::all)
            box = common(box, one);
        else
            box.extend(one);
    }
    for (const SetPart& clip : node.clips) box = common(box, inside_bounds(clip, bodies));
    return box;
}

void SetTable::narrow(std::uint32_t index, const Bounds& above, const Bodies& bodies) {
    Node& node = nodes_[index];
    node.visible = above;
    for (const SetPart& clip : node.clips) node.visible = common(node.visible, inside_bounds(clip, bodies));
    if (node.rule == Rule::all)
        for (const SetPart& part : node.parts) node.visible = common(node.visible, inside_bounds(part, bodies));
    for (const SetPart& part : node.parts)
        if (part.what == SetPart::What::set) narrow(part.index, node.visible, bodies);
}

void SetTable::find_bounds(const Bodies& bodies) {
    for (const std::uint32_t root : roots_) narrow(root, Bounds::everything(), bodies);
}

}  // namespace rt
