#include "syntax/set_value.h"

#include <algorithm>

namespace rt {

namespace {

using NodeKind = SetNode::Kind;

NodeKind root_kind(SetValue::Kind kind) {
    switch (kind) {
        case SetValue::Kind::union_:
        case SetValue::Kind::light:
            return NodeKind::any;
        case SetValue::Kind::merge:
            return NodeKind::merged;
        default:
            return NodeKind::all;
    }
}

SetNode node_of(NodeKind kind) {
    SetNode node;
    node.kind = kind;
    return node;
}

/// Inverts the body whose node is number `at`: by De Morgan's laws, down to its shapes.
void invert(std::vector<Object>& objects, ObjectSet& set, std::size_t at) {
    const std::size_t end = at + set.nodes[at].size;
    while (at < end) {
        SetNode& node = set.nodes[at];
        if (node.clips || node.kind == NodeKind::bounded) {
            const std::size_t body = at + 1;
            if (node.kind == NodeKind::bounded) node.inverse = !node.inverse;
            invert(objects, set, body);
            at += node.size;
            continue;
        }
        if (node.kind == NodeKind::surface)
            objects[node.index].inverse = !objects[node.index].inverse;
        else if (node.kind == NodeKind::solid)
            set.solids[node.index].inverse = !set.solids[node.index].inverse;
        else
            node.kind = node.kind == NodeKind::all ? NodeKind::merged : NodeKind::all;
        ++at;
    }
}

/// Appends the nodes of `part` from number `first` on, and its solids. The objects that they speak of begin at number `first_object`.
void append(ObjectSet& to, ObjectSet part, std::size_t first, std::uint32_t first_object, std::uint32_t first_medium = 0) {
    const auto first_solid = static_cast<std::uint32_t>(to.solids.size());
    for (std::size_t i = first; i < part.nodes.size(); ++i) {
        SetNode node = part.nodes[i];
        if (node.kind == NodeKind::surface) node.index += first_object;
        if (node.kind == NodeKind::solid) node.index += first_solid;
        if (node.medium != 0) node.medium += first_medium;
        to.nodes.push_back(node);
    }
    std::move(part.solids.begin(), part.solids.end(), std::back_inserter(to.solids));
}

/// POV-Ray tests the parts of unions one by one; any other set as a whole, whatever is said of its parts, but for what is not to be seen
/// of a merge.
void hand_down_flags(const Object& whole, SetValue::Kind kind, bool split, Object& part) {
    if (!split) part.no_shadow = false;
    if (!split && kind != SetValue::Kind::merge) part.no_image = part.no_reflection = false;
    part.no_shadow |= whole.no_shadow;
    part.no_image |= whole.no_image;
    part.no_reflection |= whole.no_reflection;
    part.double_illuminate |= whole.double_illuminate;
    part.hollow |= whole.hollow;
    part.uv_mapping |= whole.uv_mapping;
}

/// The interior of the whole, POV-Ray's own if none is stated, is that of the parts without one, which have it in common; so are sets in a
/// union.
void hand_down_interior(const Object& whole, Parts& parts) {
    const std::uint32_t medium = ++parts.media;
    for (Object& part : parts.objects) {
        if (part.interior) continue;
        part.interior = whole.interior;
        part.medium = medium;
    }
    std::vector<SetNode>& nodes = parts.set.nodes;
    const std::size_t last = nodes.front().kind == NodeKind::any ? nodes.size() : 1;
    for (std::size_t i = 0; i < last; i += i == 0 ? 1 : nodes[i].size)
        if (nodes[i].medium == 0) nodes[i].medium = medium;
}

/// What the parts of a set lack they have from the whole.
void hand_down(const SetValue& set, Parts& parts) {
    const bool split = (set.kind == SetValue::Kind::union_ || set.kind == SetValue::Kind::light) && set.split && set.clip.nodes.empty() &&
                       parts.set.nodes.front().kind == NodeKind::any;
    for (Object& part : parts.objects) {
        if (!part.texture) {
            part.texture = set.whole.texture;
            part.interior_texture = set.whole.interior_texture;
        }
        hand_down_flags(set.whole, set.kind, split, part);
    }
    hand_down_interior(set.whole, parts);
}

/// Puts the set and further bodies under one node.
void wrap(ObjectSet& set, SetNode with, ObjectSet by) {
    ObjectSet whole;
    whole.nodes.reserve(1 + set.nodes.size() + by.nodes.size());
    with.medium = set.nodes.front().medium;
    whole.nodes.push_back(with);
    append(whole, std::move(set), 0, 0);
    append(whole, std::move(by), 0, 0);
    whole.nodes.front().size = static_cast<std::uint32_t>(whole.nodes.size());
    set = std::move(whole);
}

void clip(ObjectSet& set, ObjectSet by) {
    SetNode node = node_of(NodeKind::all);
    node.clips = true;
    wrap(set, node, std::move(by));
}

/// A tree of its own with the nodes from `first` to `end`.
ObjectSet separate(const ObjectSet& set, std::size_t first, std::size_t end) {
    ObjectSet tree;
    tree.first_object = set.first_object;
    for (std::size_t i = first; i < end; ++i) {
        tree.nodes.push_back(set.nodes[i]);
        if (set.nodes[i].kind != NodeKind::solid) continue;
        tree.nodes.back().index = static_cast<std::uint32_t>(tree.solids.size());
        tree.solids.push_back(set.solids[set.nodes[i].index]);
    }
    return tree;
}

}  // namespace

SetValue empty_set(SetValue::Kind kind) {
    SetValue set;
    set.kind = kind;
    set.parts.set.nodes.push_back(node_of(root_kind(kind)));
    return set;
}

void add_part(SetValue& set, Parts part, bool inverted) {
    Parts& parts = set.parts;
    if (inverted) {
        invert(part.objects, part.set, 0);
        for (SetNode& node : part.set.nodes) node.taken = true;
    }
    SetNode& root = parts.set.nodes.front();
    const SetNode& top = part.set.nodes.front();
    const std::size_t first = top.kind == root.kind && !top.clips && !top.cutaway ? 1 : 0;  // a union in a union is no node of its own
    root.size += top.size - static_cast<std::uint32_t>(first);
    shift_light_groups(part, parts.light_groups);
    parts.light_groups += part.light_groups;
    append(parts.set, std::move(part.set), first, static_cast<std::uint32_t>(parts.objects.size()), parts.media);
    for (Object& object : part.objects) {
        if (object.medium != 0) object.medium += parts.media;
        parts.objects.push_back(std::move(object));
    }
    parts.media += part.media;
    std::move(part.lights.begin(), part.lights.end(), std::back_inserter(parts.lights));
}

void add_body(ObjectSet& bodies, Parts body) {
    for (SetNode& node : body.set.nodes) {
        if (node.kind != NodeKind::surface) continue;
        Object& object = body.objects[node.index];
        node.kind = NodeKind::solid;
        node.index = static_cast<std::uint32_t>(body.set.solids.size());
        body.set.solids.push_back({std::move(object.shape), std::move(object.transform), object.inverse});
    }
    append(bodies, std::move(body.set), 0, 0);
}

void add_bodies(ObjectSet& bodies, const ObjectSet& further) { append(bodies, further, 0, 0); }

void invert(SetValue& set) { invert(set.parts.objects, set.parts.set, 0); }

Parts resolved(ObjectValue value) {
    if (!value.set) {
        Parts parts;
        parts.objects = std::move(value.objects);
        parts.set.nodes.push_back({});
        return parts;
    }
    SetValue set = std::move(value.set->edit());
    SetNode bounded = node_of(NodeKind::bounded);
    bounded.inverse = set.whole.inverse;
    if (set.kind == SetValue::Kind::clipped_shape) {
        set.parts.objects.push_back(std::move(set.whole));
        set.parts.set.nodes.push_back({});
    } else {
        hand_down(set, set.parts);
    }
    if (!set.clip.nodes.empty()) clip(set.parts.set, std::move(set.clip));
    // What is linked with a clip says nothing more: a ray meets the clip where it meets what is left of the object.
    if (!set.bound.nodes.empty() && !set.linked) wrap(set.parts.set, bounded, std::move(set.bound));
    return std::move(set.parts);
}

Extent extent_of(const ObjectValue& value) {
    if (value.extent) return *value.extent;
    const Object& object = value.set ? (*value.set)->whole : value.objects.front();
    return extent_of(object.shape, object.transform);
}

Bodies bodies_of(Parts parts) {
    Bodies bodies;
    bodies.sets = separate_sets(parts.set);
    bodies.objects = std::move(parts.objects);
    return bodies;
}

bool has_texture(const Parts& parts) {
    return std::any_of(parts.objects.begin(), parts.objects.end(), [](const Object& object) { return object.texture.has_value(); });
}

bool has_patch(const Parts& parts) {
    return !parts.lights.empty() || std::any_of(parts.objects.begin(), parts.objects.end(), [](const Object& object) {
        return is_sheet(object.shape) && !std::holds_alternative<Polygon>(object.shape);
    });
}

void shift_light_groups(Parts& parts, std::uint32_t before) {
    for (Object& object : parts.objects)
        if (object.light_group != 0) object.light_group += before;
    for (Light& light : parts.lights)
        if (light.group != 0) light.group += before;
}

void enclose_in_light_group(Parts& parts, const std::vector<std::size_t>& own_lights, bool global_lights) {
    const std::uint32_t group = ++parts.light_groups;
    for (const std::size_t own : own_lights) parts.lights[own].group = group;
    for (Object& object : parts.objects) {
        if (object.light_group == 0) object.light_group = group;
        if (!object.shows_light) object.own_lights_only = !global_lights;  // whatever groups inside said, as POV-Ray has it
    }
}

std::size_t size_of(const Parts& parts) {
    std::size_t size = parts.objects.size() + parts.set.solids.size() + parts.lights.size();
    for (const Light& light : parts.lights) {
        if (!light.mask) continue;
        size += (*light.mask)->surfaces.size();
        for (const ObjectSet& set : (*light.mask)->sets) size += set.solids.size();
    }
    return size;
}

Mask mask_of(Parts parts) {
    Mask mask;
    for (Object& object : parts.objects) mask.surfaces.push_back({std::move(object.shape), std::move(object.transform), object.inverse});
    mask.sets = separate_sets(parts.set);
    return mask;
}

std::size_t depth(const ObjectSet& set) {
    std::size_t deepest = 0;
    std::vector<std::size_t> open;  // ends of the nodes that are not over yet
    for (std::size_t i = 0; i < set.nodes.size(); ++i) {
        while (!open.empty() && open.back() <= i) open.pop_back();
        open.push_back(i + set.nodes[i].size);
        deepest = std::max(deepest, open.size());
    }
    return deepest;
}

std::vector<ObjectSet> separate_sets(const ObjectSet& set) {
    std::vector<ObjectSet> trees;
    for (std::size_t i = 0; i < set.nodes.size();) {
        const SetNode& node = set.nodes[i];
        if (node.kind == NodeKind::any || node.kind == NodeKind::surface) {
            ++i;
            continue;
        }
        trees.push_back(separate(set, i, i + node.size));
        i += node.size;
    }
    return trees;
}

}  // namespace rt
