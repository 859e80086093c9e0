// `cutaway_textures`: what parts without a texture show. As measured of POV-Ray; the documentation says little.
#include <algorithm>
#include <unordered_map>

#include "syntax/set_value.h"
#include "syntax/texture_numbers.h"

namespace rt {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// What a set says of its parts. What only clips or bounds says what the set around it does.
struct Around {
    std::uint32_t end = none;    ///< one past its nodes
    std::uint32_t whole = none;  ///< the outermost intersection, whose parts are those that are cut
    bool all = false;
    bool cutaway = false;  ///< it, or a set around it
    bool other = false;    ///< parts without a texture have the one that everything else has
};

class CutTextures {
public:
    CutTextures(Parts& parts, const TextureLayers& other) : parts_(parts), nodes_(parts.set.nodes), other_(other) {}

    void find() {
        find_textured();
        std::vector<Around> open{{}};
        for (std::uint32_t at = 0; at < nodes_.size(); ++at) {
            while (open.back().end <= at) open.pop_back();
            if (nodes_[at].kind == SetNode::Kind::surface)
                find_cut(at, open.back());
            else if (nodes_[at].kind != SetNode::Kind::solid)
                open.push_back(inside(at, open.back()));
        }
    }

    void give() {
        for (const auto& [whole, cutting] : cutting_) give(whole, cutting);
    }

private:
    void find_textured();
    Around inside(std::uint32_t at, const Around& around) const;
    void find_cut(std::uint32_t at, const Around& around);
    void give(std::uint32_t whole, const std::vector<std::uint32_t>& cutting);

    Object& object(std::uint32_t at) { return parts_.objects[nodes_[at].index]; }

    Parts& parts_;
    std::vector<SetNode>& nodes_;
    const TextureLayers& other_;
    std::vector<bool> textured_, cuts_;                                      ///< by node
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> cutting_;  ///< parts that cut, by what they are parts of
};

/// A part whose own parts have textures counts as one with a texture.
void CutTextures::find_textured() {
    cuts_.resize(nodes_.size());
    textured_.resize(nodes_.size());
    for (std::uint32_t at = 0; at < nodes_.size(); ++at)
        if (nodes_[at].kind == SetNode::Kind::surface) textured_[at] = object(at).texture || object(at).shape_textures;
    std::vector<std::uint32_t> open;
    for (std::uint32_t at = 0; at < nodes_.size(); ++at) {
        while (!open.empty() && open.back() + nodes_[open.back()].size <= at) open.pop_back();
        if (textured_[at])
            for (auto set = open.rbegin(); set != open.rend() && !textured_[*set]; ++set) textured_[*set] = true;
        open.push_back(at);
    }
}

Around CutTextures::inside(std::uint32_t at, const Around& around) const {
    const SetNode& node = nodes_[at];
    Around in = around;
    in.end = at + node.size;
    if (node.clips || node.kind == SetNode::Kind::bounded) return in;
    in.all = node.kind == SetNode::Kind::all;
    in.cutaway |= in.all && node.cutaway;
    in.other |= !textured_[at] && !(around.all && around.cutaway);
    if (in.all && in.whole == none) in.whole = at;
    return in;
}

void CutTextures::find_cut(std::uint32_t at, const Around& around) {
    if (textured_[at] || around.other || !around.all || !around.cutaway) return;
    cuts_[at] = true;
    cutting_[around.whole].push_back(at);
}

/// Where only one texture is cut there is nothing to ask at each point.
void CutTextures::give(std::uint32_t whole, const std::vector<std::uint32_t>& cutting) {
    TextureNumbers numbers;
    for (std::uint32_t at = whole + 1; at < whole + nodes_[whole].size; ++at)
        if (nodes_[at].kind == SetNode::Kind::surface && !nodes_[at].taken && !cuts_[at])
            nodes_[at].texture = numbers.number_of(object(at).texture.value_or(other_));
    const Shared<std::vector<TextureLayers>> textures(numbers.take());
    for (const std::uint32_t at : cutting) {
        if (textures->size() == 1) {
            object(at).texture = textures->front();
        } else {
            object(at).shape_textures = textures;
            nodes_[at].cuts = true;
        }
    }
}

}  // namespace

void cut_textures(Parts& parts, const TextureLayers& other) {
    if (std::none_of(parts.set.nodes.begin(), parts.set.nodes.end(), [](const SetNode& node) { return node.cutaway; })) return;
    CutTextures textures(parts, other);
    textures.find();
    textures.give();
}

}  // namespace rt
