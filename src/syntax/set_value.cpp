#include "syntax/set_value.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/texture_layers.h"

namespace rt {

namespace {

std::uint32_t size32(std::size_t n) { return static_cast<std::uint32_t>(n); }

template <typename T>
void move_to_end(std::vector<T>& from, std::vector<T>& to) {
    if (to.empty())
        to = std::move(from);
    else
        to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// A texture that many parts share is moved once.
class MovedTextures {
public:
    MovedTextures(Reader& reader, const Transform& t) : reader_(reader), t_(t) {}
    void move(std::optional<TextureLayers>& layers) {
        if (!layers || !has_any_pattern(*layers)) return;
        const auto known = known_.find(layers->identity());
        if (known != known_.end()) {
            layers = known->second.after;
            return;
        }
        const TextureLayers before = *layers;
        move_layers(reader_, *layers, t_);
        known_.emplace(before.identity(), Pair{before, *layers});
    }

private:
    struct Pair {
        TextureLayers before, after;  ///< the first keeps its address from being another one's
    };
    Reader& reader_;
    const Transform& t_;
    std::unordered_map<const void*, Pair> known_;
};

void move_object(Reader& reader, const Span& place, Object& object, const Transform& t) {
    append(object.transform, t);
    require_finite(reader, place, *object.transform);
}

bool is_patch(const Object& object) {
    return std::holds_alternative<Triangle>(object.shape) || std::holds_alternative<SmoothTriangle>(object.shape) ||
           std::holds_alternative<Mesh>(object.shape);
}

}  // namespace

void renumber(ObjectValue& value, std::size_t objects, std::size_t sets, std::size_t clips) {
    const auto move = [&](SetPart& part) {
        const std::size_t before = part.what == SetPart::What::object ? objects : part.what == SetPart::What::set ? sets : clips;
        part.index += size32(before);
    };
    for (SetNode& node : value.sets) {
        for (SetPart& part : node.parts) move(part);
        for (SetPart& clip : node.clips) move(clip);
    }
    for (Object& object : value.objects)
        if (object.shares_interior) *object.shares_interior += size32(objects);
    if (value.root) move(*value.root);
}

SetPart root_of(const ObjectValue& value) { return value.root.value_or(SetPart{}); }

std::optional<SetPart> add_part(ObjectValue& whole, ObjectValue part) {
    if (!part.root && part.objects.empty()) return std::nullopt;
    hand_down(part);
    part.root = root_of(part);
    renumber(part, whole.objects.size(), whole.sets.size(), whole.clips.size());
    move_to_end(part.objects, whole.objects);
    move_to_end(part.sets, whole.sets);
    move_to_end(part.clips, whole.clips);
    move_to_end(part.lights, whole.lights);
    return part.root;
}

std::optional<SetPart> add_clip(ObjectValue& whole, ObjectValue clip) {
    if (!clip.root && clip.objects.empty()) return std::nullopt;
    // Its objects become clips behind those that it has itself.
    const std::uint32_t behind = size32(clip.clips.size());
    const auto as_clip = [behind](SetPart part) {
        if (part.what == SetPart::What::object) part = {SetPart::What::clip, part.complement, part.index + behind};
        return part;
    };
    for (SetNode& node : clip.sets)
        for (SetPart& part : node.parts) part = as_clip(part);
    clip.root = as_clip(root_of(clip));
    move_to_end(clip.objects, clip.clips);
    clip.objects.clear();
    return add_part(whole, std::move(clip));
}

void transform_parts(Reader& reader, const Span& place, ObjectValue& value, const Transform& t) {
    MovedTextures textures(reader, t);
    for (Object& object : value.objects) {
        move_object(reader, place, object, t);
        textures.move(object.texture);
        textures.move(object.interior_texture);
    }
    for (Object& clip : value.clips) move_object(reader, place, clip, t);
    for (Light& light : value.lights) transform_light(reader, place, light, t);
}

void hand_down(ObjectValue& value) {
    if (!value.root || value.whole.empty()) return;
    std::optional<std::uint32_t> first;
    const Object& whole = value.whole.front();
    for (std::size_t i = 0; i < value.objects.size(); ++i) {
        Object& object = value.objects[i];
        if (!object.texture) {
            object.texture = whole.texture;
            if (!object.interior_texture) object.interior_texture = whole.interior_texture;
        }
        if (whole.interior && !object.interior) {
            object.interior = whole.interior;
            object.shares_interior = first;
            if (!first) first = size32(i);
        }
        object.no_shadow |= whole.no_shadow;
        object.no_image |= whole.no_image;
        object.no_reflection |= whole.no_reflection;
        object.double_illuminate |= whole.double_illuminate;
        object.hollow |= whole.hollow;
    }
    value.whole.clear();
}

bool states_texture(const ObjectValue& value) {
    const auto states = [](const Object& object) { return object.texture || object.interior_texture; };
    return std::any_of(value.whole.begin(), value.whole.end(), states) || std::any_of(value.objects.begin(), value.objects.end(), states);
}

bool has_patch(const ObjectValue& value) { return std::any_of(value.objects.begin(), value.objects.end(), is_patch); }

bool restricts(const ObjectValue& value) {
    if (!value.root) return false;
    const auto is_plain = [](const SetNode& node) {
        return node.kind == SetKind::together && node.clips.empty() &&
               std::none_of(node.parts.begin(), node.parts.end(), [](const SetPart& part) { return part.complement; });
    };
    return value.root->complement || !std::all_of(value.sets.begin(), value.sets.end(), is_plain);
}

}  // namespace rt
